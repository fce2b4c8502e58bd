#pragma once

#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace suture::manifold {

/// Derivatives at a node: d[a][b] = d^(a+b) / du^a dv^b, a, b <= 2.
using NodeJet = std::array<std::array<Eigen::Vector3d, 3>, 3>;

/// The biquintic spline with given derivatives up to the second in u and in v at every node of a
/// grid, one set for each of the four cells around a node.
///
/// The jets of one node agree up to the order `smoothness` (0, 1 or 2) in u and in v; inner knots
/// have multiplicity 5 - smoothness.
class HermiteNet {
  public:
    HermiteNet(std::vector<double> breaks, int smoothness);

    [[nodiscard]] int nodes() const { return static_cast<int>(breaks_.size()); }
    [[nodiscard]] double at(int i) const { return breaks_[static_cast<std::size_t>(i)]; }
    /// side_u, side_v: -1 or +1, the cell seen from the node.
    [[nodiscard]] NodeJet& jet(int i, int j, int side_u, int side_v) {
        return jets_[slot(i, j, side_u, side_v)];
    }
    [[nodiscard]] SplineSurface spline() const;

  private:
    std::vector<double> breaks_;
    int smoothness_;
    std::vector<NodeJet> jets_;

    [[nodiscard]] std::size_t slot(int i, int j, int side_u, int side_v) const {
        return static_cast<std::size_t>(4 * (i + nodes() * j) + (side_u > 0 ? 1 : 0) +
                                        (side_v > 0 ? 2 : 0));
    }
};

}  // namespace suture::manifold
