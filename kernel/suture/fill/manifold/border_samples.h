#pragma once

#include "suture/fill/manifold/border_fit.h"

#include <Eigen/Core>

#include <vector>

namespace suture::manifold {

/// A sample of a ribbon and where it lies on the border.
struct Sample {
    const Ribbon* ribbon = nullptr;
    std::size_t side = 0;
    double share = 0.0;  ///< of the side's length
    RibbonPoint wanted;
    BorderRow row;
    double weight = 0.0;
};

/// S, S_x, S_y, S_xx at a sample, for these control points.
[[nodiscard]] Eigen::Matrix3Xd derivatives(const Sample& sample, const Eigen::Matrix3Xd& points);

/// Samples in every knot interval, `offset` of their distance from its start; all count the same,
/// so that short intervals next to corners are fitted as well as long ones.
[[nodiscard]] std::vector<Sample> samples_of(const BorderModel& model, const Hole& hole,
                                             const Sides& sides, double offset);

}  // namespace suture::manifold
