#include "suture/fill/tube/pole.h"

#include "suture/base/tolerance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::tube {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kSamples = 48;  // per side

/// The pole is moved so that it is seen at this angle (its sine) from every side, if it can be; at
/// the least one of them a hole is not star-shaped.
constexpr double kSeen[] = {0.3, 0.1, 0.03, 0.01};
constexpr int kMostMoves = 400;

constexpr int kRounds = 6;

struct Sample {
    const Ribbon* ribbon;
    RibbonPoint at;
    double length;  ///< of the border that it stands for
};

std::vector<Sample> samples_of(const RibbonLoop& loop) {
    std::vector<Sample> samples;
    for (const Ribbon& ribbon : loop.ribbons) {
        for (int k = 0; k < kSamples; ++k) {
            const RibbonPoint at = ribbon.at((k + 0.5) / kSamples);
            samples.push_back({&ribbon, at, at.tangent.norm() / kSamples});
        }
    }
    return samples;
}

Vector3d centre_of(const std::vector<Sample>& samples) {
    Vector3d centre = Vector3d::Zero();
    double length = 0.0;
    for (const Sample& s : samples) {
        centre += s.length * s.at.point;
        length += s.length;
    }
    return centre / length;
}

/// The loop is walked with the hole on the left: its area vector points outwards.
Vector3d area_vector(const std::vector<Sample>& samples, const Vector3d& centre) {
    Vector3d area = Vector3d::Zero();
    for (const Sample& s : samples) {
        area += (s.at.point - centre).cross(s.at.tangent) / kSamples;
    }
    return area;
}

bool joins_smoothly(const Ribbon& ribbon) {
    return ribbon.continuity >= Continuity::G1;
}

/// How high above a border point a circular arc is that leaves it tangentially to its neighbour
/// towards the axis, and is parallel to the plane of the pole on the axis.
double arc_height(const Sample& s, const Vector3d& foot, const Vector3d& normal) {
    Vector3d inwards = foot - s.at.point;
    inwards -= normal * normal.dot(inwards);
    const double distance = inwards.norm();
    const double base = normal.dot(s.at.point - foot);
    if (!(distance > 0.0) || !joins_smoothly(*s.ribbon)) {
        return base;
    }
    inwards /= distance;
    // In the upright plane through the axis, where it cuts the neighbour's tangent plane.
    Vector3d along = s.at.normal.cross(normal.cross(inwards));
    if (along.dot(s.at.inward) < 0.0) {
        along = -along;
    }
    const double slope = std::atan2(along.dot(normal), along.dot(inwards));
    constexpr double kSteepest = radians(150.0);
    return base + distance * std::tan(0.5 * std::clamp(slope, -kSteepest, kSteepest));
}

/// The normal of the plane in which circular arcs from the border arrive at the point.
Vector3d arriving(const std::vector<Sample>& samples, const Vector3d& point,
                  const Vector3d& outwards) {
    Matrix3d moments = Matrix3d::Zero();
    for (const Sample& s : samples) {
        const Vector3d chord = (point - s.at.point).normalized();
        Vector3d leaving = chord;
        if (joins_smoothly(*s.ribbon)) {
            leaving = -radial(s.at, point);
        }
        const Vector3d arriving = 2.0 * leaving.dot(chord) * chord - leaving;
        moments += s.length * arriving * arriving.transpose();
    }
    const Vector3d normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(moments).eigenvectors().col(0);
    return normal.dot(outwards) < 0.0 ? Vector3d(-normal) : normal;
}

/// Sine of the angle at which the point is seen from the border, above the border's tangent.
double seen(const Sample& s, const Vector3d& point) {
    const Vector3d towards = point - s.at.point;
    return s.at.inward.dot(towards) / towards.norm();
}

const Sample& worst_seen(const std::vector<Sample>& samples, const Vector3d& point) {
    return *std::min_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
        return seen(a, point) < seen(b, point);
    });
}

/// The point moved, over and over towards the inside of the side that sees it worst, until all see
/// it. The directions of all sides bound a convex region: the moves come nearer to it.
std::optional<Vector3d> moved_into_sight(const std::vector<Sample>& samples, Vector3d point,
                                         double least) {
    for (int move = 0; move < kMostMoves; ++move) {
        const Sample& worst = worst_seen(samples, point);
        const double missing = least - seen(worst, point);
        if (missing <= 0.0) {
            return point;
        }
        point += 1.05 * missing * (point - worst.at.point).norm() * worst.at.inward;
    }
    return std::nullopt;
}

Result<Vector3d> in_sight(const std::vector<Sample>& samples, const Vector3d& point, bool given) {
    if (!given) {
        for (const double least : kSeen) {
            if (const auto moved = moved_into_sight(samples, point, least)) {
                return *moved;
            }
        }
    }
    const Sample& worst = worst_seen(samples, point);
    const double least = *std::min_element(std::begin(kSeen), std::end(kSeen));
    const double sine = seen(worst, point);
    if (sine >= least) {
        return point;
    }
    return fail(ErrorCode::Refused,
                "the hole is not star-shaped: {} sees the closing point ({:.6g}, {:.6g}, {:.6g}) "
                "at {:.3g} deg from its inside (limit {:.2g})",
                name_of(*worst.ribbon), point.x(), point.y(), point.z(),
                degrees(std::asin(std::clamp(sine, -1.0, 1.0))), degrees(std::asin(least)));
}

/// The directions' turning about the normal: 2 pi if they go around once, and never back.
bool goes_around(const std::vector<Vector3d>& directions, const Vector3d& normal) {
    double turning = 0.0;
    const std::size_t m = directions.size();
    for (std::size_t j = 0; j < m; ++j) {
        const Vector3d& a = directions[j];
        const Vector3d& b = directions[(j + 1) % m];
        const double turn = std::atan2(normal.dot(a.cross(b)), a.dot(b));
        if (!(turn > -1e-12)) {
            return false;
        }
        turning += turn;
    }
    return std::abs(turning - 2.0 * kPi) < 1e-6;
}

}  // namespace

Vector3d radial(const RibbonPoint& at, const Vector3d& pole) {
    const Vector3d outwards = at.point - pole;
    return (outwards - at.normal * at.normal.dot(outwards)).normalized();
}

Result<Pole> find_pole(const RibbonLoop& loop, double diameter,
                       const std::optional<Vector3d>& point,
                       const std::optional<Vector3d>& normal) {
    const std::vector<Sample> samples = samples_of(loop);
    const Vector3d centre = centre_of(samples);
    const Vector3d area = area_vector(samples, centre);
    if (!normal && !(area.norm() > 1e-6 * diameter * diameter)) {
        return fail(ErrorCode::Refused,
                    "the loop encloses no area in any projection: give the closing point and its "
                    "normal");
    }
    Pole pole{point.value_or(centre), normal.value_or(area).normalized()};
    for (int round = 0; round < kRounds; ++round) {
        if (!point) {
            // On the axis through the centre, then to where all sides see it.
            double height = 0.0;
            double length = 0.0;
            for (const Sample& s : samples) {
                height += s.length * arc_height(s, centre, pole.normal);
                length += s.length;
            }
            pole.point = centre + pole.normal * (height / length);
        }
        const auto moved = in_sight(samples, pole.point, point.has_value());
        if (!moved) {
            return tl::unexpected(moved.error());
        }
        pole.point = *moved;
        if (!normal) {
            pole.normal = arriving(samples, pole.point, area);
        }
    }
    return pole;
}

Result<std::vector<Vector3d>> directions_at(const Pole& pole, const Eigen::Matrix3Xd& border,
                                            const Eigen::Matrix3Xd& tangents) {
    for (const bool by_tangents : {true, false}) {
        std::vector<Vector3d> directions;
        for (Eigen::Index j = 0; j < border.cols(); ++j) {
            Vector3d d = by_tangents ? Vector3d(tangents.col(j)) : border.col(j) - pole.point;
            d -= pole.normal * pole.normal.dot(d);
            directions.push_back(d.normalized());
        }
        if (goes_around(directions, pole.normal)) {
            return directions;
        }
    }
    return fail(ErrorCode::Refused,
                "seen along the normal ({:.3g}, {:.3g}, {:.3g}) of the closing point, the border "
                "does not go around it once",
                pole.normal.x(), pole.normal.y(), pole.normal.z());
}

}  // namespace suture::tube
