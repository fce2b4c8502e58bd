#include "suture/fill/concentric/closed_spline.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <algorithm>

namespace suture::concentric {
namespace {

/// Knot k of the cyclic sequence, k from minus infinity.
double cyclic_knot(const ClosedSpline& curve, int k) {
    const int n = curve.count();
    const int turns = k >= 0 ? k / n : -((n - 1 - k) / n);
    return curve.knots[static_cast<std::size_t>(k - turns * n)] + turns * curve.period();
}

int wrapped(int i, int n) {
    return ((i % n) + n) % n;
}

}  // namespace

ClosedSpline closed_from(const std::vector<SplineCurve>& sides) {
    ClosedSpline closed;
    closed.degree = sides.front().degree;
    const auto p = static_cast<std::size_t>(closed.degree);
    int n = 0;
    for (const SplineCurve& side : sides) {
        SUTURE_EXPECTS(side.degree == closed.degree);
        n += side.count() - 1;
    }
    closed.poles.resize(2, n);
    int at = 0;
    for (const SplineCurve& side : sides) {
        closed.poles.middleCols(at, side.count() - 1) = side.poles.leftCols(side.count() - 1);
        at += side.count() - 1;
        closed.knots.insert(closed.knots.end(), p, side.begin());
        closed.knots.insert(closed.knots.end(), side.knots.begin() + closed.degree + 1,
                            side.knots.begin() + side.count());
    }
    closed.knots.push_back(sides.back().end());
    return closed;
}

SplineCurve unrolled(const ClosedSpline& curve) {
    const int n = curve.count();
    const int p = curve.degree;
    SplineCurve result{p, {}, Eigen::MatrixXd(2, n + p)};
    for (int k = -p; k <= n + p; ++k) {
        result.knots.push_back(cyclic_knot(curve, k));
    }
    for (int i = 0; i < n + p; ++i) {
        result.poles.col(i) = curve.poles.col(wrapped(i + 1 - p, n));
    }
    return result;
}

SplineCurve clamped(const ClosedSpline& curve) {
    const double begin = curve.knots.front();
    const double end = curve.knots.back();
    std::vector<double> knots(static_cast<std::size_t>(curve.degree + 1), begin);
    std::copy_if(curve.knots.begin(), curve.knots.end(), std::back_inserter(knots),
                 [&](double t) { return begin < t && t < end; });
    knots.insert(knots.end(), static_cast<std::size_t>(curve.degree + 1), end);
    return refined(unrolled(curve), knots);
}

ClosedSpline with_knots(const ClosedSpline& curve, const std::vector<double>& more) {
    ClosedSpline result{curve.degree, curve.knots, {}};
    result.knots.insert(result.knots.end(), more.begin(), more.end());
    std::sort(result.knots.begin(), result.knots.end());
    const auto n = static_cast<int>(result.knots.size()) - 1;
    result.poles.resize(2, n);
    const SplineCurve old = unrolled(curve);
    for (int i = 1; i <= n; ++i) {
        std::vector<double> arguments;
        for (int k = i; k < i + curve.degree; ++k) {
            arguments.push_back(cyclic_knot(result, k));
        }
        const int span = find_span(old.knots, curve.degree, cyclic_knot(result, i - 1));
        result.poles.col(i % n) = blossom(old, span, arguments);
    }
    return result;
}

std::vector<double> nodal_parameters(const ClosedSpline& curve) {
    std::vector<double> nodes;
    for (int i = 0; i < curve.count(); ++i) {
        double sum = 0.0;
        for (int k = i; k < i + curve.degree; ++k) {
            sum += cyclic_knot(curve, k);
        }
        nodes.push_back(sum / curve.degree);
    }
    return nodes;
}

std::vector<double> corner_parameters(const ClosedSpline& curve) {
    std::vector<double> corners;
    for (int i = 0; i < curve.count(); ++i) {
        const double knot = cyclic_knot(curve, i);
        if (cyclic_knot(curve, i - 1) < knot && cyclic_knot(curve, i + curve.degree - 1) == knot) {
            corners.push_back(knot);
        }
    }
    return corners;
}

}  // namespace suture::concentric
