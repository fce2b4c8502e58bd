#pragma once

#include "suture/base/result.h"
#include "suture/fill/loft/rail.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace suture::loft {

/// A tangent vector of a neighbour in the frame of its ribbon.
struct LoftLeaving {
    double inward = 0.0;
    double along = 0.0;
};

/// Where a span ends: along a side of the hole without a face, or along an inner edge.
struct LoftEnd {
    std::optional<std::size_t> side;
    int edge = -1;
    LoftLeaving from, to;  ///< how the surface leaves the rails there
};

/// What lies between two rails from one corner to the next, or all around.
struct LoftSpan {
    Rail from, to;           ///< `to` runs against its loop, so that both go the same way
    LoftEnd begin, end;      ///< at u = 0 and u = 1
    double shift = 0.0;      ///< the point u of `from` faces the point u - shift of `to`
    bool closed = false;     ///< all around, without corners
    bool free_from = false;  ///< the rail has no neighbour to be tangent to
    bool free_to = false;
    double tension = 1.0;  ///< all around: how far the tangents reach, 1 as far as the gap is wide

    /// The parameters that the surface needs: those of both rails.
    [[nodiscard]] std::pair<double, double> range() const;

    /// The Bezier points across at u, one below the other.
    [[nodiscard]] Eigen::VectorXd column(double u) const;
};

/// How a hole is bridged.
struct LoftLayout {
    std::vector<LoftSpan> spans;
    std::vector<InnerEdge> inner_edges;
};

/// Finds the two sides that are bridged and the corners that face each other.
///
/// Input    tension: how far the tangents at both sides reach, 1 as far as the gap is wide; but for
///          those at free sides, which are what these are.
/// Refuses  a hole that is no bridge: of one loop, anything but two chains of sides with one free
///          curve between each two ends; of two, rims with different numbers of corners.
[[nodiscard]] Result<LoftLayout> lay_out(const Hole& hole, double tension);

}  // namespace suture::loft
