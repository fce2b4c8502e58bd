#include "suture/fill/plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Samples per side: a side that leaves the plane between two of them is found by the check of
/// the finished face.
constexpr int kSamples = 32;

struct Sample {
    const Ribbon* ribbon;
    Vector3d point;
};

std::vector<Sample> sample(const Hole& hole) {
    std::vector<Sample> samples;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k < kSamples; ++k) {
                samples.push_back({&ribbon, ribbon.at(static_cast<double>(k) / kSamples).point});
            }
        }
    }
    return samples;
}

/// Twice the area enclosed by the loops, as a vector along the outward normal: they are walked with
/// the hole on the left.
Vector3d area_vector(const Hole& hole, const Vector3d& centre) {
    Vector3d area = Vector3d::Zero();
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k < kSamples; ++k) {
                const Vector3d a = ribbon.at(static_cast<double>(k) / kSamples).point - centre;
                const Vector3d b = ribbon.at(static_cast<double>(k + 1) / kSamples).point - centre;
                area += a.cross(b);
            }
        }
    }
    return area;
}

}  // namespace

Result<FillResult> fill_plane(const Hole& hole, const FillOptions& options) {
    const std::vector<Sample> samples = sample(hole);
    Vector3d centre = Vector3d::Zero();
    for (const Sample& s : samples) {
        centre += s.point / static_cast<double>(samples.size());
    }
    Matrix3d covariance = Matrix3d::Zero();
    for (const Sample& s : samples) {
        const Vector3d d = s.point - centre;
        covariance += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance);
    Plane plane;
    plane.frame.origin = centre;
    plane.frame.z = axes.eigenvectors().col(0);
    plane.frame.x = axes.eigenvectors().col(2);
    if (plane.frame.z.dot(area_vector(hole, centre)) < 0.0) {
        plane.frame.z = -plane.frame.z;
    }
    plane.frame.y = plane.frame.z.cross(plane.frame.x);

    const auto worst =
        std::max_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
            return std::abs(plane.frame.z.dot(a.point - centre)) <
                   std::abs(plane.frame.z.dot(b.point - centre));
        });
    const double height = std::abs(plane.frame.z.dot(worst->point - centre));
    if (height > options.tolerance.linear) {
        return fail(ErrorCode::Refused,
                    "the hole is not planar: {} leaves the best plane by {:.3g}, more than {:.3g}",
                    name_of(*worst->ribbon), height, options.tolerance.linear);
    }
    Patch patch;
    patch.surface = plane;
    for (const RibbonLoop& loop : hole.loops) {
        std::vector<TrimCurve> trims;
        for (const Ribbon& ribbon : loop.ribbons) {
            trims.emplace_back([surface = patch.surface, at = ribbon.at](double s) {
                return parameters_of(surface, at(s).point);
            });
        }
        patch.wires.push_back(wire_of_loop(static_cast<int>(patch.wires.size()), std::move(trims)));
    }
    FillResult result;
    result.patches.push_back(std::move(patch));
    return result;
}

}  // namespace suture
