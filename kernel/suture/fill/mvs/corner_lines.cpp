#include "suture/fill/mvs/corner_lines.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace suture::mvs {
namespace {

// Corners whose normals disagree by more are not tangent to both neighbours with lines either.
constexpr double kSameNormal = radians(0.02);
// A line this near to an edge's direction leaves the hole at once, or runs beside it.
constexpr double kAlongEdge = radians(5.0);
// Part of the disagreement that may be left.
constexpr double kMet = 0.02;
// A second line has to make the jump so much smaller.
constexpr double kSecondLine = 2.0;
// Curvature across an edge is free, but not without bounds: so much of it counts as one of a jump.
constexpr double kFree = 1.2;
// Where the edges go on in each other's direction by less than this, as a sine, their curvatures
// across could make up for a disagreement in theory only: they would have to be many times larger.
constexpr double kStraightOn = 0.05;

double positive_angle(double angle) {
    const double rest = std::fmod(angle, 2.0 * kPi);
    return rest < 0.0 ? rest + 2.0 * kPi : rest;
}

// A symmetric form as a vector of the same norm.
Eigen::Vector3d as_vector(double xx, double xy, double yy) {
    return {xx, std::sqrt(2.0) * xy, yy};
}
Eigen::Vector3d as_vector(const Eigen::Matrix2d& form) {
    return as_vector(form(0, 0), form(0, 1), form(1, 1));
}

// The square of the linear form that vanishes along a direction.
Eigen::Vector3d square(double angle) {
    const double x = -std::sin(angle);
    const double y = std::cos(angle);
    return as_vector(x * x, x * y, y * y);
}

// What is left of a twist without lines:
//   II_before + a w_before^2 - II_after - b w_after^2 = 0, least squares.
double left_without_lines(const TwistedCorner& corner) {
    const Eigen::Vector3d right = as_vector(corner.twist);
    if (std::abs(std::sin(corner.space_wedge)) < kStraightOn) {
        const Eigen::Vector3d free = square(0.0);
        return (right - free * free.dot(right)).norm();
    }
    Eigen::Matrix<double, 3, 2> free;
    free << square(corner.space_wedge), square(0.0);
    return (free * free.householderQr().solve(right) - right).norm();
}

// The same with lines in these directions, as angles on the surface from the side that begins:
//   II_before + a w_before^2 - II_after - b w_after^2 = sum of c_k w_k^2, least a, b and c.
CornerLines meet(const TwistedCorner& corner, const std::vector<double>& directions) {
    const Eigen::Vector3d right = as_vector(corner.twist);
    const auto n = static_cast<Eigen::Index>(directions.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 4> matrix(3, 2 + n);
    matrix.col(0) = -kFree * square(corner.space_wedge);
    matrix.col(1) = kFree * square(0.0);
    for (Eigen::Index k = 0; k < n; ++k) {
        matrix.col(2 + k) = square(directions[static_cast<std::size_t>(k)]);
    }
    const Eigen::VectorXd x = matrix.completeOrthogonalDecomposition().solve(right);
    return {{}, (matrix * x - right).norm(), x.cwiseAbs().maxCoeff()};
}

std::optional<TwistedCorner> twisted_corner(const RibbonLoop& loop, const Layout& layout,
                                            std::size_t i, const Scale& scale) {
    const std::size_t before = (i + loop.ribbons.size() - 1) % loop.ribbons.size();
    if (std::min(loop.ribbons[before].continuity, loop.ribbons[i].continuity) < Continuity::G1) {
        return std::nullopt;
    }
    const RibbonPoint a = loop.ribbons[before].at(1.0);
    const RibbonPoint b = loop.ribbons[i].at(0.0);
    if (std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal)) > kSameNormal) {
        return std::nullopt;
    }
    TwistedCorner corner;
    corner.index = i;
    const Eigen::Vector2d back = -layout.curves[before].derivative(1.0);
    const Eigen::Vector2d out = layout.curves[i].derivative(0.0);
    corner.start = std::atan2(out.y(), out.x());
    corner.wedge = positive_angle(std::atan2(back.y(), back.x()) - corner.start);
    const Eigen::Vector3d normal = (a.normal + b.normal).normalized();
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = b.tangent.normalized();
    frame.col(1) = normal.cross(frame.col(0));
    const Eigen::Vector2d back_in_space = -(frame.transpose() * a.tangent);
    corner.space_wedge = positive_angle(std::atan2(back_in_space.y(), back_in_space.x()));
    corner.twist = scale.length * frame.transpose() * (a.curvature - b.curvature) * frame;
    corner.shorter_side = std::min(layout.lengths[before], layout.lengths[i]) / scale.length;
    corner.disagreement = left_without_lines(corner);
    return corner;
}

}  // namespace

std::vector<TwistedCorner> twisted_corners(const RibbonLoop& loop, const Layout& layout,
                                           const Scale& scale, double least) {
    std::vector<TwistedCorner> corners;
    for (std::size_t i = 0; i < loop.ribbons.size() && loop.ribbons.size() > 1; ++i) {
        const auto corner = twisted_corner(loop, layout, i, scale);
        if (corner && corner->disagreement > least) {
            corners.push_back(*corner);
        }
    }
    return corners;
}

CornerLines choose_lines(const TwistedCorner& corner, const LineDirections& directions) {
    // A whole line serves only where it parts the two sides: one half of it inside, one outside.
    std::array<std::vector<double>, 2> inside;
    for (const auto& [direction, axis] : {std::pair{directions.along_v, std::size_t{0}},
                                          std::pair{directions.along_u, std::size_t{1}}}) {
        for (const double half : {0.0, kPi}) {
            const double angle = positive_angle(direction + half - corner.start);
            if (angle > kAlongEdge && angle < corner.wedge - kAlongEdge) {
                inside[axis].push_back(angle / corner.wedge * corner.space_wedge);
            }
        }
    }
    const double enough = kMet * corner.disagreement;
    CornerLines best;
    best.residual = best.jump = std::numeric_limits<double>::infinity();
    for (const std::array<bool, 2> axes : {std::array{true, false}, {false, true}, {true, true}}) {
        std::vector<double> angles;
        bool parts = true;
        for (std::size_t k = 0; k < 2; ++k) {
            if (axes[k]) {
                parts = parts && inside[k].size() == 1;
                angles.insert(angles.end(), inside[k].begin(), inside[k].end());
            }
        }
        if (!parts) {
            continue;
        }
        CornerLines tried = meet(corner, angles);
        tried.axes = axes;
        const bool meets = tried.residual < enough;
        const bool met = best.residual < enough;
        const double price = tried.count() > std::max(1, best.count()) ? kSecondLine : 1.0;
        if (meets ? !met || price * tried.jump < best.jump
                  : !met && tried.residual < 0.9 * best.residual) {
            best = tried;
        }
    }
    return best;
}

}  // namespace suture::mvs
