#include "suture/fill/concentric/map.h"

#include "suture/fill/concentric/certificate.h"

#include "kernel/core/concentric/shapes.h"
#include <gtest/gtest.h>

namespace suture::concentric {
namespace {

TEST(ConcentricMap, FoldsOnNoneOfFiveHundredShapes) {
    int refused = 0;
    for (const auto& [name, curve] : shapes::five_hundred()) {
        const auto map = concentric_map(curve);
        if (!map) {
            ++refused;
            std::printf("%s: %s\n", name.c_str(), map.error().message.c_str());
            continue;
        }
        if (map->refinements > 1) {
            std::printf("%s: %d refinements, %d stops\n", name.c_str(), map->refinements,
                        map->axis.count());
        }
    }
    EXPECT_LE(refused, 5);
}

}  // namespace
}  // namespace suture::concentric
