#pragma once

#include "suture/fill/concentric/sites.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// A point of the medial axis: the centre of an inscribed circle.
struct MedialNode {
    Eigen::Vector2d point;
    double radius = 0.0;  ///< 0 at a convex corner, where a seam begins
};

/// The walk around the medial axis comes by a node, in the Voronoi cell of a side or of a reflex
/// vertex.
struct Visit {
    int node = 0;
    int site = 0;            ///< the side or vertex whose cell it is
    bool at_vertex = false;  ///< whether that is a reflex vertex
    /// In a side's cell the boundary's parameter at the foot of the perpendicular; in a vertex's
    /// the fraction of the way from the normal of the side before to that of the side after, by
    /// angle.
    double place = 0.0;
};

/// The medial axis of a simple polygon, as the walk around it: the boundaries of the Voronoi cells
/// one after the other, each edge of the axis once in each direction.
struct MedialAxis {
    std::vector<MedialNode> nodes;
    std::vector<Visit> walk;  ///< cyclic, in the direction of increasing parameter
};

/// Nodes nearer to each other than this, in cells of the grid, are one. The grid's own rounding is
/// 1/2, but where many sides are as far from one point, as in stars and gears, their bisectors meet
/// at small angles, and nodes that are one spread over a hundred times as much.
inline constexpr double kSamePlace = 200.0;

/// The segment Voronoi diagram's part inside of the polygon. Its parabolas become chords.
///
/// Input    widest: the angle under which a chord of a parabola may be seen from the vertex, in
///          radians; below pi it never hides the vertex from the axis. same_place: in grid cells.
/// Refuses  a diagram that is not the tree it should be: a sign of rounding.
/// Source   Martin & Cohen 2003, section 3; the diagram is Boost.Polygon's.
[[nodiscard]] Result<MedialAxis> medial_axis(const Sites& sites, double widest,
                                             double same_place = kSamePlace);

}  // namespace suture::concentric
