#include "suture/fill/mvs/layout.h"

#include "suture/base/tolerance.h"
#include "suture/fill/mvs/chebyshev.h"
#include "suture/fill/mvs/polygon.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>

namespace suture::mvs {
namespace {

// Points on a side: doubled until the side's tangent is resolved or the last count is reached.
constexpr int kFirstCount = 17;
constexpr int kLastCount = 129;
// What a tangent's last terms leave out moves the domain curve by less than a hundredth of that,
// far below any gap that is asked for.
constexpr double kResolved = 1e-8;
// Sides shorter than this part of the hole's diameter have no direction to speak of.
constexpr double kShortestSide = 1e-6;
// The closing conditions are met when the gap is this small part of the length.
constexpr double kClosed = 1e-13;
constexpr int kClosingSteps = 30;
// Points a side for tests of crossing and for the box.
constexpr int kPolylinePoints = 48;
// Sides that come this near to each other in space, relative to the diameter, cross: the polylines
// are not nearer to the curves.
constexpr double kTouching = 1e-4;
// Boxes whose areas differ by less than this count as equal, so that rounding does not choose.
constexpr double kEqualArea = 1e-6;

// One side, sampled at Chebyshev points.
struct Side {
    Eigen::VectorXd speed;      // |dP/ds|
    Eigen::VectorXd turning;    // turned since the side's start, on the neighbour
    Eigen::VectorXd arclength;  // since the side's start
    std::shared_ptr<const Eigen::MatrixXd> integration;  // see chebyshev_integration
    [[nodiscard]] Eigen::VectorXd integrated(const Eigen::VectorXd& values) const {
        return integration->transpose() * values;
    }
    Eigen::Vector3d first_tangent, last_tangent, first_normal, last_normal;
    [[nodiscard]] double length() const { return arclength[arclength.size() - 1]; }
};

// Integration matrices by count: sides share them.
class Integrations {
  public:
    std::shared_ptr<const Eigen::MatrixXd> operator()(int count) {
        std::shared_ptr<const Eigen::MatrixXd>& matrix = matrices_[count];
        if (!matrix) {
            matrix = std::make_shared<const Eigen::MatrixXd>(chebyshev_integration(count));
        }
        return matrix;
    }

  private:
    std::map<int, std::shared_ptr<const Eigen::MatrixXd>> matrices_;
};

// The normal about which a side turns.
using NormalField = std::function<Eigen::Vector3d(double s)>;

// Points around a loop, side by side.
Eigen::Matrix3Xd space_polyline(const RibbonLoop& loop) {
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(loop.ribbons.size()) * kPolylinePoints);
    Eigen::Index at = 0;
    for (const Ribbon& ribbon : loop.ribbons) {
        for (int k = 0; k < kPolylinePoints; ++k) {
            points.col(at++) = ribbon.at(static_cast<double>(k) / kPolylinePoints).point;
        }
    }
    return points;
}

// The normal about which a loop runs counterclockwise, if it were planar.
Eigen::Vector3d area_normal(const Eigen::Matrix3Xd& points) {
    const Eigen::Vector3d origin = points.col(0);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 1; i < points.cols(); ++i) {
        const Eigen::Vector3d before = points.col(i - 1) - origin;
        const Eigen::Vector3d after = points.col(i) - origin;
        area += before.cross(after);
    }
    return area.normalized();
}

// Sides that want position only take the normals between those of the nearest sides that do have
// a neighbour to follow, in the order of the loop, or else the loop's own.
class Normals {
  public:
    Normals(const RibbonLoop& loop, const Eigen::Vector3d& own) : loop_(loop), own_(own) {}

    [[nodiscard]] NormalField along(std::size_t i) const {
        const Ribbon& ribbon = loop_.ribbons[i];
        if (follows(i)) {
            return [&ribbon](double s) { return ribbon.at(s).normal; };
        }
        const std::size_t n = loop_.ribbons.size();
        std::size_t before = 1;
        while (before < n && !follows((i + n - before) % n)) {
            ++before;
        }
        if (before == n) {
            return [normal = own_](double) { return normal; };
        }
        std::size_t after = 1;
        while (!follows((i + after) % n)) {
            ++after;
        }
        const Eigen::Vector3d first = loop_.ribbons[(i + n - before) % n].at(1.0).normal;
        const Eigen::Vector3d last = loop_.ribbons[(i + after) % n].at(0.0).normal;
        const auto steps = static_cast<double>(before + after - 1);
        const double offset = static_cast<double>(before - 1);
        return [=, &ribbon](double s) -> Eigen::Vector3d {
            const double t = (offset + s) / steps;
            const Eigen::Vector3d along = ribbon.at(s).tangent.normalized();
            const Eigen::Vector3d between = (1.0 - t) * first + t * last;
            return (between - between.dot(along) * along).normalized();
        };
    }

  private:
    [[nodiscard]] bool follows(std::size_t i) const {
        return loop_.ribbons[i].continuity >= Continuity::G1;
    }

    const RibbonLoop& loop_;
    Eigen::Vector3d own_;
};

Result<Side> sample_side(const Ribbon& ribbon, const NormalField& normal, int count,
                         double diameter, Integrations& integrations, bool& resolved) {
    const Eigen::VectorXd s = chebyshev_points(count);
    Side side;
    side.speed.resize(count);
    Eigen::Matrix3Xd tangents(3, count), normals(3, count);
    for (int k = 0; k < count; ++k) {
        const RibbonPoint p = ribbon.at(s[k]);
        side.speed[k] = p.tangent.norm();
        if (!p.point.allFinite() || !p.normal.allFinite() || !p.tangent.allFinite() ||
            std::abs(p.normal.norm() - 1.0) > kResolved) {
            return fail(ErrorCode::Refused,
                        "{}: no finite point, tangent and unit normal at {:.3f}", name_of(ribbon),
                        s[k]);
        }
        tangents.col(k) = p.tangent / std::max(side.speed[k], kShortestSide * diameter);
        normals.col(k) = normal(s[k]);
    }
    const Eigen::MatrixXd coefficients = chebyshev_coefficients(tangents);
    resolved = count == kLastCount || coefficients.rightCols(2).cwiseAbs().maxCoeff() < kResolved;
    if (!resolved) {
        return side;
    }
    side.integration = integrations(count);
    side.arclength = side.integrated(side.speed);
    if (side.length() < kShortestSide * diameter) {
        return fail(ErrorCode::Refused, "{}: its length {:.3g} is less than {:.3g}, no direction",
                    name_of(ribbon), side.length(), kShortestSide * diameter);
    }
    const Eigen::Matrix3Xd rates = chebyshev_values(chebyshev_derivative(coefficients), count);
    Eigen::VectorXd turning_rate(count);
    for (int k = 0; k < count; ++k) {
        const Eigen::Vector3d inward = normals.col(k).cross(tangents.col(k));
        turning_rate[k] = rates.col(k).dot(inward);
    }
    side.turning = side.integrated(turning_rate);
    side.first_tangent = tangents.col(0);
    side.last_tangent = tangents.col(count - 1);
    side.first_normal = normals.col(0);
    side.last_normal = normals.col(count - 1);
    return side;
}

Result<Side> resolve_side(const Ribbon& ribbon, const NormalField& normal, double diameter,
                          Integrations& integrations) {
    int count = kFirstCount;
    while (true) {
        bool resolved = false;
        Result<Side> side = sample_side(ribbon, normal, count, diameter, integrations, resolved);
        if (!side || resolved) {
            return side;
        }
        count = 2 * count - 1;
    }
}

// The exterior angle between two sides, about the mean of their normals.
double corner_turning(const Side& before, const Side& after) {
    const Eigen::Vector3d n = (before.last_normal + after.first_normal).normalized();
    const Eigen::Vector3d& a = before.last_tangent;
    const Eigen::Vector3d& b = after.first_tangent;
    return std::atan2(n.dot(a.cross(b)), a.dot(b) - a.dot(n) * b.dot(n));
}

// Within this of half a turn, rounding decides to which side a corner turns.
constexpr double kCusp = radians(1.0);

// The exterior angles at the sides' starts. Those of cusps are taken as the loop's turning, once
// around, asks for: a cusp that points outwards turns by half a turn to the left, one inwards to
// the right.
std::vector<double> corner_turnings(const std::vector<Side>& sides) {
    const std::size_t n = sides.size();
    std::vector<double> corners(n);
    double turning = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        corners[i] = corner_turning(sides[(i + n - 1) % n], sides[i]);
        turning += corners[i] + sides[i].turning[sides[i].turning.size() - 1];
    }
    for (double& corner : corners) {
        const double missing = 2.0 * kPi - turning;
        if (std::abs(corner) > kPi - kCusp && corner * missing < 0.0 && std::abs(missing) > kPi) {
            const double change = std::copysign(2.0 * kPi, missing);
            corner += change;
            turning += change;
        }
    }
    return corners;
}

// In a polygon no corner turns by more than this: a cusp would leave no room for the others.
constexpr double kSharpest = radians(120.0);

// The sides unrolled with an additional curvature c0 + c1 x + c2 y, where (x, y) is where the point
// lies in the reference development.
class Development {
  public:
    Development(std::vector<Side> sides, LayoutKind kind)
        : sides_(std::move(sides)), corners_(corner_turnings(sides_)) {
        const std::size_t n = sides_.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (kind != LayoutKind::Development) {
                sides_[i].turning.setZero();
                corners_[i] = kind == LayoutKind::Circle
                                  ? 0.0
                                  : std::clamp(corners_[i], -kSharpest, kSharpest);
            }
            turning_ += corners_[i] + sides_[i].turning[sides_[i].turning.size() - 1];
            length_ += sides_[i].length();
        }
        references_.resize(n);
    }

    [[nodiscard]] double turning() const { return turning_; }
    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }

    // Each side's values at its points, and the turning and position reached at the end.
    struct Unrolled {
        std::vector<Eigen::Matrix2Xd> values;
        double turning = 0.0;
        Eigen::Vector2d end = Eigen::Vector2d::Zero();
    };

    [[nodiscard]] Unrolled unroll(const Eigen::Vector3d& c) const {
        Unrolled result;
        Eigen::Vector2d position = Eigen::Vector2d::Zero();
        double angle = 0.0;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const Side& side = sides_[i];
            if (i > 0) {
                angle += corners_[i];
            }
            const Eigen::Index count = side.speed.size();
            Eigen::VectorXd bend = c[0] / length_ * side.arclength;
            if (references_[i].cols() == count) {
                const Eigen::VectorXd rate =
                    (references_[i].transpose() * c.tail<2>()).cwiseProduct(side.speed) / length_;
                bend += side.integrated(rate);
            }
            const Eigen::VectorXd angles = (side.turning + bend).array() + angle;
            Eigen::Matrix2Xd velocity(2, count);
            velocity.row(0) = side.speed.array() * angles.array().cos();
            velocity.row(1) = side.speed.array() * angles.array().sin();
            Eigen::Matrix2Xd values = velocity * *side.integration;
            values.colwise() += position;
            position = values.col(count - 1);
            angle = angles[count - 1];
            result.values.push_back(std::move(values));
        }
        result.turning = angle + corners_[0];
        result.end = position;
        return result;
    }

    // Fixes the directions of the correction: positions about their mean, relative to the length.
    void set_reference(const Unrolled& unrolled) {
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        double weight = 0.0;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            references_[i] = unrolled.values[i];
            const Eigen::Vector2d centre = references_[i].rowwise().mean();
            mean += sides_[i].length() * centre;
            weight += sides_[i].length();
        }
        mean /= weight;
        for (Eigen::Matrix2Xd& reference : references_) {
            reference = (reference.colwise() - mean) / length_;
        }
    }

  private:
    std::vector<Side> sides_;
    std::vector<double> corners_;
    std::vector<Eigen::Matrix2Xd> references_;
    double turning_ = 0.0;
    double length_ = 0.0;
};

Eigen::Vector3d closing_error(const Development& development, const Eigen::Vector3d& c) {
    const Development::Unrolled unrolled = development.unroll(c);
    return {unrolled.turning - 2.0 * kPi, unrolled.end.x() / development.length(),
            unrolled.end.y() / development.length()};
}

// Newton's method with halved steps; the derivative by differences, which is accurate enough to
// converge and cheap.
Eigen::Vector3d close(const Development& development, Eigen::Vector3d c) {
    constexpr double kDifference = 1e-6;
    Eigen::Vector3d error = closing_error(development, c);
    for (int step = 0; step < kClosingSteps && error.norm() > kClosed; ++step) {
        Eigen::Matrix3d derivative;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d moved = c + kDifference * Eigen::Vector3d::Unit(k);
            derivative.col(k) = (closing_error(development, moved) - error) / kDifference;
        }
        const Eigen::Vector3d change = derivative.fullPivLu().solve(-error);
        double factor = 1.0;
        bool better = false;
        while (factor > kDifference && !better) {
            const Eigen::Vector3d candidate = c + factor * change;
            const Eigen::Vector3d candidate_error = closing_error(development, candidate);
            better = candidate_error.norm() < error.norm();
            if (better) {
                c = candidate;
                error = candidate_error;
            }
            factor *= 0.5;
        }
        if (!better) {
            break;
        }
    }
    return c;
}

Eigen::Matrix2Xd polyline(const std::vector<DomainCurve>& curves) {
    Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(curves.size()) * kPolylinePoints);
    Eigen::Index at = 0;
    for (const DomainCurve& curve : curves) {
        for (int k = 0; k < kPolylinePoints; ++k) {
            points.col(at++) = curve.at(static_cast<double>(k) / kPolylinePoints);
        }
    }
    return points;
}

struct Box {
    double angle = 0.0;
    Eigen::Vector2d lower, upper;
    [[nodiscard]] double area() const { return (upper - lower).prod(); }
};

Box box_along(const Eigen::Matrix2Xd& points, double angle) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-angle).toRotationMatrix();
    const Eigen::Matrix2Xd turned = turn * points;
    return {angle, turned.rowwise().minCoeff(), turned.rowwise().maxCoeff()};
}

// The least box along a chord of a side; equal ones are told apart by the sides' edge numbers,
// which do not depend on where the loop starts.
Box least_box(const RibbonLoop& loop, const std::vector<DomainCurve>& curves,
              const Eigen::Matrix2Xd& points) {
    std::vector<std::size_t> order(curves.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return loop.ribbons[a].edge < loop.ribbons[b].edge;
    });
    Box best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        const Eigen::Vector2d start = curves[i].at(0.0);
        Eigen::Vector2d chord = curves[i].at(1.0) - start;
        if (curves.size() == 1) {
            chord = curves[i].at(0.5) - start;
        }
        const Box box = box_along(points, std::atan2(chord.y(), chord.x()));
        if (box.area() < least * (1.0 - kEqualArea)) {
            least = box.area();
            best = box;
        }
    }
    return best;
}

Layout lay_out_as(LayoutKind kind, const RibbonLoop& loop, const std::vector<Side>& sides) {
    Development development(sides, kind);
    Eigen::Vector3d c(2.0 * kPi - development.turning(), 0.0, 0.0);
    Development::Unrolled unrolled = development.unroll(c);
    Layout layout;
    layout.kind = kind;
    layout.turning = development.turning();
    layout.closing_gap = unrolled.end.norm() / development.length();
    development.set_reference(unrolled);
    c = close(development, c);
    unrolled = development.unroll(c);
    // What Newton's method left is spread along the loop.
    double walked = 0.0;
    std::vector<DomainCurve> curves;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        const Side& side = development.sides()[i];
        layout.lengths.push_back(side.length());
        const Eigen::Vector2d drift = unrolled.end / development.length();
        const Eigen::VectorXd arc = side.arclength.array() + walked;
        const Eigen::Matrix2Xd values = unrolled.values[i] - drift * arc.transpose();
        walked += side.length();
        curves.emplace_back(chebyshev_coefficients(values));
    }
    const Eigen::Matrix2Xd points = polyline(curves);
    layout.simple = !crosses_itself(points);
    const Box box = least_box(loop, curves, points);
    const Eigen::Vector2d size = box.upper - box.lower;
    // The solver's matrix has its least bandwidth when the box is longer in v.
    const bool upright = size.y() >= size.x() * (1.0 - kEqualArea);
    const double angle = upright ? -box.angle : 0.5 * kPi - box.angle;
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Box turned = box_along(points, -angle);
    const Eigen::Vector2d shift = -0.5 * (turned.lower + turned.upper);
    for (const DomainCurve& curve : curves) {
        layout.curves.push_back(curve.moved(rotation, shift));
    }
    layout.lower = turned.lower + shift;
    layout.upper = turned.upper + shift;
    return layout;
}

}  // namespace

DomainCurve::DomainCurve(Eigen::Matrix2Xd coefficients)
    : coefficients_(std::move(coefficients)), derivative_(chebyshev_derivative(coefficients_)) {}

Eigen::Vector2d DomainCurve::at(double s) const {
    return evaluate_chebyshev(coefficients_, s);
}

Eigen::Vector2d DomainCurve::derivative(double s) const {
    return evaluate_chebyshev(derivative_, s);
}

DomainCurve DomainCurve::moved(const Eigen::Matrix2d& map, const Eigen::Vector2d& shift) const {
    Eigen::Matrix2Xd moved = map * coefficients_;
    moved.col(0) += shift;
    return DomainCurve(std::move(moved));
}

DomainCurve DomainCurve::with_ends_moved(const Eigen::Vector2d& start,
                                         const Eigen::Vector2d& end) const {
    // 10 s^3 - 15 s^4 + 6 s^5 as a sum of T_k(2 s - 1).
    Eigen::Matrix<double, 1, 6> rise;
    rise << 0.5, 75.0 / 128.0, 0.0, -25.0 / 256.0, 0.0, 3.0 / 256.0;
    Eigen::Matrix2Xd moved =
        Eigen::Matrix2Xd::Zero(2, std::max<Eigen::Index>(6, coefficients_.cols()));
    moved.leftCols(coefficients_.cols()) = coefficients_;
    moved.leftCols<6>() += (end - start) * rise;
    moved.col(0) += start;
    return DomainCurve(std::move(moved));
}

Result<Layout> lay_out(const RibbonLoop& loop, double diameter) {
    std::vector<Side> sides;
    Integrations integrations;
    const Eigen::Matrix3Xd points = space_polyline(loop);
    const Normals normals(loop, area_normal(points));
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        Result<Side> side = resolve_side(loop.ribbons[i], normals.along(i), diameter, integrations);
        if (!side) {
            return tl::unexpected(side.error());
        }
        sides.push_back(std::move(*side));
    }
    if (crosses_in_space(points, kTouching * diameter)) {
        return fail(ErrorCode::Refused, "the boundary from {} on crosses itself",
                    name_of(loop.ribbons.front()));
    }
    Layout layout = lay_out_as(LayoutKind::Development, loop, sides);
    const double turning = layout.turning;
    for (const LayoutKind simpler : {LayoutKind::Polygon, LayoutKind::Circle}) {
        if (!layout.simple) {
            layout = lay_out_as(simpler, loop, sides);
            layout.turning = turning;
        }
    }
    return layout;
}

}  // namespace suture::mvs
