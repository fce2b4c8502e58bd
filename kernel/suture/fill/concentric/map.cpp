#include "suture/fill/concentric/map.h"

#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/medial.h"
#include "suture/fill/concentric/retraction.h"
#include "suture/fill/concentric/simplify.h"
#include "suture/fill/concentric/sites.h"

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

/// Chords of parabolas: fine enough to look round, coarse enough to keep the axis small.
constexpr double kWidestChord = 0.6;

constexpr double kManyTeeth = 5.0;

/// A salience that cuts all branches but the longest: the rays of a regular star are best cut off
/// altogether.
constexpr double kNearlyAll = 5.0;

/// Shorter spans, as a share of the period, are not halved any more.
constexpr double kShortestSpan = 1e-6;

/// The middles of the knot spans that a predicate picks by their ends.
template <class Predicate>
std::vector<double> middles(const ClosedSpline& curve, const Predicate& picked) {
    std::vector<double> result;
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
        const double a = curve.knots[k - 1];
        const double b = curve.knots[k];
        if (b - a > kShortestSpan * curve.period() && picked(a, b)) {
            result.push_back(0.5 * (a + b));
        }
    }
    return result;
}

ClosedSpline refined_everywhere(const ClosedSpline& curve) {
    return with_knots(curve, middles(curve, [](double, double) { return true; }));
}

/// With new knots where the map folds and in the spans beside.
ClosedSpline refined_at(const ClosedSpline& curve, const std::vector<Course>& folds) {
    const double period = curve.period();
    const auto touches = [&](double a, double b) {
        const double beside = b - a;
        return std::any_of(folds.begin(), folds.end(), [&](const Course& fold) {
            for (const double turn : {-period, 0.0, period}) {
                if (a - beside < fold.to + turn && fold.from + turn < b + beside) {
                    return true;
                }
            }
            return false;
        });
    };
    return with_knots(curve, middles(curve, touches));
}

std::string name_of(const std::vector<Course>& folds) {
    const Course& first = folds.front();
    return fmt::format(
        "between s = {:.6g} and {:.6g}{}", first.from, first.to,
        folds.size() > 1 ? fmt::format(" and at {} other places", folds.size() - 1) : "");
}

double largest_radius(const MedialAxis& axis) {
    double largest = 0.0;
    for (const MedialNode& node : axis.nodes) {
        largest = std::max(largest, node.radius);
    }
    return largest;
}

/// The map of one control polygon, with as few branches as the certificate allows.
tl::expected<ConcentricCurve, Folds> map_of(const MedialAxis& axis, const Sites& sites,
                                            const BoundaryPieces& boundary,
                                            const std::vector<double>& corners,
                                            const MapOptions& options) {
    for (const double share : {1.0, 0.25}) {
        if (options.salience > 0.0) {
            auto curve = retract(axis, sites, boundary, corners,
                                 {share * options.salience, options.rest_at_tips});
            if (curve) {
                return curve;
            }
        }
    }
    auto whole = retract(axis, sites, boundary, corners, {0.0, options.rest_at_tips});
    if (!whole && options.salience > 0.0) {
        auto cut = retract(axis, sites, boundary, corners, {kNearlyAll, options.rest_at_tips});
        return cut ? cut : whole;
    }
    return whole;
}

}  // namespace

Result<ConcentricMap> concentric_map(const ClosedSpline& curve, const MapOptions& options) {
    const BoundaryPieces boundary(curve);
    const std::vector<double> corners =
        options.rest_between_corners ? corner_parameters(curve) : std::vector<double>{};
    ConcentricMap map;
    map.refined = curve;
    Error why;
    for (;; ++map.refinements) {
        const auto sites =
            make_sites(map.refined.poles, nodal_parameters(map.refined), curve.period());
        ClosedSpline next;
        // Gears of many teeth want more nodes to be one than is good for all else.
        for (const double same_place : {1.0, kManyTeeth}) {
            const auto axis = sites.and_then([&](const Sites& s) -> Result<MedialAxis> {
                return medial_axis(s, kWidestChord, same_place * kSamePlace);
            });
            if (!axis) {
                why = axis.error();
                next = refined_everywhere(map.refined);
                continue;
            }
            const auto found = map_of(*axis, *sites, boundary, corners, options);
            if (found) {
                map.radius = largest_radius(*axis);
                map.axis = options.flatness > 0.0 ? simplified(*found, boundary, corners,
                                                               options.flatness * map.radius)
                                                  : *found;
                return map;
            }
            why = {ErrorCode::Refused,
                   fmt::format("the map folds {}", name_of(found.error().where))};
            next = refined_at(map.refined, found.error().where);
        }
        if (curve.degree == 1 || map.refinements == options.refinements ||
            next.count() == map.refined.count()) {
            why.message +=
                fmt::format(" (after {} refinements of the control polygon)", map.refinements);
            return tl::unexpected(why);
        }
        map.refined = std::move(next);
    }
}

}  // namespace suture::concentric
