#pragma once

#include "suture/fill/extend/chart.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace suture::extend {

/// A loop in the domain, unwrapped: continuous, but for the ways along poles that it passes.
struct Trace {
    std::vector<std::vector<Eigen::Vector2d>> sides;    ///< samples, evenly spaced in s
    Eigen::Vector2i winding = Eigen::Vector2i::Zero();  ///< periods from its start to its end
    std::vector<int> pole_corners;  ///< where it goes along a pole to the start of that side

    [[nodiscard]] Eigen::Vector2d low() const;
    [[nodiscard]] Eigen::Vector2d high() const;
    [[nodiscard]] Eigen::Vector2d centre() const { return 0.5 * (low() + high()); }
    /// Enclosed, positive counterclockwise.
    [[nodiscard]] double area() const;
    void shift(const Eigen::Vector2d& by);
    /// Calls with the ends of each piece of the polygon, from side to side too.
    void for_each_piece(
        const std::function<void(const Eigen::Vector2d&, const Eigen::Vector2d&)>& call) const;
};

/// Where a loop's samples lie, up to periods, side by side.
using Samples = std::vector<std::vector<Eigen::Vector2d>>;

[[nodiscard]] Samples sample_loop(const Chart& chart, const RibbonLoop& loop);

/// Input    reversed: the outward normal is -(X_u x X_v), so the hole lies to the right in the
///          domain.
[[nodiscard]] Trace unwrap(const Chart& chart, const Samples& samples, bool reversed);

/// The trimming curve of a ribbon whose samples were unwrapped to `side`.
[[nodiscard]] TrimCurve trim_of(const std::shared_ptr<const Chart>& chart, const Ribbon& ribbon,
                                const std::vector<Eigen::Vector2d>& side);

}  // namespace suture::extend
