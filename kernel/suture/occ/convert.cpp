#include "suture/occ/convert.h"

#include <BSplCLib.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <vector>

namespace suture::occ {
namespace {

gp_Ax3 to_occ(const Frame& frame) {
    return {to_point(frame.origin), to_direction(frame.z), to_direction(frame.x)};
}

struct FrameFromOcc {
    Frame frame;
    bool left_handed = false;
};

FrameFromOcc from_occ(const gp_Ax3& axes) {
    FrameFromOcc result;
    result.frame.origin = occ::from_occ(axes.Location());
    result.frame.x = occ::from_occ(axes.XDirection());
    result.frame.z = occ::from_occ(axes.Direction());
    result.frame.y = result.frame.z.cross(result.frame.x);
    result.left_handed = !axes.Direct();
    return result;
}

/// Distinct knots and how often each stands there.
struct Multiplicities {
    std::vector<double> knots;
    std::vector<int> counts;

    explicit Multiplicities(const std::vector<double>& flat) {
        for (const double knot : flat) {
            if (knots.empty() || knot != knots.back()) {
                knots.push_back(knot);
                counts.push_back(0);
            }
            ++counts.back();
        }
    }
};

Result<Handle<Geom_Surface>> spline_to_occ(const SplineSurface& spline) {
    const int limit = Geom_BSplineSurface::MaxDegree();
    if (spline.degree_u > limit || spline.degree_v > limit) {
        return fail(ErrorCode::Refused, "degree {} x {} is above OCCT's limit of {}",
                    spline.degree_u, spline.degree_v, limit);
    }
    const int nu = spline.count_u();
    const int nv = spline.count_v();
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);
    for (int j = 0; j < nv; ++j) {
        for (int i = 0; i < nu; ++i) {
            const int k = spline.index(i, j);
            poles.SetValue(i + 1, j + 1, to_point(Eigen::Vector3d(spline.poles.col(k))));
            weights.SetValue(i + 1, j + 1, spline.rational() ? spline.weights[k] : 1.0);
        }
    }
    const Multiplicities u(spline.knots_u);
    const Multiplicities v(spline.knots_v);
    const auto size_u = static_cast<int>(u.knots.size());
    const auto size_v = static_cast<int>(v.knots.size());
    const TColStd_Array1OfReal knots_u(u.knots.front(), 1, size_u);
    const TColStd_Array1OfReal knots_v(v.knots.front(), 1, size_v);
    const TColStd_Array1OfInteger counts_u(u.counts.front(), 1, size_u);
    const TColStd_Array1OfInteger counts_v(v.counts.front(), 1, size_v);
    if (spline.rational()) {
        return Handle<Geom_Surface>(make<Geom_BSplineSurface>(poles, weights, knots_u, knots_v,
                                                              counts_u, counts_v, spline.degree_u,
                                                              spline.degree_v));
    }
    return Handle<Geom_Surface>(make<Geom_BSplineSurface>(
        poles, knots_u, knots_v, counts_u, counts_v, spline.degree_u, spline.degree_v));
}

std::vector<double> flat_knots(const TColStd_Array1OfReal& sequence) {
    return {sequence.begin(), sequence.end()};
}

SplineSurface from_occ(const Handle<Geom_BSplineSurface>& given) {
    Handle<Geom_BSplineSurface> surface = given;
    if (surface->IsUPeriodic() || surface->IsVPeriodic()) {
        surface = cast<Geom_BSplineSurface>(surface->Copy());
        surface->SetUNotPeriodic();
        surface->SetVNotPeriodic();
    }
    SplineSurface result;
    result.degree_u = surface->UDegree();
    result.degree_v = surface->VDegree();
    result.knots_u = flat_knots(surface->UKnotSequence());
    result.knots_v = flat_knots(surface->VKnotSequence());
    const int nu = surface->NbUPoles();
    const int nv = surface->NbVPoles();
    const bool rational = surface->IsURational() || surface->IsVRational();
    result.poles.resize(3, nu * nv);
    result.weights.resize(rational ? nu * nv : 0);
    for (int j = 0; j < nv; ++j) {
        for (int i = 0; i < nu; ++i) {
            result.poles.col(i + nu * j) = occ::from_occ(surface->Pole(i + 1, j + 1));
            if (rational) {
                result.weights[i + nu * j] = surface->Weight(i + 1, j + 1);
            }
        }
    }
    // What was periodic has single knots beyond its ends; we want them all at the ends.
    const double u = result.knots_u[static_cast<std::size_t>(result.degree_u)];
    const double v = result.knots_v[static_cast<std::size_t>(result.degree_v)];
    return extended(result, u, u, v, v);
}

}  // namespace

Result<Handle<Geom_Surface>> to_occ(const Surface& surface) {
    struct Visitor {
        using Out = Result<Handle<Geom_Surface>>;
        Out operator()(const Plane& p) const { return Out(make<Geom_Plane>(to_occ(p.frame))); }
        Out operator()(const Cylinder& p) const {
            return Out(make<Geom_CylindricalSurface>(to_occ(p.frame), p.radius));
        }
        Out operator()(const Cone& p) const {
            return Out(make<Geom_ConicalSurface>(to_occ(p.frame), p.half_angle, p.radius));
        }
        Out operator()(const Sphere& p) const {
            return Out(make<Geom_SphericalSurface>(to_occ(p.frame), p.radius));
        }
        Out operator()(const Torus& p) const {
            return Out(make<Geom_ToroidalSurface>(to_occ(p.frame), p.major, p.minor));
        }
        Out operator()(const SplineSurface& p) const { return spline_to_occ(p); }
    };
    return std::visit(Visitor{}, surface);
}

std::optional<ClosedForm> from_occ(const Handle<Geom_Surface>& given) {
    Handle<Geom_Surface> surface = given;
    while (const auto trimmed = cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    if (const auto plane = cast<Geom_Plane>(surface)) {
        const auto [frame, left] = from_occ(plane->Position());
        return ClosedForm{Plane{frame}, {1.0, left ? -1.0 : 1.0}};
    }
    // The surfaces of revolution: in a left-handed frame u runs backwards.
    const auto revolved = [](const gp_Ax3& axes, auto form) {
        const auto [frame, left] = from_occ(axes);
        form.frame = frame;
        return ClosedForm{form, {left ? -1.0 : 1.0, 1.0}};
    };
    if (const auto cylinder = cast<Geom_CylindricalSurface>(surface)) {
        return revolved(cylinder->Position(), Cylinder{{}, cylinder->Radius()});
    }
    if (const auto cone = cast<Geom_ConicalSurface>(surface)) {
        return revolved(cone->Position(), Cone{{}, cone->RefRadius(), cone->SemiAngle()});
    }
    if (const auto sphere = cast<Geom_SphericalSurface>(surface)) {
        return revolved(sphere->Position(), Sphere{{}, sphere->Radius()});
    }
    if (const auto torus = cast<Geom_ToroidalSurface>(surface)) {
        return revolved(torus->Position(), Torus{{}, torus->MajorRadius(), torus->MinorRadius()});
    }
    if (cast<Geom_BezierSurface>(surface)) {
        surface = GeomConvert::SurfaceToBSplineSurface(surface);
    }
    if (const auto spline = cast<Geom_BSplineSurface>(surface)) {
        return ClosedForm{from_occ(spline), {1.0, 1.0}};
    }
    return std::nullopt;
}

std::optional<SplineCurve> spline_of(const Handle<Geom_Curve>& given, double from, double to) {
    Handle<Geom_Curve> curve = given;
    while (const auto trimmed = cast<Geom_TrimmedCurve>(curve)) {
        curve = trimmed->BasisCurve();
    }
    SplineCurve result;
    if (cast<Geom_Line>(curve)) {
        result.knots = {0.0, 0.0, 1.0, 1.0};
        result.poles.resize(3, 2);
        result.poles << from_occ(curve->Value(from)), from_occ(curve->Value(to));
        return result;
    }
    Handle<Geom_BSplineCurve> spline;
    if (cast<Geom_BezierCurve>(curve)) {
        spline = GeomConvert::CurveToBSplineCurve(curve);
    } else if (const auto own = cast<Geom_BSplineCurve>(curve)) {
        spline = cast<Geom_BSplineCurve>(own->Copy());
    }
    if (spline.IsNull() || spline->IsRational()) {
        return std::nullopt;
    }
    spline->Segment(std::min(from, to), std::max(from, to));
    if (to < from) {
        spline->Reverse();
    }
    result.degree = spline->Degree();
    result.poles.resize(3, spline->NbPoles());
    for (int i = 1; i <= spline->NbPoles(); ++i) {
        result.poles.col(i - 1) = from_occ(spline->Pole(i));
    }
    TColStd_Array1OfReal knots(1, spline->NbKnots());
    spline->Knots(knots);
    BSplCLib::Reparametrize(0.0, 1.0, knots);
    for (int i = 1; i <= spline->NbKnots(); ++i) {
        result.knots.insert(result.knots.end(), static_cast<std::size_t>(spline->Multiplicity(i)),
                            knots(i));
    }
    return result;
}

}  // namespace suture::occ
