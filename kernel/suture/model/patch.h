#pragma once

#include "suture/model/continuity.h"
#include "suture/model/implicit_form.h"
#include "suture/model/surface.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Where a ribbon runs in a patch's domain: (u, v) as a function of the ribbon's own s in [0,1].
using TrimCurve = std::function<Eigen::Vector2d(double s)>;

/// Where a patch that goes all the way around its surface is cut open: along a straight line of the
/// domain, which the face uses as an edge twice, from a corner of one loop to a corner of another
/// or to a pole, where the surface shrinks to a point.
///
///           other_corner <---- other_loop -----
///     to +------------------------------------+ to + period
///        |               hole                 |
///   from +------------------------------------+ from + period
///          ------------- loop ---------> corner
struct Seam {
    int loop = 0;
    int corner = 0;       ///< the seam starts where ribbon `corner` of `loop` starts
    int other_loop = -1;  ///< -1: the seam ends in a pole
    int other_corner = 0;
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    Eigen::Vector2d period = Eigen::Vector2d::Zero();  ///< to the seam's other place in the domain
};

/// Where an inner edge starts or ends: in a corner of the hole, or in a vertex of its own.
struct Node {
    int loop = -1;  ///< where ribbon `index` of this loop starts; -1: inner vertex `index`
    int index = 0;
};

/// An edge that a fill adds between its patches, or along which a closed patch meets itself.
struct InnerEdge {
    Node from, to;
};

/// One edge of a patch's outline.
struct EdgeUse {
    int loop = -1;           ///< ribbon `index` of this loop; -1: inner edge `index`
    int index = 0;           ///< 0-based
    bool backwards = false;  ///< walked from its end to its start; never a ribbon
    /// (u, v) for the edge's own s in [0,1], which runs from its start to its end either way. Both
    /// patches of an inner edge have the same point at the same s.
    TrimCurve at;
    /// The outline goes on along a border of the domain that is one point, to where the next use
    /// starts.
    bool pole_after = false;
};

/// One surface trimmed by the hole's loops, or by an outline of sides and inner edges.
struct Patch {
    Surface surface;
    bool reversed = false;   ///< the outward normal is -(X_u x X_v)
    bool exact = true;       ///< false where the surface approximates the method's own form
    double fit_error = 0.0;  ///< of that approximation, in model units
    /// trims[l][i]: where ribbon i of loop l runs in the surface's domain; the interior lies to its
    /// left, or to its right where `reversed`.
    std::vector<std::vector<TrimCurve>> trims;
    /// pole_corners[l]: corners of loop l that lie in a pole, a border of the domain that is one
    /// point; the trims go along it there, from the end of one side to the start of the next.
    std::vector<std::vector<int>> pole_corners;
    /// Set where two loops, or one loop and a pole, bound a band. trims[seam->loop] then runs from
    /// seam->from at the seam's corner to from + period, trims[seam->other_loop] from to + period
    /// to `to`; all other loops lie between the two places of the seam.
    std::optional<Seam> seam;
    /// Of a patch that is not alone: its wires, the outer one first, in place of trims,
    /// pole_corners and seam. The interior lies to the left of each, or to the right where
    /// `reversed`. An inner edge that is used twice by one patch, once backwards, is a seam.
    std::vector<std::vector<EdgeUse>> wires;
};

/// What a fill method made of a hole.
struct FillResult {
    std::vector<Patch> patches;  ///< each has an edge of the hole or of a patch before it
    std::vector<Eigen::Vector3d> inner_vertices;
    std::vector<InnerEdge> inner_edges;
    std::optional<ImplicitForm> implicit;  ///< of a method that has one
    std::vector<std::string> notes;  ///< what the user should know: relaxed corners, chosen counts
};

}  // namespace suture
