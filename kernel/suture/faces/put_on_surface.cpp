#include "suture/faces/put_on_surface.h"

#include "suture/faces/foot_points.h"
#include "suture/faces/mark_gap.h"
#include "suture/faces/pcurve.h"
#include "suture/occ/convert.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <vector>

namespace suture {
namespace {

using occ::Handle;
using Trim = std::function<Eigen::Vector2d(double)>;

/// Samples per edge for the distance between its curve and the new surface: at least so many, and
/// so many for each pole of a pcurve, which may be off its feet by as much between any two of them.
constexpr int kSamples = 400;
constexpr int kSamplesPerPole = 4;

/// Golden sections of the intervals about a peak among the samples: below 1e-6 of its width.
constexpr int kSections = 28;

/// Peaks this much lower than the highest sample cannot hide the largest distance.
constexpr double kWorthALook = 0.8;

/// Below this no peak between the samples can ask for a tolerance: rounding alone has hundreds.
const double kUnseen = 0.01 * Precision::Confusion();

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
///
/// Input    enough: a distance above which no larger one is looked for.
double largest_along(double first, double last, const std::function<double(double)>& distance,
                     int intervals = kSamples, double enough = INFINITY) {
    const auto parameter = [&](int k) { return first + (last - first) * k / intervals; };
    std::vector<double> samples;
    for (int k = 0; k <= intervals; ++k) {
        samples.push_back(distance(parameter(k)));
        if (samples.back() > enough) {
            return samples.back();
        }
    }
    const double highest = *std::max_element(samples.begin(), samples.end());
    if (highest < kUnseen) {
        return highest;
    }
    double largest = highest;
    for (int k = 0; k <= intervals; ++k) {
        const int before = std::max(k - 1, 0);
        const int after = std::min(k + 1, intervals);
        const auto value = [&](int i) { return samples[static_cast<std::size_t>(i)]; };
        if (value(k) >= std::max({value(before), value(after), kWorthALook * highest})) {
            largest = std::max(largest, peak(distance, parameter(before), parameter(after)));
        }
    }
    return largest;
}

/// A pcurve need not be nearer to the feet than this share of the gap that they leave, for which so
/// many samples are enough.
constexpr double kShareOfGap = 1e-3;
constexpr int kGapSamples = 50;

/// An edge's own curve.
struct Course {
    TopoDS_Edge edge;
    double first = 0.0, last = 0.0;
    Handle<Geom_Curve> curve;

    explicit Course(const TopoDS_Edge& of)
        : edge(TopoDS::Edge(of.Oriented(TopAbs_FORWARD))),
          curve(BRep_Tool::Curve(edge, first, last)) {}

    /// The largest distance to the points of a surface at the same parameter.
    [[nodiscard]] double distance(const Geom_Surface& surface, const Trim& at,
                                  int intervals = kSamples, double enough = INFINITY) const {
        return largest_along(
            first, last,
            [&](double t) {
                const Eigen::Vector2d uv = at(t);
                return curve->Value(t).Distance(surface.Value(uv.x(), uv.y()));
            },
            intervals, enough);
    }

    [[nodiscard]] double distance(const Geom_Surface& surface,
                                  const Handle<Geom2d_Curve>& pcurve) const {
        const auto spline = occ::cast<Geom2d_BSplineCurve>(pcurve);
        const int poles = spline.IsNull() ? 0 : spline->NbPoles();
        return distance(
            surface, [&](double t) { return occ::from_occ(pcurve->Value(t)); },
            std::max(kSamples, kSamplesPerPole * poles));
    }

    /// The curve on the surface: where the layout has it if that is the place, else at the feet.
    [[nodiscard]] Handle<Geom2d_Curve> laid(const Handle<Geom_Surface>& surface, const Trim& at,
                                            Ends ends, double accuracy) const {
        if (distance(*surface, at, kSamples, accuracy) <= accuracy) {
            return fit_pcurve(at, first, last, *surface, accuracy, Pieces::Few);
        }
        std::array<Eigen::Vector2d, 2> fixed{at(first), at(last)};
        if (ends == Ends::Feet) {
            const std::array vertices{TopExp::FirstVertex(edge), TopExp::LastVertex(edge)};
            for (std::size_t i = 0; i < fixed.size(); ++i) {
                fixed[i] =
                    foot_point(occ::from_occ(BRep_Tool::Pnt(vertices[i])), *surface, fixed[i]);
            }
        }
        const Trim feet = foot_points(curve, first, last, surface, at, fixed);
        // A gap that a file has to show is marked between knots: mark_gap.h.
        const double gap = distance(*surface, feet, kGapSamples);
        return fit_pcurve(feet, first, last, *surface, std::max(accuracy, kShareOfGap * gap),
                          gap > Precision::Confusion() ? Pieces::Cubic : Pieces::Few);
    }

    [[nodiscard]] Placement on(const Handle<Geom_Surface>& surface, const Trim& at, Ends ends,
                               double accuracy) const {
        const Handle<Geom2d_Curve> plain = laid(surface, at, ends, accuracy);
        const double gap = distance(*surface, plain);
        const Handle<Geom2d_Curve> marked = mark_gap(curve, first, last, surface, plain, gap);
        return placement_of(edge, marked, gap, marked == plain ? gap : distance(*surface, marked));
    }
};

/// What a reach asks for: the gap, and a little more where the pcurve marks it.
Placed grow(const TopoDS_Edge& edge, double gap, double reach) {
    if (reach <= BRep_Tool::Tolerance(edge)) {
        return {gap, 0.0};
    }
    const double needed = reach * kMargin;
    const BRep_Builder builder;
    builder.UpdateEdge(edge, needed);
    for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
        builder.UpdateVertex(vertex, needed);
    }
    return {gap, needed};
}

/// A line as a B-spline over the edge's parameters.
Handle<Geom2d_Curve> as_spline(const Handle<Geom2d_Curve>& line, const TopoDS_Edge& edge) {
    double first = 0.0;
    double last = 0.0;
    BRep_Tool::Range(edge, first, last);
    return Geom2dConvert::CurveToBSplineCurve(occ::make<Geom2d_TrimmedCurve>(line, first, last));
}

}  // namespace

Placement place_on_surface(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                           const Trim& at, Ends ends, double accuracy) {
    const Course course(edge);
    if (const auto plane = occ::cast<Geom_Plane>(surface)) {
        const gp_Pln pln = plane->Pln();
        const double gap = largest_along(course.first, course.last, [&](double t) {
            return pln.Distance(course.curve->Value(t));
        });
        return placement_of(edge, {}, gap, gap);
    }
    return course.on(surface, at, ends, accuracy);
}

Placed put_on_surface(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                      const Placement& placement) {
    if (!placement.pcurve.IsNull()) {
        BRep_Builder().UpdateEdge(edge, placement.pcurve, surface, TopLoc_Location(), 0.0);
    }
    return grow(edge, placement.gap, placement.reach);
}

Placed put_on_surface_twice(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                            const Placement& forward, const Placement& reversed) {
    const BRep_Builder builder;
    // OCCT's STEP reader keeps one of them alone where one is a line and the other is none.
    const auto is_line = [](const Placement& placement) {
        return !occ::cast<Geom2d_Line>(placement.pcurve).IsNull();
    };
    const bool mixed = is_line(forward) != is_line(reversed);
    const auto pcurve = [&](const Placement& placement) {
        return mixed && is_line(placement) ? as_spline(placement.pcurve, edge) : placement.pcurve;
    };
    builder.UpdateEdge(edge, pcurve(forward), pcurve(reversed), surface, TopLoc_Location(), 0.0);
    builder.Continuity(edge, surface, surface, TopLoc_Location(), TopLoc_Location(), GeomAbs_CN);
    return grow(edge, std::max(forward.gap, reversed.gap), std::max(forward.reach, reversed.reach));
}

void reach(const TopoDS_Vertex& vertex, const gp_Pnt& point) {
    const double distance = BRep_Tool::Pnt(vertex).Distance(point);
    if (distance > BRep_Tool::Tolerance(vertex)) {
        BRep_Builder().UpdateVertex(vertex, distance * kMargin);
    }
}

}  // namespace suture
