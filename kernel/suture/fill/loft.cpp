#include "suture/fill/loft.h"

#include "suture/fill/concentric/fit.h"
#include "suture/fill/loft/rail.h"
#include "suture/fill/loft/spans.h"

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using loft::LoftEnd;
using loft::LoftSpan;
using loft::Rail;

/// The fit along the sides is so many times nearer than the tolerance: slopes lose a digit.
constexpr double kFitShare = 1e-3;

/// Samples of a free side, to see whether it is the cubic that it has to be.
constexpr int kSamples = 32;

constexpr int kDegree = 5;

/// Parameters of knots that are nearer than this are one.
constexpr double kSameKnot = 1e-9;

Vector3d cubic(const Eigen::VectorXd& rows, double v) {
    const double w = 1.0 - v;
    return w * w * w * rows.segment<3>(0) + 3.0 * w * w * v * rows.segment<3>(3) +
           3.0 * w * v * v * rows.segment<3>(6) + v * v * v * rows.segment<3>(9);
}

/// Where the rails' sides meet the surface is once continuously differentiable along them.
std::vector<concentric::Break> breaks_of(const LoftSpan& span) {
    const auto [low, high] = span.range();
    std::vector<double> places = {low, high};
    for (const double shift : {-1.0, 0.0, 1.0}) {
        for (const double u : span.from.joints()) {
            places.push_back(u + shift);
        }
        for (const double u : span.to.joints()) {
            places.push_back(u + shift + span.shift);
        }
    }
    std::ranges::sort(places);
    std::vector<concentric::Break> breaks;
    for (const double u : places) {
        const bool inside = u >= low && u <= high;
        if (inside && (breaks.empty() || u > breaks.back().at + kSameKnot)) {
            breaks.push_back({u, 1});
        }
    }
    breaks.back().at = high;
    return breaks;
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

/// The sides of a rail on the line v of the domain, in the order of the loop.
void add_rail(const Rail& rail, int loop, double v, double shift, std::vector<EdgeUse>& wire) {
    for (const std::size_t side : rail.sides()) {
        wire.push_back({loop, static_cast<int>(side), false,
                        [rail, side, v, shift](double s) {
                            return Vector2d(rail.place_of(side, s) + shift, v);
                        },
                        false});
    }
}

/// The line across at one end of a span: an inner edge from the first rail to the second, or a free
/// side of the hole.
EdgeUse across(const LoftEnd& end, double u, double shift, bool first) {
    if (end.side) {
        // At u = 1 it is walked from the first rail to the second, at u = 0 back.
        return {0, static_cast<int>(*end.side), false,
                [u, first](double s) { return Vector2d(u, first ? 1.0 - s : s); }, false};
    }
    return {-1, end.edge, first, [u, shift](double s) { return Vector2d(u + shift * s, s); },
            false};
}

/// Whether a free side is the cubic that leaves both neighbours as it does itself.
Result<void> expect_cubic(const LoftSpan& span, const LoftEnd& end, bool first,
                          const RibbonLoop& loop, double tolerance) {
    if (!end.side) {
        return {};
    }
    const Ribbon& side = loop.ribbons[*end.side];
    const Eigen::VectorXd rows = span.column(first ? 0.0 : 1.0);
    for (int i = 0; i <= kSamples; ++i) {
        const double v = static_cast<double>(i) / kSamples;
        const double apart = (side.at(first ? 1.0 - v : v).point - cubic(rows, v)).norm();
        if (apart > tolerance) {
            return fail(ErrorCode::Refused,
                        "{} is {:.3g} from the cubic that is tangent to both neighbours",
                        name_of(side), apart);
        }
    }
    return {};
}

}  // namespace

Result<FillResult> fill_loft(const Hole& hole, const FillOptions& options) {
    if (!hole.through.empty()) {
        return fail(ErrorCode::Refused, "a loft passes no inner points: {} were given",
                    hole.through.size());
    }
    const auto layout = loft::lay_out(hole, find_number(options.own, "tension").value_or(1.0));
    if (!layout) {
        return tl::unexpected(layout.error());
    }
    FillResult result;
    result.inner_edges = layout->inner_edges;
    const int second = static_cast<int>(hole.loops.size()) - 1;
    for (const LoftSpan& span : layout->spans) {
        for (const bool first : {true, false}) {
            auto fits = expect_cubic(span, first ? span.begin : span.end, first, hole.loops.front(),
                                     options.tolerance.linear);
            if (!fits) {
                return tl::unexpected(fits.error());
            }
        }
        const auto fitted =
            concentric::fit_curve([&](double u) { return span.column(u); }, breaks_of(span),
                                  kDegree, kFitShare * options.tolerance.linear);
        Patch patch;
        patch.surface = surface_of(fitted.curve);
        patch.exact = false;
        patch.fit_error = fitted.error;
        std::vector<EdgeUse>& wire = patch.wires.emplace_back();
        add_rail(span.from, 0, 0.0, 0.0, wire);
        wire.push_back(across(span.end, 1.0, span.shift, /*first=*/false));
        add_rail(span.to, second, 1.0, span.shift, wire);
        wire.push_back(across(span.begin, 0.0, span.shift, /*first=*/true));
        result.patches.push_back(std::move(patch));
    }
    return result;
}

}  // namespace suture
