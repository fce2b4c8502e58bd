#include "suture/fill/mvs/remember.h"

#include <gtest/gtest.h>

#include <memory>

namespace suture::mvs {
namespace {

// Two loops of one ribbon each that count what they are asked.
Hole counted(const std::shared_ptr<int>& count) {
    Hole hole;
    hole.diameter = 3.0;
    for (const double height : {1.0, 2.0}) {
        Ribbon ribbon;
        ribbon.edge = static_cast<int>(height);
        ribbon.at = [count, height](double s) {
            ++*count;
            RibbonPoint point{};
            point.point = Eigen::Vector3d(s, s * s, height);
            return point;
        };
        RibbonLoop loop;
        loop.ribbons.push_back(ribbon);
        hole.loops.push_back(loop);
    }
    return hole;
}

TEST(Remember, AsksARibbonOnceForEachPoint) {
    const auto count = std::make_shared<int>(0);
    const Hole hole = remember(counted(count));
    for (int k = 0; k < 3; ++k) {
        for (const double s : {0.0, 0.3, 1.0}) {
            EXPECT_EQ(hole.loops[0].ribbons[0].at(s).point, Eigen::Vector3d(s, s * s, 1.0));
            EXPECT_EQ(hole.loops[1].ribbons[0].at(s).point, Eigen::Vector3d(s, s * s, 2.0));
        }
    }
    EXPECT_EQ(*count, 6);
}

TEST(Remember, KeepsWhatElseIsSaidOfTheHole) {
    const Hole hole = remember(counted(std::make_shared<int>(0)));
    EXPECT_EQ(hole.diameter, 3.0);
    EXPECT_EQ(hole.loops[1].ribbons[0].edge, 2);
}

}  // namespace
}  // namespace suture::mvs
