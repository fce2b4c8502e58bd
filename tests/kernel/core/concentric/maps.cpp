/// Concentric maps as lines of JSON, for docs/figures/concentric.py.
#include "suture/fill/concentric/basic.h"
#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/map.h"

#include "kernel/core/concentric/shapes.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace suture {
namespace {

using concentric::ClosedSpline;
using concentric::ConcentricCurve;
using Eigen::Vector2d;
using shapes::Points;

constexpr int kPerSpan = 16;

std::string text_of(const Points& points) {
    std::vector<std::string> parts;
    for (const Vector2d& p : points) {
        parts.push_back(fmt::format("[{:.6g},{:.6g}]", p.x(), p.y()));
    }
    return fmt::format("[{}]", fmt::join(parts, ","));
}

std::string text_of(const std::vector<Points>& lines) {
    std::vector<std::string> parts;
    for (const Points& line : lines) {
        parts.push_back(text_of(line));
    }
    return fmt::format("[{}]", fmt::join(parts, ","));
}

Points polygon_of(const ClosedSpline& curve) {
    Points points;
    for (int i = 0; i <= curve.count(); ++i) {
        points.emplace_back(curve.poles.col(i % curve.count()));
    }
    return points;
}

/// Poles of the tensor-product surface: two rows over the knots of both curves.
int poles_of(const ClosedSpline& curve, const ConcentricCurve& axis) {
    return 2 * (curve.count() + curve.degree * axis.count() + 1);
}

void print(std::string_view figure, std::string_view title, const ClosedSpline& curve,
           const std::vector<Points>& axis, const ConcentricCurve* map) {
    const SplineCurve around = concentric::unrolled(curve);
    const int n = kPerSpan * curve.count();
    const auto parameter = [&](int k) { return curve.begin() + curve.period() * k / n; };
    const auto point = [&](double s, double t) -> Vector2d {
        return (1.0 - t) * Vector2d(evaluate(around, s)) + t * evaluate(*map, s);
    };
    std::vector<Points> net;
    std::string tail;
    if (map != nullptr) {
        for (const double t : {0.25, 0.5, 0.75}) {
            Points& line = net.emplace_back();
            for (int k = 0; k <= n; ++k) {
                line.push_back(point(parameter(k), t));
            }
        }
        for (int k = 0; k < n; k += kPerSpan / 4) {
            net.push_back({point(parameter(k), 0.0), point(parameter(k), 1.0)});
        }
        const concentric::BoundaryPieces boundary(curve);
        tail = fmt::format(",\"folds\":{},\"outside\":{},\"nodes\":{},\"poles\":{}",
                           folded_courses(boundary, *map).size(),
                           courses_outside(boundary, *map).size(), used_nodes(*map),
                           poles_of(curve, *map));
    }
    Points border;
    for (int k = 0; k <= n; ++k) {
        border.emplace_back(evaluate(around, parameter(k)));
    }
    fmt::print(
        "{{\"figure\":\"{}\",\"title\":\"{}\",\"boundary\":{},\"polygon\":{},\"axis\":{},"
        "\"net\":{}{}}}\n",
        figure, title, text_of(border), text_of(polygon_of(curve)), text_of(axis), text_of(net),
        tail);
}

std::vector<Points> lines_of(const ConcentricCurve& axis) {
    std::vector<Points> lines;
    for (const concentric::Course& c : courses(axis)) {
        lines.push_back({axis.nodes[static_cast<std::size_t>(c.start)],
                         axis.nodes[static_cast<std::size_t>(c.end)]});
    }
    return lines;
}

concentric::Sites sites_of(const ClosedSpline& curve) {
    return concentric::make_sites(curve.poles, nodal_parameters(curve), curve.period()).value();
}

std::vector<Points> medial_lines(const ClosedSpline& curve) {
    const auto axis = concentric::medial_axis(sites_of(curve), 0.1).value();
    std::vector<Points> lines;
    for (std::size_t k = 0; k < axis.walk.size(); ++k) {
        const auto at = [&](std::size_t i) {
            const auto node = static_cast<std::size_t>(axis.walk[i % axis.walk.size()].node);
            return axis.nodes[node].point;
        };
        lines.push_back({at(k), at(k + 1)});
    }
    return lines;
}

ConcentricCurve basic(const ClosedSpline& curve) {
    const concentric::Sites sites = sites_of(curve);
    return basic_axis(concentric::medial_axis(sites, 0.1).value(), sites);
}

ConcentricCurve robust(const ClosedSpline& curve, double salience = 0.1, double flatness = 0.02) {
    return concentric::concentric_map(curve, {salience, flatness, true, 8}).value().axis;
}

void print(std::string_view figure, std::string_view title, const ClosedSpline& curve,
           const ConcentricCurve& map) {
    print(figure, title, curve, lines_of(map), &map);
}

ClosedSpline halved(const ClosedSpline& curve) {
    std::vector<double> middles;
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
        middles.push_back(0.5 * (curve.knots[k - 1] + curve.knots[k]));
    }
    return concentric::with_knots(curve, middles);
}

/// A hand with fingers of several lengths.
Points complicated() {
    return {{0, 0},     {3, -0.5},  {6, 0.5}, {8.5, -1},   {10, 1},    {8, 2.2},
            {9.5, 4.5}, {8.2, 5.4}, {6.2, 3}, {5.8, 6.5},  {4.2, 6.6}, {4, 3.4},
            {2, 6},     {0.8, 5.2}, {2, 2.8}, {-1.5, 3.6}, {-2, 2.2},  {0.2, 1.6}};
}

Points sharp() {
    return {{0, 0},   {4, 1.2}, {9, -1.5}, {6, 2},  {10, 5},
            {5, 3.4}, {2.5, 7}, {2.6, 3},  {-2, 4}, {1, 1.6}};
}

void figures() {
    print("6", "rectangle", shapes::polygon(shapes::rectangle()),
          robust(shapes::polygon(shapes::rectangle()), 0.0, 0.0));
    const ClosedSpline step =
        shapes::spline({{0, 0}, {3, -0.6}, {6, 0}, {6.5, 3}, {4, 2}, {2, 3.4}, {-0.5, 2.6}}, 3);
    print("8", "the curve and its control polygon", step, {}, nullptr);
    print("8", "medial axis of the polygon", step, medial_lines(step), nullptr);
    print("8", "concentric axis", step, lines_of(basic(step)), nullptr);
    print("8", "sweep surface", step, basic(step));
    print("9", "degree 1", shapes::polygon(shapes::pentagon()),
          basic(shapes::polygon(shapes::pentagon())));
    print("9", "degree 3", shapes::spline(shapes::pentagon(), 3),
          basic(shapes::spline(shapes::pentagon(), 3)));
    const Points bar = {{0, 0}, {12, 0}, {12, 0.8}, {0, 0.8}};
    const ClosedSpline cubic = shapes::spline(bar, 3);
    print("10", "degree 1", shapes::polygon(bar), basic(shapes::polygon(bar)));
    print("10", "degree 3: the axis leaves the curve", cubic, basic(cubic));
    const ClosedSpline fine = halved(halved(cubic));
    print("11", "refined control polygon", fine, robust(fine, 0.02, 0.0));
    print("11", "coarse axis moved onto it", cubic,
          moved_onto(basic(cubic), robust(fine, 0.02, 0.0)));
    print("11", "certified, few nodes (default)", cubic, robust(cubic));
    for (const auto& [figure, points] :
         {std::pair("12", complicated()), std::pair("13", sharp())}) {
        print(figure, "degree 1", shapes::polygon(points), robust(shapes::polygon(points)));
        const ClosedSpline curve = shapes::spline(points, 3);
        print(figure, "degree 3, all nodes", curve, robust(curve, 0.0, 0.0));
        print(figure, "degree 3, few nodes (default)", curve, robust(curve));
    }
}

}  // namespace
}  // namespace suture

int main() {
    suture::figures();
    return 0;
}
