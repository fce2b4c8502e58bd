// Set-up, and the feet on elementary surfaces; those on splines are in spline_foot.cpp.
#include "suture/check/certify/foot_point.h"

#include "suture/occ/handle.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <gp_Ax3.hxx>

namespace suture::certify {

namespace {

// Roundings that an elementary surface's data went through before they came here, of its largest
// coordinate: its placement in the model.
constexpr double kPlacement = 32 * kRounding;

TaylorModel3 constant(const gp_XYZ& v) {
    return {v.X(), v.Y(), v.Z()};
}

}  // namespace

CertifiedSurface::CertifiedSurface(const TopoDS_Face& face) : surface_(BRep_Tool::Surface(face)) {
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface_)) {
        surface_ = trimmed->BasisSurface();
    }
    switch (GeomAdaptor_Surface(surface_).GetType()) {
        case GeomAbs_Plane:
        case GeomAbs_Cylinder:
        case GeomAbs_Cone:
        case GeomAbs_Sphere:
        case GeomAbs_Torus:
            return;
        default:
            spline_.emplace(face, surface_);
            reason_ = spline_->reason();
    }
}

bool CertifiedSurface::same_elementary(const CertifiedSurface& other) const {
    if (!is_elementary() || !other.is_elementary()) {
        return false;
    }
    const GeomAdaptor_Surface a(surface_);
    const GeomAdaptor_Surface b(other.surface_);
    const auto same_place = [](const gp_Ax3& one, const gp_Ax3& two) {
        return one.Location().XYZ().IsEqual(two.Location().XYZ(), 0.0) &&
               one.Direction().XYZ().IsEqual(two.Direction().XYZ(), 0.0);
    };
    if (a.GetType() != b.GetType()) {
        return false;
    }
    switch (a.GetType()) {
        case GeomAbs_Plane:
            return same_place(a.Plane().Position(), b.Plane().Position());
        case GeomAbs_Cylinder:
            return same_place(a.Cylinder().Position(), b.Cylinder().Position()) &&
                   a.Cylinder().Radius() == b.Cylinder().Radius();
        case GeomAbs_Cone:
            return same_place(a.Cone().Position(), b.Cone().Position()) &&
                   a.Cone().RefRadius() == b.Cone().RefRadius() &&
                   a.Cone().SemiAngle() == b.Cone().SemiAngle();
        case GeomAbs_Sphere:
            return same_place(a.Sphere().Position(), b.Sphere().Position()) &&
                   a.Sphere().Radius() == b.Sphere().Radius();
        default:
            return same_place(a.Torus().Position(), b.Torus().Position()) &&
                   a.Torus().MajorRadius() == b.Torus().MajorRadius() &&
                   a.Torus().MinorRadius() == b.Torus().MinorRadius();
    }
}

std::array<double, 2> CertifiedSurface::node(const gp_Pnt2d& uv, const gp_Pnt& point) const {
    return spline_->parameters(uv, point);
}

/// The closed forms of the nearest point; `w` is the curve counted from the surface's own origin.
std::optional<Foot> CertifiedSurface::elementary_foot(const Stretch& stretch) const {
    const GeomAdaptor_Surface surface(surface_);
    const gp_XYZ origin(stretch.origin[0], stretch.origin[1], stretch.origin[2]);
    const auto around = [&](const gp_Ax3& frame, const auto& foot_of) {
        const gp_XYZ place = frame.Location().XYZ() - origin;
        const double size = origin.Modulus() + place.Modulus();
        const TaylorModel3 w = widened(stretch.curve - constant(place), kPlacement * size);
        const TaylorModel3 axis = constant(frame.Direction().XYZ());
        const TaylorModel height = dot(w, axis);
        const TaylorModel3 off = w - height * axis;
        Foot foot = foot_of(w, axis, height, off);
        foot.point = widened(foot.point + constant(place), kPlacement * size);
        foot.normal = widened(foot.normal, kPlacement);
        return known(foot.point) && known(foot.normal) ? std::optional(foot) : std::nullopt;
    };
    using Model = const TaylorModel&;
    using Model3 = const TaylorModel3&;
    const auto unit = [](Model3 v) { return inverse(sqrt(dot(v, v))) * v; };
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            return around(surface.Plane().Position(), [](Model3, Model3 axis, Model, Model3 off) {
                return Foot{off, axis};
            });
        case GeomAbs_Cylinder: {
            const TaylorModel radius = surface.Cylinder().Radius();
            return around(surface.Cylinder().Position(),
                          [&](Model3, Model3 axis, Model height, Model3 off) {
                              const TaylorModel3 out = unit(off);
                              return Foot{height * axis + radius * out, out};
                          });
        }
        case GeomAbs_Sphere: {
            const TaylorModel radius = surface.Sphere().Radius();
            return around(surface.Sphere().Position(), [&](Model3 w, Model3, Model, Model3) {
                const TaylorModel3 out = unit(w);
                return Foot{radius * out, out};
            });
        }
        case GeomAbs_Torus: {
            const TaylorModel major = surface.Torus().MajorRadius();
            const TaylorModel minor = surface.Torus().MinorRadius();
            return around(surface.Torus().Position(), [&](Model3 w, Model3, Model, Model3 off) {
                const TaylorModel3 center = major * unit(off);
                const TaylorModel3 out = unit(w - center);
                return Foot{center + minor * out, out};
            });
        }
        default: {
            const TaylorModel radius = surface.Cone().RefRadius();
            const TaylorModel sine(std::sin(surface.Cone().SemiAngle()));
            const TaylorModel cosine(std::cos(surface.Cone().SemiAngle()));
            return around(surface.Cone().Position(), [&](Model3, Model3 axis, Model height,
                                                         Model3 off) {
                const TaylorModel3 out = unit(off);
                // In the half plane of the axis and `out` the cone is a line.
                const TaylorModel along = (dot(off, out) - radius) * sine + height * cosine;
                const TaylorModel from_axis = radius + along * sine;
                return Foot{from_axis * out + (along * cosine) * axis, cosine * out - sine * axis};
            });
        }
    }
}

std::vector<Foot> CertifiedSurface::feet(const Stretch& stretch, std::string& why) const {
    std::vector<Foot> feet;
    if (spline_) {
        feet = spline_feet(stretch, why);
    } else if (const auto foot = elementary_foot(stretch)) {
        feet.push_back(*foot);
    } else {
        why = "the nearest point is not unique, or the surface is singular";
    }
    for (Foot& foot : feet) {
        const gp_Vec middle(foot.normal[0].middle(), foot.normal[1].middle(),
                            foot.normal[2].middle());
        if (middle * stretch.normal < 0.0) {
            foot.normal = TaylorModel(-1.0) * foot.normal;
        }
    }
    return feet;
}

}  // namespace suture::certify
