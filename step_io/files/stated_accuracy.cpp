#include "files/stated_accuracy.h"

#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>

#include <algorithm>

namespace suture::io {

namespace {

/// What a file has of a number, and what a reader projects, is not exact.
constexpr double kMargin = 1.1;

/// OCCT's reader takes a curve on a surface as it is up to twice the stated accuracy.
constexpr double kTrusted = 0.5;

/// Between one value and the next.
constexpr double kFurther = 10.0;

/// How far the ends of an edge's curve on a face are from those of its curve in space.
double miss_at_ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0;
    double last = 0.0;
    const occ::Handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    double first2d = 0.0;
    double last2d = 0.0;
    const occ::Handle<Geom2d_Curve> pcurve = BRep_Tool::CurveOnSurface(edge, face, first2d, last2d);
    if (curve.IsNull() || pcurve.IsNull()) {
        return 0.0;
    }
    const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(face);
    const auto miss = [&](double t, double t2d) {
        const gp_Pnt2d uv = pcurve->Value(t2d);
        return curve->Value(t).Distance(surface->Value(uv.X(), uv.Y()));
    };
    return std::max(miss(first, first2d), miss(last, last2d));
}

}  // namespace

std::vector<double> accuracies_to_state(double own, std::span<const TopoDS_Face> faces) {
    double ends = 0.0;
    double tolerance = 0.0;
    for (const TopoDS_Face& face : faces) {
        for (const TopoDS_Edge& edge : occ::edges_of(face)) {
            ends = std::max(ends, miss_at_ends(edge, face));
            tolerance = std::max(tolerance, BRep_Tool::Tolerance(edge));
        }
    }
    const double least = own > 0.0 ? own : Precision::Confusion();
    std::vector<double> values{std::max(least, kMargin * std::max(ends, kTrusted * tolerance))};
    for (const double value : {kMargin * tolerance, kFurther * kMargin * tolerance}) {
        if (value > values.back()) {
            values.push_back(value);
        }
    }
    return values;
}

}  // namespace suture::io
