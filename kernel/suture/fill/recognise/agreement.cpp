#include "suture/fill/recognise/agreement.h"

#include "suture/base/tolerance.h"
#include "suture/fill/recognise/form.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// Right surfaces of clean files come within this; where the file is worse, within three times its
/// noise, at most twice as far; where it is much worse, within 1.5 times its noise.
constexpr double kGap = 3e-5;
constexpr double kGapOfNoisy = 6e-5;
constexpr double kNoisy = 4e-5;

/// A side is tangent if its median angle is within this, and enough of the border has to be.
constexpr double kAngle = radians(0.1);
constexpr double kTangent = 0.6;

/// A rough side may lie off by so many times what its edge misses its own neighbour by.
constexpr double kOfRough = 1.5;

/// What lies within so many times the noise is explained by it.
constexpr double kWithin = 3.0;

/// Of an edge that misses its faces by some noise the normals are off by so many times more, in
/// radians: it waves ten to twenty times along the hole.
constexpr double kAngleOfNoise = 20.0;

/// So much of the border has to lie on a surface to within the noise, in position and normal.
constexpr double kExact = 0.4;

/// Numbers that are as plain by chance in one of so many cases say something.
constexpr double kChance = 0.01;

/// A border that leaves its plane by less than this share of its diameter is flat.
constexpr double kFlat = 3e-3;

/// Within these a plane explains a border as well; then the surface has to be so much better.
constexpr double kPlaneAngle = radians(5.0);
constexpr double kBetterThanPlane = 100.0;

/// The plane nearest to the border.
Surface plane_of(const Border& border) {
    const Vector3d mean = border.points.rowwise().mean();
    const Eigen::Matrix3Xd d = border.points.colwise() - mean;
    const Eigen::Matrix3d S = d * d.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
    return Plane{frame_along(mean, eigen.eigenvectors().col(0))};
}

/// Of angles to the normal of the best plane, the median over the border; and the plane's gap.
std::pair<double, double> flatness(const Border& border) {
    const Surface plane = plane_of(border);
    const Vector3d z = frame_of(plane).z;
    std::vector<double> angles;
    double gap = 0.0;
    for (Eigen::Index k = 0; k < border.points.cols(); ++k) {
        const Vector3d n = border.normals.col(k);
        angles.push_back(std::atan2(n.cross(z).norm(), std::abs(n.dot(z))));
        gap = std::max(gap, std::abs(distance_to(plane, border.points.col(k)).value));
    }
    std::nth_element(angles.begin(), angles.begin() + angles.size() / 2, angles.end());
    return {gap, angles[angles.size() / 2]};
}

}  // namespace

Agreement measure(const FootFinder& foot, const Border& border) {
    Agreement result;
    double length = 0.0;
    double tangent_length = 0.0;
    double exact_length = 0.0;
    int tangent_sides = 0;
    int exact_sides = 0;
    const double exact_gap = kWithin * border.noise;
    const double exact_angle = std::min(kAngle, kAngleOfNoise * exact_gap);
    for (const Side& side : border.sides) {
        std::array<double, Border::kSamples> angles{};
        int along = 0;
        double gap = 0.0;
        for (int k = 0; k < Border::kSamples; ++k) {
            const Foot f = foot(border.origin + border.size * border.points.col(side.first + k));
            const Vector3d n = border.normals.col(side.first + k);
            const double cosine = f.normal.dot(n);
            along += cosine > 0.0 ? 1 : -1;
            angles[static_cast<std::size_t>(k)] =
                std::atan2(f.normal.cross(n).norm(), std::abs(cosine));
            gap = std::max(gap, f.distance / border.size);
        }
        length += side.length;
        if (side.rough > 0.0) {
            result.rough = std::max(result.rough, gap / side.rough);
            continue;
        }
        result.gap = std::max(result.gap, gap);
        std::nth_element(angles.begin(), angles.begin() + Border::kSamples / 2, angles.end());
        const double median = angles[Border::kSamples / 2];
        if (median <= kAngle) {
            result.angle = std::max(result.angle, median);
            tangent_length += side.length;
            ++tangent_sides;
            ++(along > 0 ? result.outward : result.inward);
            result.faces.push_back(side.ribbon->face);
        }
        if (gap <= exact_gap && median <= exact_angle) {
            exact_length += side.length;
            ++exact_sides;
        }
    }
    const auto sides = static_cast<double>(border.sides.size());
    result.tangent = std::max(tangent_length / length, tangent_sides / sides);
    result.exact = std::max(exact_length / length, exact_sides / sides);
    return result;
}

Agreement measure(const Surface& form, const Border& border) {
    Agreement result = measure(
        [&](const Vector3d& point) {
            const Distance d = distance_to(form, border.to_local(point));
            return Foot{std::abs(d.value) * border.size, d.normal};
        },
        border);
    result.plane = std::holds_alternative<Plane>(form);
    return result;
}

bool is_flat(const Border& border) {
    return flatness(border).first < kFlat;
}

double largest_gap(const Border& border) {
    if (border.noise > kTooNoisy) {
        return 0.0;
    }
    return border.noise > kNoisy ? 1.5 * border.noise
                                 : std::max(kGap, std::min(kWithin * border.noise, kGapOfNoisy));
}

Result<void> believe(const Agreement& agreement, const Border& border, const Evidence& evidence) {
    const double limit = std::max(largest_gap(border), evidence.allowed);
    if (!(agreement.gap <= limit)) {
        return fail(ErrorCode::Refused,
                    "the border lies off by {:.2g} of the hole's diameter, limit {:.2g}",
                    agreement.gap, limit);
    }
    const bool explained = agreement.gap <= std::max(kWithin * border.noise, evidence.allowed);
    const bool known = evidence.of_model || evidence.allowed > 0.0;
    if (agreement.rough > kOfRough) {
        return fail(ErrorCode::Refused,
                    "a side whose edge misses its own neighbour lies off by {:.2g} times as much, "
                    "limit {:.2g}",
                    agreement.rough, kOfRough);
    }
    if (agreement.rough > 0.0 && !known && evidence.chance > kChance) {
        return fail(ErrorCode::Refused,
                    "a side says nothing because its edge misses its own neighbour, and no plain "
                    "number speaks for the surface");
    }
    const double tangent = explained && !known ? kExact : kTangent;
    if (!evidence.of_model && agreement.tangent < tangent) {
        return fail(ErrorCode::Refused,
                    "{:.0f} % of the border is tangent to its neighbours, limit {:.0f} %",
                    100.0 * agreement.tangent, 100.0 * tangent);
    }
    if (agreement.exact < kExact && !(known && explained)) {
        return fail(ErrorCode::Refused,
                    "{:.0f} % of the border fits to within the model's noise ({:.2g} of the "
                    "hole's diameter), limit {:.0f} %",
                    100.0 * agreement.exact, border.noise, 100.0 * kExact);
    }
    if (!known && !explained && evidence.chance > kChance) {
        return fail(ErrorCode::Refused,
                    "the border lies off by {:.2g} of the hole's diameter, more than the model's "
                    "noise of {:.2g}, and no plain number speaks for it",
                    agreement.gap, border.noise);
    }
    const int turned = std::min(agreement.outward, agreement.inward);
    const bool outside_known = evidence.twin && agreement.outward != agreement.inward;
    if (turned > 0 && !outside_known) {
        return fail(ErrorCode::Refused,
                    "{} of the {} tangent sides have their neighbour's outside on the other side",
                    turned, agreement.outward + agreement.inward);
    }
    if (evidence.of_model) {
        return {};
    }
    const auto [gap, angle] = flatness(border);
    if (!agreement.plane && angle < kPlaneAngle && agreement.gap > gap / kBetterThanPlane &&
        agreement.angle > angle / kBetterThanPlane) {
        return fail(ErrorCode::Refused,
                    "the border is so nearly flat ({:.2g} of its diameter) that the fit says "
                    "nothing",
                    gap);
    }
    return {};
}

}  // namespace suture::recognise
