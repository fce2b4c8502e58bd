#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace suture {

/// One polynomial, and where it holds: in cones of rays from the form's centre, each the
/// combinations of its three columns with factors that are not negative.
struct ImplicitCell {
    std::string polynomial;  ///< in x, y, z with 17 digits
    std::vector<Eigen::Matrix3d> cones;
};

/// The form g = 0 that a fill of piecewise polynomials has beside its patches. Its coordinates are
/// (p - origin) / size for a point p of the model, in which the hole is about as large as the unit
/// ball.
struct ImplicitForm {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double size = 1.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    int degree = 0;
    std::vector<ImplicitCell> cells;
};

}  // namespace suture
