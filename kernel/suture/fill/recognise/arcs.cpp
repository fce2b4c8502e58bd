#include "suture/fill/recognise/arcs.h"

#include "suture/base/tolerance.h"
#include "suture/spline/knots.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int kDegree = 5;
/// How far the arcs reach beyond their contacts, as a share of the widest angle: the border of a
/// file lies on both sides of them, also at a corner where the two sides meet and the arcs end.
constexpr double kBeyond = 0.02;
/// The widest angle of one rational quadratic arc.
constexpr double kWidest = radians(100.0);
/// Numbers of positions that are tried.
constexpr int kCounts[] = {6, 8, 11, 15, 21, 29, 41, 57, 81};
/// Between two positions the error is measured at so many places.
constexpr int kBetween = 2;

/// The path as a function of its length.
class Path {
  public:
    explicit Path(const PathPart& part) : ball_(part.ball), path_(part.positions), lengths_{0.0} {
        for (std::size_t i = 1; i < path_.size(); ++i) {
            lengths_.push_back(lengths_.back() + arc(path_[i - 1], path_[i]));
        }
    }
    [[nodiscard]] double length() const { return lengths_.back(); }

    [[nodiscard]] std::optional<BallPosition> at(double t) const {
        const auto it = std::upper_bound(lengths_.begin(), lengths_.end() - 1, t);
        const auto i = std::max<std::ptrdiff_t>(it - lengths_.begin(), 1);
        const auto k = static_cast<std::size_t>(i);
        const BallPosition& a = path_[k - 1];
        const BallPosition& b = path_[k];
        // Hermite's cubic, so that the parameter stays smooth where steps of other lengths meet.
        const double h = lengths_[k] - lengths_[k - 1];
        const double f = (t - lengths_[k - 1]) / h;
        const double g = 1.0 - f;
        const Vector3d chord = b.centre - a.centre;
        BallPosition start = f < 0.5 ? a : b;
        start.tangent = (6.0 * f * g * chord + h * g * (1.0 - 3.0 * f) * a.tangent -
                         h * f * (2.0 - 3.0 * f) * b.tangent)
                            .normalized();
        const Vector3d centre = a.centre + f * f * (3.0 - 2.0 * f) * chord +
                                h * f * g * (g * a.tangent - f * b.tangent);
        return ball_.at(centre, start);
    }

  private:
    /// Length of the circle through two positions.
    static double arc(const BallPosition& a, const BallPosition& b) {
        const double half =
            0.5 * std::atan2(a.tangent.cross(b.tangent).norm(), a.tangent.dot(b.tangent));
        const double chord = (b.centre - a.centre).norm();
        return half < 1e-8 ? chord : chord * half / std::sin(half);
    }

    const RollingBall& ball_;
    const std::vector<BallPosition>& path_;
    std::vector<double> lengths_;
};

/// Homogeneous control points across the path.
struct Across {
    int arcs = 1;
    double beyond = 0.0;  ///< the contacts, radians

    [[nodiscard]] int count() const { return 2 * arcs + 1; }

    [[nodiscard]] std::vector<Vector4d> points(const BallPosition& p, double radius) const {
        const double angle =
            std::atan2(p.normal[0].cross(p.normal[1]).norm(), p.normal[0].dot(p.normal[1]));
        const Vector3d e = p.normal[0];
        const Vector3d f = (p.normal[1] - e * e.dot(p.normal[1])).normalized();
        const double from = -beyond;
        const double step = (angle + 2.0 * beyond) / arcs;
        const double w = std::cos(0.5 * step);
        std::vector<Vector4d> result;
        for (int k = 0; k <= 2 * arcs; ++k) {
            const double a = from + 0.5 * step * k;
            const double weight = k % 2 == 0 ? 1.0 : w;
            const Vector3d direction = std::cos(a) * e + std::sin(a) * f;
            const Vector3d point = p.centre + radius / weight * direction;
            result.emplace_back();
            result.back() << weight * point, weight;
        }
        return result;
    }

    [[nodiscard]] std::vector<double> knots() const {
        std::vector<double> result = {0.0, 0.0, 0.0};
        for (int k = 1; k < arcs; ++k) {
            result.insert(result.end(), 2, static_cast<double>(k) / arcs);
        }
        result.insert(result.end(), 3, 1.0);
        return result;
    }
};

/// Knots for interpolation at evenly spaced parameters: averages of the inner ones.
/// Source   Piegl & Tiller, The NURBS Book, eq. 9.8
std::vector<double> averaged_knots(int count, double length) {
    std::vector<double> knots(kDegree + 1, 0.0);
    for (int j = 1; j < count - kDegree; ++j) {
        double sum = 0.0;
        for (int i = j; i < j + kDegree; ++i) {
            sum += length * i / (count - 1);
        }
        knots.push_back(sum / kDegree);
    }
    knots.insert(knots.end(), kDegree + 1, length);
    return knots;
}

std::optional<SplineSurface> interpolated(const Path& path, const Across& across, double radius,
                                          int count) {
    SplineSurface surface;
    surface.degree_u = kDegree;
    surface.degree_v = 2;
    surface.knots_u = averaged_knots(count, path.length());
    surface.knots_v = across.knots();
    const int rows = across.count();
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(count, count);
    Eigen::MatrixXd values(count, 4 * rows);
    for (int i = 0; i < count; ++i) {
        const double t = path.length() * i / (count - 1);
        const auto p = path.at(t);
        if (!p) {
            return std::nullopt;
        }
        const std::vector<Vector4d> points = across.points(*p, radius);
        for (int j = 0; j < rows; ++j) {
            values.block<1, 4>(i, 4 * j) = points[static_cast<std::size_t>(j)].transpose();
        }
        const int span = find_span(surface.knots_u, kDegree, t);
        B.block(i, span - kDegree, 1, kDegree + 1) =
            basis_derivatives(surface.knots_u, kDegree, span, t, 0);
    }
    const Eigen::MatrixXd poles = B.partialPivLu().solve(values);
    surface.poles.resize(3, count * rows);
    surface.weights.resize(count * rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < count; ++i) {
            const int k = surface.index(i, j);
            surface.weights[k] = poles(i, 4 * j + 3);
            surface.poles.col(k) = poles.block<1, 3>(i, 4 * j).transpose() / surface.weights[k];
        }
    }
    return surface;
}

/// The largest distance from the ball's circles halfway between the positions, along the path and
/// across it.
double error_of(const SplineSurface& surface, const Path& path, double radius, int count) {
    double error = 0.0;
    for (int i = 0; i + 1 < count; ++i) {
        for (int k = 1; k <= kBetween; ++k) {
            const double t = path.length() * (i + k / (kBetween + 1.0)) / (count - 1);
            const auto p = path.at(t);
            if (!p) {
                return INFINITY;
            }
            for (const double v : {0.0, 0.3, 0.5, 1.0}) {
                // To first order the distance from the envelope is that from the sphere.
                const Vector3d x = evaluate(surface, t, v).point;
                const Vector3d d = x - p->centre;
                const Vector3d in_plane = d - p->tangent * p->tangent.dot(d);
                error = std::max({error, std::abs(in_plane.norm() - std::abs(radius))});
            }
        }
    }
    return error;
}

/// With as many positions as the accuracy needs.
Result<ArcSurface> fit_part(const PathPart& part, const Across& across, double accuracy) {
    const Path path(part);
    ArcSurface best;
    best.error = INFINITY;
    for (const int count : kCounts) {
        auto surface = interpolated(path, across, part.ball.radius(), count);
        if (!surface) {
            return fail(ErrorCode::Refused, "the rolling ball's path has gaps");
        }
        const double error = error_of(*surface, path, part.ball.radius(), count);
        if (error < best.error) {
            best = {std::move(*surface), error};
        }
        if (best.error <= accuracy) {
            break;
        }
    }
    return best;
}

/// One surface after the other in u. Their circles at the joint are the same, so that they have
/// their tangent planes in common as well.
void append(SplineSurface& surface, const SplineSurface& next) {
    const int rows = surface.count_v();
    const int before = surface.count_u();
    const int after = next.count_u();
    SplineSurface joined = surface;
    joined.poles.resize(3, (before + after - 1) * rows);
    joined.weights.resize((before + after - 1) * rows);
    joined.knots_u.pop_back();
    for (std::size_t k = kDegree + 1; k < next.knots_u.size(); ++k) {
        joined.knots_u.push_back(surface.knots_u.back() + next.knots_u[k]);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < before + after - 1; ++i) {
            const SplineSurface& from = i < before ? surface : next;
            const int k = from.index(i < before ? i : i - before + 1, j);
            joined.poles.col(joined.index(i, j)) = from.poles.col(k);
            joined.weights[joined.index(i, j)] = from.weights[k];
        }
    }
    surface = std::move(joined);
}

}  // namespace

Result<ArcSurface> fit_arcs(const std::vector<PathPart>& parts, double accuracy) {
    double widest = 0.0;
    for (const PathPart& part : parts) {
        if (part.positions.size() < 2) {
            return fail(ErrorCode::Refused, "the rolling ball does not roll");
        }
        for (const BallPosition& p : part.positions) {
            widest = std::max(widest, std::atan2(p.normal[0].cross(p.normal[1]).norm(),
                                                 p.normal[0].dot(p.normal[1])));
        }
    }
    const Across across{
        std::max(1, static_cast<int>(std::ceil((1.0 + 2.0 * kBeyond) * widest / kWidest))),
        kBeyond * widest};
    std::optional<ArcSurface> whole;
    for (const PathPart& part : parts) {
        auto fitted = fit_part(part, across, accuracy);
        if (!fitted) {
            return fitted;
        }
        if (!whole) {
            whole = std::move(*fitted);
            continue;
        }
        append(whole->surface, fitted->surface);
        whole->error = std::max(whole->error, fitted->error);
    }
    // Areas: OCCT integrates over all of u at once, but piece by piece in v, where the kinks are.
    whole->surface = transposed(whole->surface);
    return *whole;
}

}  // namespace suture::recognise
