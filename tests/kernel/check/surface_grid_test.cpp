#include "suture/check/surface_grid.h"

#include <gtest/gtest.h>

#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace suture::test {

namespace {

/// A sheet with waves across and a fold along, 30 x 20.
opencascade::handle<Geom_Surface> wavy_sheet(double size) {
    constexpr int kAcross = 31;
    constexpr int kAlong = 18;
    TColgp_Array2OfPnt points(1, kAcross, 1, kAlong);
    for (int i = 1; i <= kAcross; ++i) {
        for (int j = 1; j <= kAlong; ++j) {
            const double u = i - 1.0;
            const double v = 20.0 * (j - 1.0) / (kAlong - 1.0);
            const gp_Pnt point(u + 2.0 * std::sin(0.9 * v), v,
                               2.5 * std::sin(1.1 * u) + 1.5 * std::cos(0.7 * v));
            points.SetValue(i, j, point.XYZ() * size);
        }
    }
    return GeomAPI_PointsToBSplineSurface(points, 3, 8, GeomAbs_C2, 1e-4 * size).Surface();
}

double nearest_by_grid(const GeomAdaptor_Surface& surface, const SurfaceGrid& grid,
                       const gp_Pnt& from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const SurfaceGrid::Minimum& minimum : grid.minima(from)) {
        if (minimum.at_least <= nearest) {
            const gp_Pnt2d uv = grid.downhill(surface, from, minimum.uv);
            nearest = std::min(nearest, from.Distance(surface.Value(uv.X(), uv.Y())));
        }
    }
    return nearest;
}

}  // namespace

TEST(SurfaceGrid, LeadsAsNearAsOcctsSearchOverTheWholeSurface) {
    constexpr int kPoints = 60;
    for (const double size : {1e-3, 1.0, 1e3}) {
        const auto sheet = wavy_sheet(size);
        const GeomAdaptor_Surface surface(sheet);
        const SurfaceGrid grid(surface);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        for (int k = 0; k < kPoints; ++k) {
            const gp_Pnt from(
                gp_XYZ(30.0 * part(random), 20.0 * part(random), 8.0 * part(random) - 4.0) * size);
            const GeomAPI_ProjectPointOnSurf occt(from, sheet);
            const double theirs = occt.NbPoints() > 0 ? occt.LowerDistance()
                                                      : std::numeric_limits<double>::infinity();
            EXPECT_LE(nearest_by_grid(surface, grid, from), theirs + 2e-3 * size)
                << "point " << k << " of size " << size;
        }
    }
}

TEST(SurfaceGrid, FindsTheBorderWhereItIsNearest) {
    const auto sheet = wavy_sheet(1.0);
    const GeomAdaptor_Surface surface(sheet);
    double u_low = 0.0;
    double u_high = 0.0;
    double v_low = 0.0;
    double v_high = 0.0;
    sheet->Bounds(u_low, u_high, v_low, v_high);
    const gp_Pnt corner = sheet->Value(u_low, v_low);
    const gp_Pnt beyond = corner.Translated(gp_Vec(-3.0, -4.0, 0.0));
    EXPECT_LE(nearest_by_grid(surface, SurfaceGrid(surface), beyond), 5.0);
    EXPECT_GT(nearest_by_grid(surface, SurfaceGrid(surface), beyond), 3.9);
}

}  // namespace suture::test
