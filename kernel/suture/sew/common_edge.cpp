#include "suture/sew/common_edge.h"

#include "suture/faces/foot_points.h"
#include "suture/faces/pcurve.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/sew/free_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomLib.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace suture {

namespace {

using occ::Handle;

/// Points of an edge at which its distance from a pcurve is taken: as many as BRepCheck takes
/// first, and if there is any distance, so many that none between them is missed by more than the
/// margin.
constexpr int kFewSamples = 23;
constexpr int kManySamples = 10 * kFewSamples;
constexpr double kMargin = 1.02;

/// A pcurve that keeps this close to the gap need not be made anew.
constexpr double kNearGap = 1.2;

/// A pcurve need not be nearer to the feet than this share of the gap that they leave.
constexpr double kShareOfGap = 0.01;

/// In parameters: far more than rounding, far less than a period.
constexpr double kSamePcurve = 1e-3;

/// Curve and surface of an edge and a face, both in the edge's own coordinates.
struct Geometry {
    Handle<Geom_Curve> curve;
    Handle<Geom_Surface> surface;
    double first = 0.0;
    double last = 0.0;
    gp_Trsf to_model;

    [[nodiscard]] double distance(const Geom2d_Curve& pcurve) const {
        const double seen = distance(pcurve, kFewSamples);
        return seen <= 0.1 * Precision::Confusion() ? seen : distance(pcurve, kManySamples);
    }

  private:
    [[nodiscard]] double distance(const Geom2d_Curve& pcurve, int samples) const {
        double largest = 0.0;
        for (int i = 0; i <= samples; ++i) {
            const double t = first + (last - first) * i / samples;
            const gp_Pnt2d uv = pcurve.Value(t);
            largest = std::max(largest, surface->Value(uv.X(), uv.Y()).Distance(curve->Value(t)));
        }
        return largest;
    }
};

/// The other edge's own pcurve, and the range of it that belongs to the part, in the direction of
/// the kept edge.
struct OwnPcurve {
    Handle<Geom2d_Curve> curve;
    double from = 0.0;
    double to = 0.0;
};

OwnPcurve own_pcurve(const EdgePart& gone, bool same_way) {
    OwnPcurve own;
    own.curve = BRep_Tool::CurveOnSurface(gone.edge, gone.face, own.from, own.to);
    if (own.curve.IsNull()) {
        return own;
    }
    // of an edge whose pcurve has a range of its own, the same share of it
    double first = 0.0;
    double last = 0.0;
    BRep_Tool::Range(gone.edge, first, last);
    const double pace = (own.to - own.from) / (last - first);
    own.to = own.from + pace * (gone.last - first);
    own.from += pace * (gone.first - first);
    if (!same_way) {
        const double end = own.curve->ReversedParameter(own.from);
        own.from = own.curve->ReversedParameter(own.to);
        own.to = end;
        own.curve = own.curve->Reversed();
    }
    return own;
}

/// The same curve, running evenly from `first` to `last`.
Handle<Geom2d_Curve> moved_pcurve(const OwnPcurve& own, double first, double last) {
    if (const auto spline = occ::cast<Geom2d_BSplineCurve>(own.curve);
        !spline.IsNull() && !spline->IsPeriodic()) {
        const auto moved = occ::cast<Geom2d_BSplineCurve>(spline->Copy());
        TColStd_Array1OfReal knots(1, moved->NbKnots());
        moved->Knots(knots);
        for (double& knot : knots) {
            knot = first + (knot - own.from) * (last - first) / (own.to - own.from);
        }
        moved->SetKnots(knots);
        return moved;
    }
    Handle<Geom2d_Curve> moved;
    GeomLib::SameRange(Precision::PConfusion(), own.curve, own.from, own.to, first, last, moved);
    return moved;
}

/// The edge's own foot points on the surface, looked for where the other edge lies.
Handle<Geom2d_Curve> foot_pcurve(const Geometry& geometry, const OwnPcurve& own,
                                 const EdgePart& gone, bool same_way, double gap) {
    const BRepAdaptor_Curve curve(gone.edge);
    const auto beside = [&](double t) -> Eigen::Vector2d {
        const double share = (t - geometry.first) / (geometry.last - geometry.first);
        const double guess =
            gone.first + (same_way ? share : 1.0 - share) * (gone.last - gone.first);
        const gp_Pnt here = geometry.curve->Value(t).Transformed(geometry.to_model);
        const FootPoint foot = foot_point(curve, gone.first, gone.last, occ::from_occ(here), guess);
        const double along = (foot.parameter - gone.first) / (gone.last - gone.first);
        return occ::from_occ(
            own.curve->Value(own.from + (same_way ? along : 1.0 - along) * (own.to - own.from)));
    };
    const auto foot = [&](double t) {
        return foot_point(occ::from_occ(geometry.curve->Value(t)), *geometry.surface, beside(t));
    };
    const auto feet = foot_points(geometry.curve, geometry.first, geometry.last, geometry.surface,
                                  beside, {foot(geometry.first), foot(geometry.last)});
    return fit_pcurve(feet, geometry.first, geometry.last, *geometry.surface,
                      std::max(0.1 * Precision::Confusion(), kShareOfGap * gap));
}

struct Placed {
    Handle<Geom2d_Curve> pcurve;
    double distance = std::numeric_limits<double>::max();

    /// OCCT raises where a curve has knots closer than it likes: then there is another way.
    template <class Make>
    void better(const Geometry& geometry, const Make& make) {
        const Result<void> made = occ::guarded("making a pcurve", [&] {
            const Handle<Geom2d_Curve> other = make();
            const double its = other.IsNull() ? distance : geometry.distance(*other);
            if (its < distance) {
                pcurve = other;
                distance = its;
            }
        });
        std::ignore = made;
    }
};

}  // namespace

std::optional<double> add_other_face(const EdgePart& kept, const EdgePart& gone, bool same_way,
                                     double gap, TopoDS_Edge& common) {
    Geometry geometry;
    TopLoc_Location of_curve;
    geometry.curve = BRep_Tool::Curve(common, of_curve, geometry.first, geometry.last);
    geometry.to_model = of_curve.Transformation();
    TopLoc_Location of_surface;
    const Handle<Geom_Surface> surface = BRep_Tool::Surface(gone.face, of_surface);
    const TopLoc_Location between = of_curve.Inverted() * of_surface;
    geometry.surface =
        between.IsIdentity()
            ? surface
            : occ::cast<Geom_Surface>(surface->Transformed(between.Transformation()));
    const OwnPcurve own = own_pcurve(gone, same_way);
    if (own.curve.IsNull()) {
        return std::nullopt;
    }
    const gp_Pnt2d middle = own.curve->Value(0.5 * (own.from + own.to));
    const double good = std::max(Precision::Confusion(), kNearGap * gap);
    Placed best;
    best.better(geometry, [&] { return moved_pcurve(own, geometry.first, geometry.last); });
    if (best.distance > good) {
        best.better(geometry, [&] { return foot_pcurve(geometry, own, gone, same_way, gap); });
    }
    if (best.pcurve.IsNull()) {
        return std::nullopt;
    }
    const BRep_Builder builder;
    const double tolerance = std::max(BRep_Tool::Tolerance(common),
                                      kMargin * best.distance + Precision::Confusion() / 2);
    TopLoc_Location of_own;
    const Handle<Geom_Surface> own_surface = BRep_Tool::Surface(kept.face, of_own);
    if (own_surface != surface || !of_own.IsEqual(of_surface)) {
        builder.UpdateEdge(common, best.pcurve, surface, of_surface, tolerance);
        return best.distance;
    }
    // both faces lie on one surface: its seam, or an edge within it
    double first = 0.0;
    double last = 0.0;
    const Handle<Geom2d_Curve> mine = BRep_Tool::CurveOnSurface(kept.edge, kept.face, first, last);
    if (mine->Value(0.5 * (geometry.first + geometry.last)).Distance(middle) <= kSamePcurve) {
        builder.UpdateEdge(common, tolerance);
        return best.distance;
    }
    const auto forward_in_surface = [](const EdgePart& part, bool turned) {
        const bool reversed_use = (part.edge.Orientation() == TopAbs_REVERSED) !=
                                  (part.face.Orientation() == TopAbs_REVERSED);
        return reversed_use == turned;
    };
    const bool mine_forward = forward_in_surface(kept, false);
    if (mine_forward == forward_in_surface(gone, !same_way)) {
        return std::nullopt;
    }
    builder.UpdateEdge(common, mine_forward ? mine : best.pcurve, mine_forward ? best.pcurve : mine,
                       surface, of_surface, tolerance);
    return best.distance;
}

}  // namespace suture
