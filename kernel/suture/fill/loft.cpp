#include "suture/fill/loft.h"

#include "suture/fill/concentric/fit.h"

#include <Eigen/Geometry>

#include <cmath>
#include <optional>

namespace suture {
namespace {

using Eigen::Vector3d;

/// The fit along the sides is so many times nearer than the tolerance: slopes lose a digit.
constexpr double kFitShare = 1e-3;

/// Samples of a free side, to see whether it is the cubic that it has to be.
constexpr int kSamples = 32;

constexpr int kDegree = 5;

bool is_curve(const Ribbon& ribbon) {
    return ribbon.face == 0;
}

/// A tangent vector of a neighbour in the frame of its ribbon.
struct Leaving {
    double inward = 0.0;
    double along = 0.0;
};

Leaving leaving_of(const RibbonPoint& point, const Vector3d& vector) {
    return {vector.dot(point.inward), vector.dot(point.tangent.normalized())};
}

/// One of the two sides that are bridged, run through in one direction.
struct Rail {
    const Ribbon* ribbon = nullptr;
    bool backwards = false;
    Leaving first, last;  ///< how the surface leaves its ends

    [[nodiscard]] RibbonPoint at(double u) const { return ribbon->at(backwards ? 1.0 - u : u); }

    /// How it leaves the side between them: in the neighbour's tangent plane everywhere.
    [[nodiscard]] Vector3d leaving(double u) const {
        const RibbonPoint point = at(u);
        const double inward = (1.0 - u) * first.inward + u * last.inward;
        const double along = (1.0 - u) * first.along + u * last.along;
        return inward * point.inward + along * point.tangent.normalized();
    }
};

/// The four rows of Bezier points across at u, one below the other.
Eigen::VectorXd column(const Rail& from, const Rail& to, double u) {
    const Vector3d a = from.at(u).point;
    const Vector3d b = to.at(u).point;
    Eigen::VectorXd rows(12);
    rows << a, a + from.leaving(u) / 3.0, b + to.leaving(u) / 3.0, b;
    return rows;
}

Vector3d cubic(const Eigen::VectorXd& rows, double v) {
    const double w = 1.0 - v;
    return w * w * w * rows.segment<3>(0) + 3.0 * w * w * v * rows.segment<3>(3) +
           3.0 * w * v * v * rows.segment<3>(6) + v * v * v * rows.segment<3>(9);
}

/// The side from which the other three go on as a curve, a side and a curve.
std::optional<std::size_t> first_rail(const Hole& hole) {
    if (hole.loops.size() != 1 || hole.loops.front().ribbons.size() != 4) {
        return std::nullopt;
    }
    const std::vector<Ribbon>& sides = hole.loops.front().ribbons;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        if (!is_curve(sides[k]) && is_curve(sides[k + 1]) && !is_curve(sides[k + 2]) &&
            is_curve(sides[(k + 3) % 4])) {
            return k;
        }
    }
    return std::nullopt;
}

SplineSurface surface_of(const SplineCurve& fitted) {
    SplineSurface surface;
    surface.degree_u = fitted.degree;
    surface.degree_v = 3;
    surface.knots_u = fitted.knots;
    surface.knots_v = {0, 0, 0, 0, 1, 1, 1, 1};
    const int n = fitted.count();
    surface.poles.resize(3, 4 * static_cast<Eigen::Index>(n));
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < n; ++i) {
            surface.poles.col(i + n * row) = fitted.poles.col(i).segment<3>(3 * row);
        }
    }
    return surface;
}

}  // namespace

Result<FillResult> fill_loft(const Hole& hole, const FillOptions& options) {
    const auto k = first_rail(hole);
    if (!k) {
        return fail(ErrorCode::Refused,
                    "the hole is no bridge: it needs four sides, two opposite ones of them curves "
                    "without a face");
    }
    const std::vector<Ribbon>& sides = hole.loops.front().ribbons;
    const Ribbon& curve = sides[*k + 1];       // at u = 1, from the first rail to the second
    const Ribbon& back = sides[(*k + 3) % 4];  // at u = 0, from the second to the first
    Rail from{&sides[*k], false, {}, {}};
    Rail to{&sides[*k + 2], true, {}, {}};
    from.first = leaving_of(from.at(0.0), -back.at(1.0).tangent);
    from.last = leaving_of(from.at(1.0), curve.at(0.0).tangent);
    to.first = leaving_of(to.at(0.0), back.at(0.0).tangent);
    to.last = leaving_of(to.at(1.0), -curve.at(1.0).tangent);
    for (int i = 0; i <= kSamples; ++i) {
        const double v = static_cast<double>(i) / kSamples;
        for (const auto& [side, u, s] :
             {std::tuple(&curve, 1.0, v), std::tuple(&back, 0.0, 1.0 - v)}) {
            const double apart = (side->at(s).point - cubic(column(from, to, u), v)).norm();
            if (apart > options.tolerance.linear) {
                return fail(ErrorCode::Refused,
                            "{} is {:.3g} from the cubic that is tangent to both neighbours",
                            name_of(*side), apart);
            }
        }
    }
    const auto fitted =
        concentric::fit_curve([&](double u) { return column(from, to, u); }, {{0.0, 0}, {1.0, 0}},
                              kDegree, kFitShare * options.tolerance.linear);
    Patch patch;
    patch.surface = surface_of(fitted.curve);
    patch.exact = false;
    patch.fit_error = fitted.error;
    std::vector<TrimCurve> trims(4);
    trims[*k] = [](double s) { return Eigen::Vector2d(s, 0.0); };
    trims[*k + 1] = [](double s) { return Eigen::Vector2d(1.0, s); };
    trims[*k + 2] = [](double s) { return Eigen::Vector2d(1.0 - s, 1.0); };
    trims[(*k + 3) % 4] = [](double s) { return Eigen::Vector2d(0.0, 1.0 - s); };
    patch.wires = {wire_of_loop(0, std::move(trims))};
    FillResult result;
    result.patches.push_back(std::move(patch));
    return result;
}

}  // namespace suture
