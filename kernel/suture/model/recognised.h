#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace suture {

/// The congruent face by which a lost one was known again.
struct TwinSource {
    int face = 0;  ///< FaceN
    /// Lays it where the lost face was; a mirror image has the determinant -1.
    Eigen::Isometry3d onto = Eigen::Isometry3d::Identity();
};

/// A surface that was known again: the one that the lost face had.
struct Recognised {
    std::string kind;  ///< "torus", "rolling ball", ...
    /// "major radius" and others, in model units and degrees
    std::vector<std::pair<std::string, double>> parameters;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of a closed form: origin of its frame
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();   ///< and its z; zero: it has none
    std::string from;                                 ///< what told it
    std::optional<TwinSource> twin;                   ///< whose copy it is
    double gap = 0.0;    ///< largest distance of the border from it, in model units
    double angle = 0.0;  ///< largest median angle of its tangent sides, in radians
};

}  // namespace suture
