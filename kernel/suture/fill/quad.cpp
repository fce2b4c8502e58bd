#include "suture/fill/quad.h"

#include "suture/base/tolerance.h"
#include "suture/fill/mvs/chebyshev.h"
#include "suture/spline/curve.h"
#include "suture/spline/knots.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kSides = 4;
constexpr int kDegree = 5;
// Chebyshev points of a side's speed: its integral is the arc length.
constexpr int kSpeedPoints = 65;
// Spans of a side's curve are doubled up to this number.
constexpr int kMostSpans = 64;
// The sides' curves are fitted to this part of the length tolerance, but not finer than this part
// of the hole's diameter: rounding.
constexpr double kFitPart = 0.02;
constexpr double kFinest = 1e-9;
constexpr int kNewtonSteps = 8;
constexpr double kLeastCorner = radians(5.0);
// Points a direction at which normals are compared, and on a side at which angles are measured.
constexpr int kGrid = 24;
constexpr int kAlong = 64;

// A side by its arc length, from 0 to 1.
class Walk {
  public:
    explicit Walk(const Ribbon& ribbon) : at_(ribbon.at) {
        const Eigen::VectorXd s = mvs::chebyshev_points(kSpeedPoints);
        Series speed(1, kSpeedPoints);
        for (int k = 0; k < kSpeedPoints; ++k) {
            speed(0, k) = ribbon.at(s[k]).tangent.norm();
        }
        speed_ = mvs::chebyshev_coefficients(speed);
        length_ = mvs::chebyshev_integral(speed_);
        total_ = mvs::evaluate_chebyshev(length_, 1.0)[0];
    }

    /// The part of the length walked at the ribbon's s.
    [[nodiscard]] double part(double s) const {
        return std::clamp(mvs::evaluate_chebyshev(length_, s)[0] / total_, 0.0, 1.0);
    }
    [[nodiscard]] Vector3d at(double t) const {
        double s = t;
        for (int step = 0; step < kNewtonSteps; ++step) {
            const double rate = mvs::evaluate_chebyshev(speed_, s)[0] / total_;
            s = std::clamp(s - (part(s) - t) / rate, 0.0, 1.0);
        }
        return at_(s).point;
    }

  private:
    using Series = Eigen::Matrix<double, 1, Eigen::Dynamic>;

    std::function<RibbonPoint(double s)> at_;
    Series speed_, length_;
    double total_ = 0.0;
};

SplineCurve uniform(int spans) {
    SplineCurve curve;
    curve.degree = kDegree;
    curve.knots.assign(kDegree + 1, 0.0);
    for (int k = 1; k < spans; ++k) {
        curve.knots.push_back(static_cast<double>(k) / spans);
    }
    curve.knots.insert(curve.knots.end(), kDegree + 1, 1.0);
    curve.poles.resize(3, spans + kDegree);
    return curve;
}

// A side as a border of the unit square, walked towards growing u or v.
struct Border {
    const Walk& walk;
    bool backwards;
    [[nodiscard]] Vector3d at(double t) const { return walk.at(backwards ? 1.0 - t : t); }
};

// The curve through a border's points at the Greville abscissae.
SplineCurve interpolated(const Border& border, int spans) {
    SplineCurve curve = uniform(spans);
    const int n = curve.count();
    const std::vector<double> places = greville(curve);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixX3d points(n, 3);
    for (int i = 0; i < n; ++i) {
        const double t = places[static_cast<std::size_t>(i)];
        const int span = find_span(curve.knots, kDegree, t);
        matrix.block<1, kDegree + 1>(i, span - kDegree) =
            basis_derivatives(curve.knots, kDegree, span, t, 0).row(0);
        points.row(i) = border.at(t).transpose();
    }
    curve.poles = matrix.partialPivLu().solve(points).transpose();
    return curve;
}

double error_of(const SplineCurve& curve, const Border& border) {
    const int looks = 4 * curve.count();
    double worst = 0.0;
    for (int k = 0; k < looks; ++k) {
        const double t = (k + 0.5) / looks;
        worst = std::max(worst, (evaluate(curve, t).col(0) - border.at(t)).norm());
    }
    return worst;
}

// Two opposite borders over the same knots.
struct Opposite {
    SplineCurve first, second;
    double error = 0.0;
};
Opposite fit_opposite(const Border& first, const Border& second, double wanted) {
    Opposite result;
    for (int spans = 1; spans <= kMostSpans; spans *= 2) {
        result.first = interpolated(first, spans);
        result.second = interpolated(second, spans);
        result.error = std::max(error_of(result.first, first), error_of(result.second, second));
        if (result.error <= wanted) {
            break;
        }
    }
    return result;
}

// Linear functions have the Greville abscissae as coefficients: blending by them is exact.
SplineSurface coons(const Opposite& in_u, const Opposite& in_v) {
    SplineSurface surface;
    surface.degree_u = surface.degree_v = kDegree;
    surface.knots_u = in_u.first.knots;
    surface.knots_v = in_v.first.knots;
    const std::vector<double> gu = greville(in_u.first);
    const std::vector<double> gv = greville(in_v.first);
    surface.poles.resize(3, static_cast<Eigen::Index>(gu.size() * gv.size()));
    const auto corner = [&](int i, int j) -> Vector3d {
        const SplineCurve& curve = j == 0 ? in_u.first : in_u.second;
        return curve.poles.col(i == 0 ? 0 : curve.count() - 1);
    };
    for (int j = 0; j < surface.count_v(); ++j) {
        const double v = gv[static_cast<std::size_t>(j)];
        for (int i = 0; i < surface.count_u(); ++i) {
            const double u = gu[static_cast<std::size_t>(i)];
            const Vector3d across =
                (1.0 - v) * in_u.first.poles.col(i) + v * in_u.second.poles.col(i);
            const Vector3d along =
                (1.0 - u) * in_v.first.poles.col(j) + u * in_v.second.poles.col(j);
            const Vector3d both = (1.0 - u) * (1.0 - v) * corner(0, 0) +
                                  u * (1.0 - v) * corner(1, 0) + (1.0 - u) * v * corner(0, 1) +
                                  u * v * corner(1, 1);
            surface.poles.col(surface.index(i, j)) = across + along - both;
        }
    }
    return surface;
}

Vector3d normal_at(const SplineSurface& surface, const Vector2d& uv) {
    const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
    return jet.u.cross(jet.v).normalized();
}

bool folds(const SplineSurface& surface) {
    std::array<Vector3d, kGrid + 1> row_before;
    for (int j = 0; j <= kGrid; ++j) {
        for (int i = 0; i <= kGrid; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const Vector3d normal = normal_at(
                surface, {static_cast<double>(i) / kGrid, static_cast<double>(j) / kGrid});
            const bool turned = j > 0 && normal.dot(row_before[k]) < 0.0;
            row_before[k] = normal;
            if (turned || (i > 0 && normal.dot(row_before[k - 1]) < 0.0)) {
                return true;
            }
        }
    }
    return false;
}

Result<void> check_sides(const Hole& hole) {
    if (hole.loops.size() > 1 || !hole.through.empty()) {
        return fail(ErrorCode::Refused, "a patch of four sides has no islands or inner points");
    }
    const std::vector<Ribbon>& sides = hole.loops[0].ribbons;
    if (sides.size() != kSides) {
        return fail(ErrorCode::Refused, "the hole has {} sides, not 4", sides.size());
    }
    for (std::size_t i = 0; i < kSides; ++i) {
        const Vector3d before = sides[(i + kSides - 1) % kSides].at(1.0).tangent.normalized();
        const Vector3d after = sides[i].at(0.0).tangent.normalized();
        const double corner = std::acos(std::clamp(-before.dot(after), -1.0, 1.0));
        if (corner < kLeastCorner || corner > kPi - kLeastCorner) {
            return fail(
                ErrorCode::Refused,
                "{} and {} meet at {:.1f} deg: no corner of a patch (limits {:.0f}, {:.0f})",
                name_of(sides[(i + kSides - 1) % kSides]), name_of(sides[i]), degrees(corner),
                degrees(kLeastCorner), degrees(kPi - kLeastCorner));
        }
    }
    return {};
}

double largest_angle(const SplineSurface& surface, const Ribbon& ribbon, const TrimCurve& trim) {
    double worst = 0.0;
    for (int k = 0; k <= kAlong; ++k) {
        const double s = static_cast<double>(k) / kAlong;
        const Vector3d normal = normal_at(surface, trim(s));
        const Vector3d wanted = ribbon.at(s).normal;
        worst = std::max(worst, std::atan2(normal.cross(wanted).norm(), normal.dot(wanted)));
    }
    return worst;
}

// Where ribbon i runs: around the unit square.
TrimCurve border(std::size_t i, const std::shared_ptr<const Walk>& walk) {
    return [i, walk](double s) -> Vector2d {
        const double t = walk->part(s);
        switch (i) {
            case 0:
                return {t, 0.0};
            case 1:
                return {1.0, t};
            case 2:
                return {1.0 - t, 1.0};
            default:
                return {0.0, 1.0 - t};
        }
    };
}

}  // namespace

Result<FillResult> fill_quad(const Hole& hole, const FillOptions& options) {
    if (const auto sides = check_sides(hole); !sides) {
        return tl::unexpected(sides.error());
    }
    const std::vector<Ribbon>& ribbons = hole.loops[0].ribbons;
    std::vector<std::shared_ptr<const Walk>> walks;
    walks.reserve(ribbons.size());
    for (const Ribbon& ribbon : ribbons) {
        walks.push_back(std::make_shared<const Walk>(ribbon));
    }
    const double wanted = std::max(kFitPart * options.tolerance.linear, kFinest * hole.diameter);
    const Opposite in_u = fit_opposite({*walks[0], false}, {*walks[2], true}, wanted);
    const Opposite in_v = fit_opposite({*walks[3], true}, {*walks[1], false}, wanted);
    const double error = std::max(in_u.error, in_v.error);
    if (error > options.tolerance.linear) {
        return fail(ErrorCode::Refused,
                    "a side is met to {:.3g} only by a curve of {} spans (limit {:.3g})", error,
                    kMostSpans, options.tolerance.linear);
    }
    Patch patch;
    patch.fit_error = error;
    patch.exact = false;
    const SplineSurface surface = coons(in_u, in_v);
    if (folds(surface)) {
        return fail(ErrorCode::Refused, "the patch between its four sides folds");
    }
    std::vector<TrimCurve> trims;
    for (std::size_t i = 0; i < kSides; ++i) {
        trims.push_back(border(i, walks[i]));
        const double angle = largest_angle(surface, ribbons[i], trims.back());
        if (ribbons[i].continuity >= Continuity::G1 && angle > options.tolerance.angular) {
            return fail(ErrorCode::Refused,
                        "{}: tangency is asked for, and the patch meets it at {:.3g} deg (limit "
                        "{:.3g})",
                        name_of(ribbons[i]), degrees(angle), degrees(options.tolerance.angular));
        }
    }
    patch.surface = surface;
    patch.wires.push_back(wire_of_loop(0, std::move(trims)));
    FillResult result;
    result.notes.push_back(fmt::format("Coons' patch of {} x {} poles, untrimmed",
                                       surface.count_u(), surface.count_v()));
    result.patches.push_back(std::move(patch));
    return result;
}

}  // namespace suture
