#include "suture/check/certify/spline_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suture::certify {

namespace {

constexpr int kPathDegree = 6;

// How far the box around a path reaches beyond it: this part of its width, of the knot span's, and
// of what lies outside the domain; but no farther than this part of the way to a side that is a
// point.
constexpr double kMargin = 0.1;
constexpr double kLeastMargin = 1e-3;
// Along a side that is a point boxes are wider: there rounding is large against narrow ones.
constexpr double kMarginAlongPole = 0.03;
constexpr double kOutsideMargin = 5.0;
constexpr double kToPole = 0.05;

// A sampled parameter this near the domain's border, as a part of its width, lies on it.
constexpr double kOnBorder = 1e-12;
// A path of which less than this part lies inside is laid along the border.
constexpr double kMostlyOutside = 0.2;

/// The polynomial through values at path_points().
std::vector<double> interpolate(const std::vector<double>& values) {
    // Newton's form, multiplied out.
    const std::vector<double>& x = path_points();
    std::vector<double> d = values;
    for (std::size_t r = 1; r < d.size(); ++r) {
        for (std::size_t i = d.size() - 1; i >= r; --i) {
            d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - r]);
        }
    }
    std::vector<double> powers = {d.back()};
    for (std::size_t i = d.size() - 1; i-- > 0;) {
        powers.insert(powers.begin(), 0.0);
        for (std::size_t k = 0; k + 1 < powers.size(); ++k) {
            powers[k] -= x[i] * powers[k + 1];
        }
        powers[0] += d[i];
    }
    return powers;
}

}  // namespace

const std::vector<double>& path_points() {
    static const std::vector<double> points = [] {
        std::vector<double> result;
        for (int k = kPathDegree; k >= 0; --k) {
            result.push_back(std::cos(std::numbers::pi * (k + 0.5) / (kPathDegree + 1)));
        }
        return result;
    }();
    return points;
}

Path make_path(const std::vector<double>& nodes, const std::vector<double>& knots, int degree,
               const std::array<bool, 2>& ends_in_a_point, bool along_pole) {
    Path path;
    const auto p = static_cast<std::size_t>(degree);
    const double first = knots[p];
    const double last = knots[knots.size() - p - 1];
    const auto [least, most] = std::ranges::minmax(nodes);
    const double on_border = kOnBorder * (last - first) + kMostlyOutside * (most - least);
    path.at_low = most - first <= on_border;
    path.at_high = last - least <= on_border;
    double span_width = last - first;
    for (std::size_t k = p; k + p + 1 < knots.size(); ++k) {
        if (knots[k] < knots[k + 1] && knots[k] <= most && knots[k + 1] >= least) {
            span_width = std::min(span_width, knots[k + 1] - knots[k]);
        }
    }
    const double outside = std::max({0.0, first - least, most - last});
    double margin = kMargin * (most - least) + kOutsideMargin * outside +
                    (along_pole ? kMarginAlongPole : kLeastMargin) * span_width;
    if (ends_in_a_point[0] && least > first) {
        margin = std::min(margin, kToPole * (least - first));
    }
    if (ends_in_a_point[1] && most < last) {
        margin = std::min(margin, kToPole * (last - most));
    }
    path.box = {least - margin, most + margin};
    for (std::size_t k = p; k + p + 1 < knots.size(); ++k) {
        if (knots[k] < knots[k + 1] && knots[k] < path.box.high && knots[k + 1] > path.box.low) {
            path.spans.push_back(static_cast<int>(k));
        }
    }
    const double middle = 0.5 * (path.box.low + path.box.high);
    const double half = 0.5 * (path.box.high - path.box.low);
    for (const int k : path.spans) {
        const auto i = static_cast<std::size_t>(k);
        path.span_ranges.push_back({(knots[i] - middle) / half, (knots[i + 1] - middle) / half});
    }
    path.low = (first - middle) / half;
    path.high = (last - middle) / half;
    if (path.at_low || path.at_high) {
        path.model = TaylorModel(path.at_low ? path.low : path.high);
        return path;
    }
    std::vector<double> values(nodes.size());
    std::transform(nodes.begin(), nodes.end(), values.begin(),
                   [&](double node) { return (node - middle) / half; });
    path.model = TaylorModel(interpolate(values), 0.0);
    const Interval range = path.model.range();
    path.outside = std::max({0.0, path.low - range.low, range.high - path.high});
    return path;
}

double projected(const Interval& gradient, const Path& path) {
    if (path.at_low) {
        return std::max(0.0, -gradient.low);
    }
    return path.at_high ? std::max(0.0, gradient.high) : gradient.magnitude();
}

}  // namespace suture::certify
