#include "suture/candidates/to_surface.h"

#include "suture/occ/convert.h"

#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>

#include <algorithm>

namespace suture {
namespace {

using occ::Handle;

/// An offset is fitted as near as this share of the hole's diameter.
constexpr double kNear = 1e-7;

/// The part of a surface without borders that a hole can reach: one diameter around it.
Handle<Geom_Surface> bounded(const Handle<Geom_Surface>& surface, const Hole& hole) {
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    surface->Bounds(u0, u1, v0, v1);
    if (!Precision::IsInfinite(v0) && !Precision::IsInfinite(v1)) {
        return surface;
    }
    if (Precision::IsInfinite(u0) || Precision::IsInfinite(u1)) {
        return nullptr;
    }
    // Along a straight line in v: an extrusion.
    gp_Pnt origin;
    gp_Vec by_u;
    gp_Vec by_v;
    surface->D1(u0, 0.0, origin, by_u, by_v);
    const Eigen::Vector3d along = occ::from_occ(by_v);
    double low = INFINITY;
    double high = -INFINITY;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            const double v =
                (ribbon.at(0.5).point - occ::from_occ(origin)).dot(along) / along.squaredNorm();
            low = std::min(low, v);
            high = std::max(high, v);
        }
    }
    // The basis curve has a height of its own.
    double height = 0.0;
    constexpr int kPlaces = 16;
    for (int k = 0; k <= kPlaces; ++k) {
        const gp_Pnt p = surface->Value(u0 + (u1 - u0) * k / kPlaces, 0.0);
        height = std::max(height, p.Distance(origin) / along.norm());
    }
    const double beside = hole.diameter / along.norm() + height;
    return occ::make<Geom_RectangularTrimmedSurface>(surface, low - beside, high + beside,
                                                     /*UTrim=*/Standard_False);
}

}  // namespace

std::optional<Surface> to_surface(const Handle<Geom_Surface>& given, const Hole& hole) {
    if (const auto own = occ::from_occ(given)) {
        return own->surface;
    }
    Handle<Geom_Surface> basis = given;
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(basis)) {
        basis = trimmed->BasisSurface();
    }
    const Handle<Geom_Surface> surface = bounded(given, hole);
    if (surface.IsNull()) {
        return std::nullopt;
    }
    Handle<Geom_Surface> spline;
    if (occ::cast<Geom_OffsetSurface>(basis)) {
        constexpr int kDegree = 9;
        constexpr int kSegments = 60;
        const GeomConvert_ApproxSurface fit(surface, kNear * hole.diameter, GeomAbs_C1, GeomAbs_C1,
                                            kDegree, kDegree, kSegments, 0);
        if (!fit.HasResult()) {
            return std::nullopt;
        }
        spline = fit.Surface();
    } else {
        spline = GeomConvert::SurfaceToBSplineSurface(surface);
    }
    const auto converted = spline.IsNull() ? std::nullopt : occ::from_occ(spline);
    return converted ? std::optional(converted->surface) : std::nullopt;
}

}  // namespace suture
