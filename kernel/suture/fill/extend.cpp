#include "suture/fill/extend.h"

#include "suture/base/contract.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Samples per side from which the hole's range of angles is taken.
constexpr int kSamples = 32;

/// A sphere is turned so that its poles lie away from the hole when a side comes nearer to one than
/// this: 10 degrees keeps the parametrisation within a factor of six.
constexpr double kPoleDistance = radians(10.0);

/// Weights at both ends of a closed B-spline that differ by rounding only.
constexpr double kSameWeight = 1e-12;

/// The angle nearest to `centre` among angle + 2 pi k.
double near(double angle, double centre) {
    return centre + std::remainder(angle - centre, 2.0 * kPi);
}

/// The surface all sides share, or the two sides that differ.
Result<const Support*> common_support(const Hole& hole, const FillOptions& options) {
    const Ribbon& first = hole.loops.front().ribbons.front();
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            if (!ribbon.support) {
                return fail(ErrorCode::Refused, "face {} lies on a surface without a closed form",
                            ribbon.face);
            }
            if (!same_surface(first.support->surface, ribbon.support->surface, ribbon.at(0.5).point,
                              hole.diameter, options.tolerance.linear)) {
                return fail(ErrorCode::Refused,
                            "the neighbours lie on different surfaces: face {} ({}) and face {} "
                            "({})",
                            first.face, kind_name(first.support->surface), ribbon.face,
                            kind_name(ribbon.support->surface));
            }
        }
    }
    return &*first.support;
}

/// Where all sides run in the domain, unwrapped: continuous around each loop, and the loops in one
/// period.
struct Unwrapped {
    Vector2d low = Vector2d::Constant(INFINITY);
    Vector2d high = Vector2d::Constant(-INFINITY);
    Vector2d winding = Vector2d::Zero();  ///< largest change around a loop

    [[nodiscard]] Vector2d centre() const { return 0.5 * (low + high); }
    [[nodiscard]] Vector2d size() const { return high - low; }
};

Unwrapped unwrap(const Hole& hole, const Surface& surface) {
    const bool round_u = periodic_u(surface);
    const bool round_v = periodic_v(surface);
    Unwrapped result;
    for (const RibbonLoop& loop : hole.loops) {
        Vector2d low = Vector2d::Constant(INFINITY);
        Vector2d high = Vector2d::Constant(-INFINITY);
        const Vector2d start = parameters_of(surface, loop.ribbons.front().at(0.0).point);
        Vector2d now = start;
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k <= kSamples; ++k) {
                const double s = static_cast<double>(k) / kSamples;
                const Vector2d uv = parameters_of(surface, ribbon.at(s).point);
                now.x() = round_u ? near(uv.x(), now.x()) : uv.x();
                now.y() = round_v ? near(uv.y(), now.y()) : uv.y();
                low = low.cwiseMin(now);
                high = high.cwiseMax(now);
            }
        }
        result.winding = result.winding.cwiseMax((now - start).cwiseAbs());
        if (result.low.allFinite()) {  // an island: into the period of the first loop
            const Vector2d centre = 0.5 * (low + high);
            Vector2d shift = Vector2d::Zero();
            shift.x() = round_u ? near(centre.x(), result.centre().x()) - centre.x() : 0.0;
            shift.y() = round_v ? near(centre.y(), result.centre().y()) - centre.y() : 0.0;
            low += shift;
            high += shift;
        }
        result.low = result.low.cwiseMin(low);
        result.high = result.high.cwiseMax(high);
    }
    return result;
}

/// Turns a frame about its axis so that u = 0 lies opposite to the angle `centre`.
void turn(Frame& frame, double centre) {
    const double angle = centre - kPi;
    const Vector3d x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    frame.x = x.normalized();
    frame.y = frame.z.cross(frame.x);
}

/// A frame for a sphere in which the hole lies on the equator, with the poles as far away from its
/// sides as possible.
Frame away_from_poles(const Hole& hole, const Sphere& sphere) {
    std::vector<Vector3d> directions;
    Vector3d mean = Vector3d::Zero();
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k < kSamples; ++k) {
                const RibbonPoint p = ribbon.at(static_cast<double>(k) / kSamples);
                directions.push_back((p.point - sphere.frame.origin).normalized());
                mean += directions.back() * p.tangent.norm();
            }
        }
    }
    Frame best = sphere.frame;
    const double size = mean.norm();
    const Vector3d middle = size > 0.0 ? Vector3d(mean / size) : sphere.frame.x;
    const Vector3d a = middle.unitOrthogonal();
    const Vector3d b = middle.cross(a);
    double best_distance = -1.0;
    constexpr int kTries = 36;
    for (int k = 0; k < kTries; ++k) {
        const double angle = kPi * k / kTries;
        const Vector3d z = std::cos(angle) * a + std::sin(angle) * b;
        double nearest = INFINITY;
        for (const Vector3d& d : directions) {
            nearest =
                std::min(nearest, kPi / 2.0 - std::abs(std::asin(std::clamp(z.dot(d), -1.0, 1.0))));
        }
        if (nearest > best_distance) {
            best_distance = nearest;
            best.z = z;
            best.x = -middle;
            best.y = best.z.cross(best.x);
        }
    }
    return best;
}

Result<FillResult> patch_on(Surface surface, std::vector<std::vector<TrimCurve>> trims,
                            const Hole& hole) {
    Patch patch;
    patch.trims = std::move(trims);
    // Outward as the neighbours are; they must agree among themselves.
    int outward = 0;
    int inward = 0;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        const auto& ribbons = hole.loops[l].ribbons;
        for (std::size_t i = 0; i < ribbons.size(); ++i) {
            const Vector2d uv = patch.trims[l][i](0.5);
            const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
            ++(jet.u.cross(jet.v).dot(ribbons[i].at(0.5).normal) > 0.0 ? outward : inward);
        }
    }
    if (outward > 0 && inward > 0) {
        return fail(ErrorCode::Refused,
                    "{} of the {} sides have their neighbour oriented against the others'",
                    std::min(outward, inward), outward + inward);
    }
    patch.reversed = inward > 0;
    patch.surface = std::move(surface);
    return FillResult{{std::move(patch)}, {}};
}

Result<FillResult> extend_closed_form(const Hole& hole, Surface surface) {
    Unwrapped range = unwrap(hole, surface);
    if (auto* sphere = std::get_if<Sphere>(&surface)) {
        const double limit = kPi / 2.0 - kPoleDistance;
        if (range.winding.x() > kPi || range.low.y() < -limit || range.high.y() > limit) {
            sphere->frame = away_from_poles(hole, *sphere);
            range = unwrap(hole, surface);
        }
    }
    if (range.winding.maxCoeff() > kPi) {
        return fail(ErrorCode::Refused,
                    "the hole goes all the way around the axis of the {} of face {}",
                    kind_name(surface), hole.loops.front().ribbons.front().face);
    }
    if ((periodic_u(surface) && range.size().x() >= 2.0 * kPi) ||
        (periodic_v(surface) && range.size().y() >= 2.0 * kPi)) {
        return fail(ErrorCode::Refused, "the hole overlaps itself around the axis of the {}",
                    kind_name(surface));
    }
    std::visit(
        [&](auto& form) {
            using T = std::decay_t<decltype(form)>;
            if constexpr (!std::is_same_v<T, SplineSurface> && !std::is_same_v<T, Plane>) {
                turn(form.frame, range.centre().x());
            }
        },
        surface);
    const Vector2d centre(kPi, range.centre().y());
    const bool round_u = periodic_u(surface);
    const bool round_v = periodic_v(surface);
    std::vector<std::vector<TrimCurve>> trims;
    for (const RibbonLoop& loop : hole.loops) {
        auto& row = trims.emplace_back();
        for (const Ribbon& ribbon : loop.ribbons) {
            row.emplace_back([surface, at = ribbon.at, centre, round_u, round_v](double s) {
                Vector2d uv = parameters_of(surface, at(s).point);
                uv.x() = round_u ? near(uv.x(), centre.x()) : uv.x();
                uv.y() = round_v ? near(uv.y(), centre.y()) : uv.y();
                return uv;
            });
        }
    }
    return patch_on(std::move(surface), std::move(trims), hole);
}

/// The period of a B-spline surface that closes on itself in u, v; 0 where it does not.
Vector2d periods_of(const SplineSurface& spline, double distance) {
    const int nu = spline.count_u();
    const int nv = spline.count_v();
    const auto apart = [&](int a, int b) {
        return (spline.poles.col(a) - spline.poles.col(b)).norm() > distance ||
               (spline.rational() &&
                std::abs(spline.weights[a] - spline.weights[b]) > kSameWeight * spline.weights[a]);
    };
    bool closed_u = true;
    bool closed_v = true;
    for (int j = 0; j < nv; ++j) {
        closed_u = closed_u && !apart(spline.index(0, j), spline.index(nu - 1, j));
    }
    for (int i = 0; i < nu; ++i) {
        closed_v = closed_v && !apart(spline.index(i, 0), spline.index(i, nv - 1));
    }
    const auto at = [](const std::vector<double>& knots, int i) {
        return knots[static_cast<std::size_t>(i)];
    };
    return {closed_u ? at(spline.knots_u, nu) - at(spline.knots_u, spline.degree_u) : 0.0,
            closed_v ? at(spline.knots_v, nv) - at(spline.knots_v, spline.degree_v) : 0.0};
}

/// By which multiple of the period each side has to move so that the loop is continuous.
std::vector<std::vector<Vector2d>> shifts_of(const Hole& hole, const Vector2d& period,
                                             Vector2d& winding) {
    const auto jump = [&](const Vector2d& from, const Vector2d& to) {
        Vector2d k = Vector2d::Zero();
        for (int c = 0; c < 2; ++c) {
            k[c] = period[c] > 0.0 ? std::round((from[c] - to[c]) / period[c]) * period[c] : 0.0;
        }
        return k;
    };
    std::vector<std::vector<Vector2d>> shifts;
    for (const RibbonLoop& loop : hole.loops) {
        auto& row = shifts.emplace_back();
        Vector2d end = loop.ribbons.front().support->uv(0.0);
        const Vector2d start = end;
        for (const Ribbon& ribbon : loop.ribbons) {
            row.push_back(jump(end, ribbon.support->uv(0.0)));
            end = ribbon.support->uv(1.0) + row.back();
        }
        winding = winding.cwiseMax(jump(end, start).cwiseAbs());
    }
    return shifts;
}

/// The surface on a domain that contains [low, high]: periods are repeated, borders extended.
SplineSurface covering(const SplineSurface& spline, const Vector2d& period, const Vector2d& low,
                       const Vector2d& high) {
    SplineSurface result = spline;
    for (int c = 0; c < 2; ++c) {
        if (!(period[c] > 0.0)) {
            continue;
        }
        const auto& knots = c == 0 ? spline.knots_u : spline.knots_v;
        const double begin =
            knots[static_cast<std::size_t>(c == 0 ? spline.degree_u : spline.degree_v)];
        const int before = static_cast<int>(std::max(0.0, std::ceil((begin - low[c]) / period[c])));
        const int turns =
            std::max(1, before + static_cast<int>(std::ceil((high[c] - begin) / period[c])));
        if (turns > 1 || before > 0) {
            result = c == 0 ? repeated_u(result, turns, before) : repeated_v(result, turns, before);
        }
    }
    return extended(result, low.x(), high.x(), low.y(), high.y());
}

Result<FillResult> extend_spline(const Hole& hole, const SplineSurface& spline,
                                 const FillOptions& options) {
    const Vector2d period = periods_of(spline, options.tolerance.linear);
    Vector2d winding = Vector2d::Zero();
    const auto shifts = shifts_of(hole, period, winding);
    if (winding.maxCoeff() > 0.0) {
        return fail(ErrorCode::Refused,
                    "the hole goes all the way around the closed B-spline surface of face {}",
                    hole.loops.front().ribbons.front().face);
    }
    Vector2d low = Vector2d::Constant(INFINITY);
    Vector2d high = Vector2d::Constant(-INFINITY);
    std::vector<std::vector<TrimCurve>> trims;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        auto& row = trims.emplace_back();
        for (std::size_t i = 0; i < hole.loops[l].ribbons.size(); ++i) {
            row.emplace_back([uv = hole.loops[l].ribbons[i].support->uv, shift = shifts[l][i]](
                                 double s) -> Vector2d { return uv(s) + shift; });
            for (int k = 0; k <= kSamples; ++k) {
                const Vector2d at = row.back()(static_cast<double>(k) / kSamples);
                low = low.cwiseMin(at);
                high = high.cwiseMax(at);
            }
        }
    }
    return patch_on(covering(spline, period, low, high), std::move(trims), hole);
}

}  // namespace

Result<FillResult> fill_extend(const Hole& hole, const FillOptions& options) {
    SUTURE_EXPECTS(!hole.loops.empty() && !hole.loops.front().ribbons.empty());
    const auto support = common_support(hole, options);
    if (!support) {
        return tl::unexpected(support.error());
    }
    if (const auto* spline = std::get_if<SplineSurface>(&(*support)->surface)) {
        return extend_spline(hole, *spline, options);
    }
    return extend_closed_form(hole, (*support)->surface);
}

}  // namespace suture
