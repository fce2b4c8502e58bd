#pragma once

#include "suture/check/certify/bezier_piece.h"
#include "suture/check/certify/taylor_model.h"

#include <array>
#include <vector>

namespace suture::certify {

/// The points of [-1, 1] at which a stretch's nodes are sampled, in rising order.
[[nodiscard]] const std::vector<double>& path_points();

/// One parameter of a surface along a stretch, in units of a box around it.
struct Path {
    Span box;
    TaylorModel model;                     ///< in [-1, 1] of the box
    double low = 0.0, high = 0.0;          ///< the domain in these units
    bool at_low = false, at_high = false;  ///< runs along the domain's border
    double outside = 0.0;                  ///< how far it leaves the domain
    std::vector<int> spans;                ///< k with knots[k] < knots[k + 1] that the box touches
    std::vector<Span> span_ranges;         ///< in these units

    [[nodiscard]] double reach() const { return model.range().magnitude(); }
    /// A point no farther than this from the path may lie in the span.
    [[nodiscard]] bool may_be_in(std::size_t span, double distance) const {
        const Interval range = model.range();
        return range.low - distance <= span_ranges.at(span).high &&
               range.high + distance >= span_ranges.at(span).low;
    }
};

/// The polynomial through the nodes; along the domain's border where they lie mostly outside.
///
/// Input  knots of a surface that is smooth between them, with full ends; ends_in_a_point: its
///        sides at the low and the high end are collapsed; along_pole: one of the others is.
[[nodiscard]] Path make_path(const std::vector<double>& nodes, const std::vector<double>& knots,
                             int degree, const std::array<bool, 2>& ends_in_a_point,
                             bool along_pole);

/// The part of a gradient that a minimum inside the domain would not have: at its border only what
/// would lead inwards.
[[nodiscard]] double projected(const Interval& gradient, const Path& path);

}  // namespace suture::certify
