#include "suture/fill/concentric/lifted_axis.h"

#include "suture/fill/concentric/complete_cubic.h"
#include "suture/fill/concentric/fit.h"

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;

constexpr int kMostSpans = 64;

/// Samples per span to measure the error at.
constexpr int kProbes = 3;

Vector2d left_of(const Vector2d& v) {
    return {-v.y(), v.x()};
}

/// A field along a straight line.
struct Line {
    const HeightField& field;
    Vector2d from;
    Vector2d along;

    [[nodiscard]] Vector2d at(double x) const { return from + x * along; }
    [[nodiscard]] double slope_along(double x) const { return field.gradient(at(x)).dot(along); }
    [[nodiscard]] double slope_across(double x) const {
        return field.gradient(at(x)).dot(left_of(along.normalized()));
    }

    [[nodiscard]] SplineCurve height(int spans) const {
        const CompleteCubic cubic(spans);
        MatrixXd data(1, cubic.count());
        data(0, 0) = field.height(at(0.0));
        data(0, 1) = slope_along(0.0);
        for (int k = 1; k < spans; ++k) {
            data(0, k + 1) = field.height(at(static_cast<double>(k) / spans));
        }
        data(0, spans + 1) = slope_along(1.0);
        data(0, spans + 2) = field.height(at(1.0));
        return cubic.spline(data);
    }

    [[nodiscard]] SplineCurve across(int spans) const {
        const auto slope = [&](double x) -> Eigen::VectorXd {
            return Eigen::VectorXd::Constant(1, slope_across(x));
        };
        constexpr int kQuadratic = 2;
        std::vector<Break> knots;
        for (int k = 0; k <= spans; ++k) {
            knots.push_back({static_cast<double>(k) / spans, kQuadratic - 1});
        }
        return interpolated(slope, knots, kQuadratic);
    }
};

}  // namespace

LiftedAxis::LiftedAxis(const ConcentricCurve& axis, const HeightField& field, double accuracy,
                       double angular) {
    for (const Stop& stop : axis.stops) {
        const Vector2d& at = axis.node(stop);
        nodes_[stop.node] = {field.height(at), field.gradient(at)};
    }
    for (const Course& course : courses(axis)) {
        const Ends ends = std::minmax(course.start, course.end);
        if (ends.first == ends.second || edges_.count(ends) > 0) {
            continue;
        }
        const Vector2d from = axis.nodes[static_cast<std::size_t>(ends.first)];
        const Line line{field, from, axis.nodes[static_cast<std::size_t>(ends.second)] - from};
        Edge edge;
        double miss = 0.0;
        for (int spans = 1; spans <= kMostSpans; spans *= 2) {
            edge = {line.height(spans), line.across(spans), spans, line.along};
            miss = 0.0;
            double tilt = 0.0;
            for (int k = 0; k < kProbes * spans; ++k) {
                const double x = (k + 0.4) / (kProbes * spans);
                const MatrixXd jet = evaluate(edge.height, x, 1);
                miss = std::max(miss, std::abs(jet(0, 0) - field.height(line.at(x))));
                tilt =
                    std::max({tilt, std::abs(jet(0, 1) - line.slope_along(x)) / line.along.norm(),
                              std::abs(evaluate(edge.across, x)(0, 0) - line.slope_across(x))});
            }
            if (miss <= accuracy && tilt <= angular) {
                break;
            }
        }
        error_ = std::max(error_, miss);
        edges_.emplace(ends, std::move(edge));
    }
}

LiftedAxis::Point LiftedAxis::at(const Course& course, double s) const {
    if (course.start == course.end) {
        return nodes_.at(course.start);
    }
    const Edge& edge = edges_.at(std::minmax(course.start, course.end));
    const double part = std::clamp((s - course.from) / (course.to - course.from), 0.0, 1.0);
    const double x = course.start < course.end ? part : 1.0 - part;
    const MatrixXd jet = evaluate(edge.height, x, 1);
    const Vector2d gradient = jet(0, 1) / edge.along.squaredNorm() * edge.along +
                              evaluate(edge.across, x)(0, 0) * left_of(edge.along.normalized());
    return {jet(0, 0), gradient};
}

std::vector<double> LiftedAxis::breaks(const Course& course) const {
    std::vector<double> inside;
    if (course.start != course.end) {
        const int spans = edges_.at(std::minmax(course.start, course.end)).spans;
        for (int k = 1; k < spans; ++k) {
            inside.push_back(course.from + (course.to - course.from) * k / spans);
        }
    }
    return inside;
}

}  // namespace suture::concentric
