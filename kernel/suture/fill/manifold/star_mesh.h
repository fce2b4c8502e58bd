#pragma once

#include "suture/base/result.h"
#include "suture/fill/manifold/star.h"

#include <Eigen/Core>

#include <vector>

namespace suture::manifold {

/// A polygon mesh; faces hold 0-based vertices.
struct PolygonMesh {
    Eigen::Matrix3Xd vertices;
    std::vector<std::vector<int>> faces;
};

/// A control mesh M: layers of quads around an n-sided hole.
struct StarMesh {
    PolygonMesh mesh;
    int layers = 0;            ///< s': intervals from the hole to the outer border
    std::vector<int> columns;  ///< r'_m: intervals along side m of the hole
    /// grids[m]: the vertices of side m, i (outwards) fastest, (s' + 1) x (2 s' + r'_m + 1).
    std::vector<std::vector<int>> grids;

    /// Layers and columns of X for a patch of order k.
    [[nodiscard]] StarSize size(int k, double aperture) const;
    /// The control points in the star's own order; the star has been made of size().
    [[nodiscard]] Eigen::Matrix3Xd points(const Star& star) const;
};

/// Recognises the sides of a star-shaped mesh. The hole may be empty or one polygon.
///
/// Refuses  faces that are no quads, that disagree in their orientation or meet three at an edge; a
///          vertex whose valence has no place in such a mesh; a mesh without its hole; rows that do
///          not lie around it layer by layer. Vertices are named by their 1-based number.
[[nodiscard]] Result<StarMesh> recognise_star(PolygonMesh mesh);

}  // namespace suture::manifold
