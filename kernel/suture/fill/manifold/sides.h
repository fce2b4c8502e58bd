#pragma once

#include "suture/base/result.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace suture::manifold {

/// A piece of a side: one ribbon and the share of the side's length that it covers.
struct Piece {
    int ribbon = 0;
    double from = 0.0;
    double to = 1.0;
    std::function<double(double s)> along;  ///< length from the ribbon's start over its whole
    /// From where the ribbon starts and ends to where it meets its neighbours halfway: zero in a
    /// model whose edges meet.
    Eigen::Vector3d start_shift = Eigen::Vector3d::Zero();
    Eigen::Vector3d end_shift = Eigen::Vector3d::Zero();

    /// The ribbon's point moved so that neighbours meet.
    [[nodiscard]] Eigen::Vector3d meeting_point(const Eigen::Vector3d& point, double s) const;
};

/// What lies between two corners of the hole: ribbons that run on into each other.
struct Side {
    std::vector<Piece> pieces;
    double length = 0.0;

    /// Where one piece ends and the next begins, as shares of the length.
    [[nodiscard]] std::vector<double> joints() const;
};

/// The sides of a hole, in the order of its loop.
struct Sides {
    std::vector<Side> sides;
    bool ring = false;               ///< no corner at all: one side that goes all the way around
    std::vector<std::string> notes;  ///< corners whose two neighbours disagree
};

/// Splits the loop at its corners: where the interior angle is below 170 degrees.
///
/// Refuses  several loops; a ribbon of no length; a reflex corner; one or two corners.
[[nodiscard]] Result<Sides> find_sides(const Hole& hole);

}  // namespace suture::manifold
