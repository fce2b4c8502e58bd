#include "suture/fill/tube/pole.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>

namespace suture::tube {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSamples = 48;  // per side
constexpr int kRounds = 12;

struct Sample {
    Vector3d point;
    Vector3d inwards;  ///< unit: against the radial
    double length;     ///< of the border that it stands for
    bool smooth;       ///< whether the neighbour is to be met tangentially
};

std::vector<Sample> samples_of(const RibbonLoop& loop, const Radials& radials) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        const Ribbon& ribbon = loop.ribbons[i];
        for (int k = 0; k < kSamples; ++k) {
            const double s = (k + 0.5) / kSamples;
            const RibbonPoint at = ribbon.at(s);
            samples.push_back({at.point, -radials.outward(static_cast<int>(i), s, at).normalized(),
                               at.tangent.norm() / kSamples, ribbon.continuity >= Continuity::G1});
        }
    }
    return samples;
}

Vector3d centre_of(const std::vector<Sample>& samples) {
    Vector3d centre = Vector3d::Zero();
    double length = 0.0;
    for (const Sample& s : samples) {
        centre += s.length * s.point;
        length += s.length;
    }
    return centre / length;
}

/// Twice the area around a point, as a vector: along the outward normal, because the loop is walked
/// with the hole on the left.
Vector3d area_around(const std::vector<Sample>& samples, const Vector3d& centre) {
    Vector3d area = Vector3d::Zero();
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const Vector3d a = samples[k].point - centre;
        const Vector3d b = samples[(k + 1) % samples.size()].point - centre;
        area += a.cross(b);
    }
    return area;
}

/// The chord of a circular arc that starts along `inwards` and ends perpendicular to the normal.
Vector3d chord_of(const Sample& sample, const Vector3d& normal, const Vector3d& pole) {
    if (!sample.smooth) {
        return (pole - sample.point).normalized();
    }
    const double rise = normal.dot(sample.inwards);
    const Vector3d level = sample.inwards - rise * normal;
    Vector3d towards = pole - sample.point;
    towards = (towards - normal * normal.dot(towards)).normalized();
    // Where it stands upright, or leans outwards, it has no direction of its own.
    constexpr double kUpright = 0.5;
    if (level.dot(towards) > kUpright) {
        towards = level.normalized();
    }
    // Its slope falls evenly to zero: the chord has half of the first one.
    const double half = 0.5 * std::atan2(rise, level.dot(towards));
    return std::cos(half) * towards + std::sin(half) * normal;
}

/// The point nearest to the chords, as lines.
Vector3d nearest_to_chords(const std::vector<Sample>& samples, const Vector3d& normal,
                           const Vector3d& pole) {
    Matrix3d matrix = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Sample& s : samples) {
        const Vector3d chord = chord_of(s, normal, pole);
        const Matrix3d across = Matrix3d::Identity() - chord * chord.transpose();
        matrix += s.length * across;
        right += s.length * (across * s.point);
    }
    return matrix.ldlt().solve(right);
}

/// The normal of the plane in which circular arcs from the border to the pole arrive.
Vector3d arriving(const std::vector<Sample>& samples, const Vector3d& pole) {
    std::vector<Vector3d> arrivals;
    for (const Sample& s : samples) {
        const Vector3d chord = (pole - s.point).normalized();
        arrivals.push_back(s.smooth ? Vector3d(2.0 * s.inwards.dot(chord) * chord - s.inwards)
                                    : chord);
    }
    Vector3d area = Vector3d::Zero();
    for (std::size_t k = 0; k < arrivals.size(); ++k) {
        area += arrivals[k].cross(arrivals[(k + 1) % arrivals.size()]);
    }
    return area;
}

/// Whether the directions go around the normal once and never back.
bool goes_around(const std::vector<Vector3d>& directions, const Vector3d& normal) {
    double turning = 0.0;
    const std::size_t m = directions.size();
    for (std::size_t j = 0; j < m; ++j) {
        const Vector3d& a = directions[j];
        const Vector3d& b = directions[(j + 1) % m];
        const double turn = std::atan2(normal.dot(a.cross(b)), a.dot(b));
        constexpr double kRounding = 1e-9;
        if (!(turn > -kRounding)) {
            return false;
        }
        turning += turn;
    }
    constexpr double kOnce = 1e-6;
    return std::abs(turning - 2.0 * kPi) < kOnce;
}

std::vector<Vector3d> projected(const Eigen::Matrix3Xd& vectors, const Vector3d& normal) {
    std::vector<Vector3d> directions;
    for (Eigen::Index j = 0; j < vectors.cols(); ++j) {
        const Vector3d v = vectors.col(j);
        directions.push_back((v - normal * normal.dot(v)).normalized());
    }
    return directions;
}

/// The layout's directions in the pole's plane, turned so that they fit the arcs' arrivals best.
std::vector<Vector3d> turned(const Pole& pole, const Eigen::Matrix3Xd& border,
                             const Eigen::Matrix3Xd& tangents, const Eigen::Matrix2Xd& plane) {
    const Vector3d x = pole.normal.unitOrthogonal();
    const Vector3d y = pole.normal.cross(x);
    std::complex<double> turn = 0.0;
    for (Eigen::Index j = 0; j < plane.cols(); ++j) {
        const Vector3d chord = (border.col(j) - pole.point).normalized();
        const Vector3d leaving = tangents.col(j).normalized();
        const Vector3d wanted = 2.0 * leaving.dot(chord) * chord - leaving;
        const std::complex<double> flat(wanted.dot(x), wanted.dot(y));
        turn += flat * std::conj(std::complex<double>(plane(0, j), plane(1, j)));
    }
    turn /= std::abs(turn);
    std::vector<Vector3d> directions;
    for (Eigen::Index j = 0; j < plane.cols(); ++j) {
        const std::complex<double> d = turn * std::complex<double>(plane(0, j), plane(1, j));
        directions.push_back((d.real() * x + d.imag() * y).normalized());
    }
    return directions;
}

}  // namespace

Result<Pole> find_pole(const RibbonLoop& loop, const Radials& radials,
                       const std::optional<Vector3d>& point,
                       const std::optional<Vector3d>& normal) {
    const std::vector<Sample> samples = samples_of(loop, radials);
    // Sides met in position only have no arcs of their own: they leave the point where it begins,
    // which all sides of the layout see.
    Pole pole{point                    ? *point
              : radials.is_developed() ? radials.centre_in_space(loop)
                                       : centre_of(samples),
              Vector3d::Zero()};
    pole.normal = normal.value_or(area_around(samples, pole.point)).normalized();
    for (int round = 0; round < kRounds; ++round) {
        if (!point) {
            pole.point = nearest_to_chords(samples, pole.normal, pole.point);
        }
        if (!normal) {
            const Vector3d area = arriving(samples, pole.point);
            // Of arcs that arrive evenly from all around it is 2 pi.
            constexpr double kLeastArea = 0.1;
            if (!(area.norm() > kLeastArea)) {
                return fail(ErrorCode::Refused,
                            "no plane for the closing point is found: give it with its normal");
            }
            pole.normal = area.normalized();
        }
    }
    return pole;
}

Result<std::vector<Vector3d>> directions_at(const Pole& pole, const Eigen::Matrix3Xd& border,
                                            const Eigen::Matrix3Xd& tangents,
                                            const Eigen::Matrix2Xd& plane) {
    std::vector<std::vector<Vector3d>> candidates;
    if (plane.cols() > 0) {
        candidates.push_back(turned(pole, border, tangents, plane));
    } else {
        candidates.push_back(projected(tangents, pole.normal));
        candidates.push_back(projected(border.colwise() - pole.point, pole.normal));
    }
    for (std::vector<Vector3d>& directions : candidates) {
        if (goes_around(directions, pole.normal)) {
            return std::move(directions);
        }
    }
    return fail(ErrorCode::Refused,
                "seen along the normal ({:.3g}, {:.3g}, {:.3g}) of the closing point, the border "
                "does not go around it once",
                pole.normal.x(), pole.normal.y(), pole.normal.z());
}

}  // namespace suture::tube
