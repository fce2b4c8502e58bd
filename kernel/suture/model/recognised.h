#pragma once

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace suture {

/// A surface that was known again: the one that the lost face had.
struct Recognised {
    std::string kind;  ///< "torus", "rolling ball", ...
    /// "major radius" and others, in model units and degrees
    std::vector<std::pair<std::string, double>> parameters;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of a closed form: origin of its frame
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();   ///< and its z; zero: it has none
    std::string from;                                 ///< what told it
    double gap = 0.0;    ///< largest distance of the border from it, in model units
    double angle = 0.0;  ///< largest median angle of its tangent sides, in radians
};

}  // namespace suture
