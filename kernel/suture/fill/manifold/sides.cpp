#include "suture/fill/manifold/sides.h"

#include "suture/base/tolerance.h"
#include "suture/fill/mvs/chebyshev.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector3d;

/// Beyond this the two sides of a corner run on into each other: the corner block of a patch would
/// be too flat, and a little kink is followed by many knots.
constexpr double kCornerAngle = radians(170.0);
constexpr double kReflexAngle = radians(190.0);

/// Normals of two neighbours that differ by more than this cannot both be met at their corner.
constexpr double kDisagree = radians(0.5);

/// Sides shorter than this share of the hole's diameter carry no layers.
constexpr double kNoLength = 1e-6;

struct Length {
    double total = 0.0;
    std::function<double(double)> along;
};

/// The length of a ribbon from its start, by integration of its speed at Chebyshev points.
Length length_of(const Ribbon& ribbon) {
    constexpr int kPoints = 65;
    const Eigen::VectorXd where = mvs::chebyshev_points(kPoints);
    Eigen::MatrixXd speed(1, kPoints);
    for (Eigen::Index k = 0; k < kPoints; ++k) {
        speed(0, k) = ribbon.at(where[k]).tangent.norm();
    }
    const double mean = speed.mean();
    constexpr double kEven = 1e-9;
    if ((speed.array() - mean).abs().maxCoeff() <= kEven * mean) {
        return {mean, [](double s) { return s; }};
    }
    const Eigen::MatrixXd integral = mvs::chebyshev_integral(mvs::chebyshev_coefficients(speed));
    const double total = mvs::evaluate_chebyshev(integral, 1.0)[0];
    return {total, [integral, total](double s) {
                return s >= 1.0 ? 1.0 : mvs::evaluate_chebyshev(integral, s)[0] / total;
            }};
}

/// Lets the ends of ribbons that do not quite meet do so, each moved by its share of their lengths:
/// then no one is tilted more than the other.
void meet(std::vector<Piece>& pieces, const std::vector<Ribbon>& ribbons,
          const std::vector<Length>& lengths) {
    const std::size_t count = ribbons.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = (i + count - 1) % count;
        const Vector3d apart = ribbons[i].at(0.0).point - ribbons[before].at(1.0).point;
        const double share = lengths[i].total / (lengths[i].total + lengths[before].total);
        pieces[i].start_shift = -share * apart;
        pieces[before].end_shift = (1.0 - share) * apart;
    }
}

/// The angle inside the hole where one ribbon ends and another begins.
double interior_angle(const RibbonPoint& end, const RibbonPoint& start) {
    const Vector3d normal = (end.normal + start.normal).normalized();
    const Vector3d back = -end.tangent;
    const double angle = std::atan2(normal.dot(start.tangent.cross(back)), start.tangent.dot(back));
    return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

}  // namespace

Vector3d Piece::meeting_point(const Vector3d& point, double s) const {
    const auto fades = [](double t) { return (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t); };
    return point + fades(s) * start_shift + fades(1.0 - s) * end_shift;
}

std::vector<double> Side::joints() const {
    std::vector<double> shares;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        shares.push_back(pieces[i].to);
    }
    return shares;
}

Result<Sides> find_sides(const Hole& hole) {
    if (hole.loops.size() != 1) {
        return fail(ErrorCode::Refused, "manifold takes one loop, this hole has {}",
                    hole.loops.size());
    }
    const std::vector<Ribbon>& ribbons = hole.loops.front().ribbons;
    const std::size_t count = ribbons.size();
    Sides result;
    std::vector<Length> lengths;
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = (i + count - 1) % count;
        lengths.push_back(length_of(ribbons[i]));
        if (!(lengths.back().total > kNoLength * hole.diameter)) {
            return fail(ErrorCode::Refused, "{} has a length of {:.3g}, no more than {:.3g}",
                        name_of(ribbons[i]), lengths.back().total, kNoLength * hole.diameter);
        }
        const RibbonPoint end = ribbons[before].at(1.0);
        const RibbonPoint start = ribbons[i].at(0.0);
        const double angle = interior_angle(end, start);
        if (angle > kReflexAngle) {
            return fail(ErrorCode::Refused,
                        "the corner between {} and {} has an interior angle of {:.1f} deg: above "
                        "{:.0f} deg a border of B-splines would fold there",
                        name_of(ribbons[before]), name_of(ribbons[i]), degrees(angle),
                        degrees(kReflexAngle));
        }
        if (angle < kCornerAngle) {
            corners.push_back(i);
        }
        const double apart =
            std::atan2(end.normal.cross(start.normal).norm(), end.normal.dot(start.normal));
        if (apart > kDisagree) {
            result.notes.push_back(fmt::format(
                "{} and {} have normals that differ by {:.3g} deg where they meet: no smooth "
                "surface meets both there",
                name_of(ribbons[before]), name_of(ribbons[i]), degrees(apart)));
        }
    }
    if (corners.empty()) {
        result.ring = true;
        corners.push_back(0);
    } else if (corners.size() < 3) {
        return fail(ErrorCode::Refused,
                    "the loop that begins with {} has {} corners of less than {:.0f} deg: a patch "
                    "has at least 3, a ring none",
                    name_of(ribbons.front()), corners.size(), degrees(kCornerAngle));
    }
    std::vector<Piece> pieces(count);
    meet(pieces, ribbons, lengths);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t end = corners[(c + 1) % corners.size()];
        Side& side = result.sides.emplace_back();
        std::size_t i = corners[c];
        do {
            Piece& piece = side.pieces.emplace_back(std::move(pieces[i]));
            piece.ribbon = static_cast<int>(i);
            piece.from = side.length;
            piece.to = side.length + lengths[i].total;
            piece.along = lengths[i].along;
            side.length += lengths[i].total;
            i = (i + 1) % count;
        } while (i != end);
        for (Piece& piece : side.pieces) {
            piece.from /= side.length;
            piece.to /= side.length;
        }
    }
    return result;
}

}  // namespace suture::manifold
