#include "suture/model/patch.h"

#include <utility>

namespace suture {

std::vector<EdgeUse> wire_of_loop(int loop, std::vector<TrimCurve> trims) {
    std::vector<EdgeUse> wire;
    wire.reserve(trims.size());
    for (TrimCurve& trim : trims) {
        wire.push_back({loop, static_cast<int>(wire.size()), false, std::move(trim)});
    }
    return wire;
}

}  // namespace suture
