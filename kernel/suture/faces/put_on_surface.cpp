#include "suture/faces/put_on_surface.h"

#include "suture/faces/pcurve.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <vector>

namespace suture {
namespace {

using occ::Handle;
using Trim = std::function<Eigen::Vector2d(double)>;

/// Samples per edge for the distance between its curve and the new surface.
constexpr int kSamples = 400;

/// Golden sections of the intervals about a peak among the samples: below 1e-6 of its width.
constexpr int kSections = 28;

/// Peaks this much lower than the highest sample cannot hide the largest distance.
constexpr double kWorthALook = 0.5;

/// A tolerance covers the largest distance found and a little more.
constexpr double kMargin = 1.01;

/// The largest value in an interval that has one peak.
double peak(const std::function<double(double)>& f, double low, double high) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double at_a = f(a);
    double at_b = f(b);
    for (int k = 0; k < kSections; ++k) {
        if (at_a > at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = f(a);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = f(b);
        }
    }
    return std::max(at_a, at_b);
}

/// The largest distance along an edge: BRepCheck samples elsewhere than we do, so that the peaks
/// count.
double largest_along(double first, double last, const std::function<double(double)>& distance) {
    const auto parameter = [&](int k) { return first + (last - first) * k / kSamples; };
    std::vector<double> samples;
    for (int k = 0; k <= kSamples; ++k) {
        samples.push_back(distance(parameter(k)));
    }
    const double highest = *std::max_element(samples.begin(), samples.end());
    double largest = highest;
    for (int k = 0; k <= kSamples; ++k) {
        const int before = std::max(k - 1, 0);
        const int after = std::min(k + 1, kSamples);
        const auto value = [&](int i) { return samples[static_cast<std::size_t>(i)]; };
        if (value(k) >= std::max({value(before), value(after), kWorthALook * highest})) {
            largest = std::max(largest, peak(distance, parameter(before), parameter(after)));
        }
    }
    return largest;
}

/// An edge's own curve.
struct Course {
    double first = 0.0, last = 0.0;
    Handle<Geom_Curve> curve;

    explicit Course(const TopoDS_Edge& edge) : curve(BRep_Tool::Curve(edge, first, last)) {}

    [[nodiscard]] double distance(const Geom_Surface& surface, const Geom2d_Curve& pcurve) const {
        return largest_along(first, last, [&](double t) {
            const gp_Pnt2d uv = pcurve.Value(t);
            return curve->Value(t).Distance(surface.Value(uv.X(), uv.Y()));
        });
    }
};

/// What the gap asks for.
Placed grow(const TopoDS_Edge& edge, double gap) {
    if (gap <= BRep_Tool::Tolerance(edge)) {
        return {gap, 0.0};
    }
    const double needed = gap * kMargin;
    const BRep_Builder builder;
    builder.UpdateEdge(edge, needed);
    for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
        builder.UpdateVertex(vertex, needed);
    }
    return {gap, needed};
}

}  // namespace

Placed put_on_surface(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface, const Trim& at,
                      double accuracy) {
    const Course course(edge);
    if (const auto plane = occ::cast<Geom_Plane>(surface)) {
        const gp_Pln pln = plane->Pln();
        return grow(edge, largest_along(course.first, course.last, [&](double t) {
                        return pln.Distance(course.curve->Value(t));
                    }));
    }
    const Handle<Geom2d_Curve> pcurve =
        fit_pcurve(at, course.first, course.last, *surface, accuracy);
    BRep_Builder().UpdateEdge(edge, pcurve, surface, TopLoc_Location(), 0.0);
    return grow(edge, course.distance(*surface, *pcurve));
}

Placed put_on_surface_twice(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                            const Trim& forward, const Trim& reversed, double accuracy) {
    const Course course(edge);
    const Handle<Geom2d_Curve> one =
        fit_pcurve(forward, course.first, course.last, *surface, accuracy);
    const Handle<Geom2d_Curve> other =
        fit_pcurve(reversed, course.first, course.last, *surface, accuracy);
    BRep_Builder().UpdateEdge(edge, one, other, surface, TopLoc_Location(), 0.0);
    return grow(edge, std::max(course.distance(*surface, *one), course.distance(*surface, *other)));
}

void reach(const TopoDS_Vertex& vertex, const gp_Pnt& point) {
    const double distance = BRep_Tool::Pnt(vertex).Distance(point);
    if (distance > BRep_Tool::Tolerance(vertex)) {
        BRep_Builder().UpdateVertex(vertex, distance * kMargin);
    }
}

}  // namespace suture
