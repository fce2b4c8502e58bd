#pragma once

#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::recognise {

/// One side of a hole among the samples.
struct Side {
    const Ribbon* ribbon = nullptr;
    int loop = 0;
    int first = 0;        ///< of its samples
    double length = 0.0;  ///< as a share of the hole's diameter
    /// Above 0: its edge lies so far off its own neighbour, as a share of the diameter, that the
    /// side says nothing of the lost surface.
    double rough = 0.0;
};

/// Models less exact than this do not tell right surfaces from wrong ones.
inline constexpr double kTooNoisy = 2.5e-4;

/// The hole's border as evenly spaced samples in coordinates (p - origin) / size, in which the hole
/// is about as large as the unit ball.
struct Border {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double size = 1.0;
    Eigen::Matrix3Xd points;
    Eigen::Matrix3Xd normals;  ///< unit, of the neighbours, outward
    std::vector<Side> sides;
    double noise = 0.0;     ///< how exact the model is here, as a share of `size`
    double rounding = 0.0;  ///< what a coordinate of the model is good to

    static constexpr int kSamples = 24;  ///< a side

    [[nodiscard]] int count() const { return static_cast<int>(points.cols()); }
    [[nodiscard]] Eigen::Vector3d to_local(const Eigen::Vector3d& p) const {
        return (p - origin) / size;
    }
    /// All points, in model units.
    [[nodiscard]] Eigen::Matrix3Xd model_points() const {
        return (size * points).colwise() + origin;
    }
    /// A closed form of the model in the border's coordinates, and back.
    [[nodiscard]] Surface to_local(const Surface& surface) const;
    [[nodiscard]] Surface to_model(const Surface& surface) const;
};

/// The samples, which keep away from the corners, and then the corners, in model units.
[[nodiscard]] Eigen::Matrix3Xd with_corners(const Border& border);

/// The same without its rough sides: what surfaces are fitted to.
[[nodiscard]] Border exact_part(const Border& border);

/// Input    noise: how far the model's edges lie off its faces here, in model units, and that of
///          each side. Where at least two sides are exact enough, those that are not are `rough`
///          and no part of the noise. How far the sides miss each other at corners is measured
///          besides.
[[nodiscard]] Border border_of(const Hole& hole, double noise = 0.0,
                               const std::vector<double>& of_sides = {});

}  // namespace suture::recognise
