#pragma once

#include "suture/model/patch.h"

#include <vector>

namespace suture::manifold {

/// The patches of a star's middle, however they are cut: what lay_out() puts the strips around.
struct Middle {
    /// An inner edge that lies where the border zone of a side begins; its s rises with y.
    struct Outer {
        int edge = 0;
        double from = 0.0;  ///< y
        double to = 0.0;
        bool backwards = false;  ///< the edge's own s falls with y
    };

    std::vector<Eigen::Vector3d> vertices;
    std::vector<InnerEdge> edges;           ///< between `vertices`
    std::vector<Patch> patches;             ///< whose wires use `edges` alone
    std::vector<std::vector<Outer>> outer;  ///< of side m, from its lower end to its upper end
    std::vector<int> corners;               ///< K_m: the vertex where the sides m and m + 1 meet
};

}  // namespace suture::manifold
