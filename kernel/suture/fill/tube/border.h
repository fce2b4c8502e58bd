#pragma once

#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/tube/course.h"
#include "suture/fill/tube/radials.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace suture::tube {

/// What the tube has to meet at one place of its border.
struct BorderPoint {
    Eigen::Vector3d point;
    Eigen::Vector3d edge;     ///< the point on the neighbour's edge
    Eigen::Vector3d outward;  ///< d: the tube's tangent across the border
    Eigen::Vector3d normal;   ///< of the neighbour
    Eigen::Vector3d tangent;  ///< by the parameter around
    Eigen::Vector2d plane;    ///< where it lies in the layout, if there is one
};

/// The hole's border as the tube's parameters see it: all sides in a row, [0, length) around.
class Border {
  public:
    /// Input    length: of the parameter around; u: at the border.
    Border(RibbonLoop around, Radials radials, const Eigen::Vector3d& pole, double length,
           double u);

    [[nodiscard]] bool has_layout() const { return radials_.is_developed(); }
    [[nodiscard]] int sides() const { return static_cast<int>(courses_.size()); }
    [[nodiscard]] const Ribbon& ribbon(int side) const {
        return loop_.ribbons[static_cast<std::size_t>(side)];
    }
    [[nodiscard]] const Course& course(int side) const {
        return courses_[static_cast<std::size_t>(side)];
    }
    [[nodiscard]] double start(int side) const { return starts_[static_cast<std::size_t>(side)]; }
    [[nodiscard]] double extent(int side) const {
        return starts_[static_cast<std::size_t>(side) + 1] - start(side);
    }
    [[nodiscard]] double s_of(int side, double v) const;
    [[nodiscard]] double v_of(int side, double s) const;
    /// v counts from the side's start. Ends of two sides that differ, because the model's edges or
    /// the neighbours' tangent planes do, are brought together: what that takes is spread over the
    /// whole of either side, so that it leaves no bend.
    [[nodiscard]] BorderPoint at(int side, double v) const;
    /// Where a side begins.
    [[nodiscard]] BorderPoint corner(int side) const { return at(side, 0.0); }
    /// The angle between the border's two directions there.
    [[nodiscard]] double turn(int side) const;
    /// Whether the border has two tangents there, as the parameters see it: a double knot.
    [[nodiscard]] bool is_sharp(int side, const Tolerance& tolerance) const;

  private:
    RibbonLoop loop_;
    Radials radials_;
    Eigen::Vector3d pole_;
    double u_;
    std::vector<Course> courses_;
    std::vector<double> starts_;
    /// What is added to the unit vector away from the pole at both ends of a side that is met in
    /// position only.
    std::vector<std::array<Eigen::Vector3d, 2>> bends_;

    /// What is added to points and outward tangents at both ends of a side.
    struct Shift {
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        Eigen::Vector3d outward = Eigen::Vector3d::Zero();
        Eigen::Vector2d plane = Eigen::Vector2d::Zero();
    };
    std::vector<std::array<Shift, 2>> shifts_;

    [[nodiscard]] Eigen::Vector3d outward(int side, double s, const RibbonPoint& at) const;
    void bring_together(int side);
};

}  // namespace suture::tube
