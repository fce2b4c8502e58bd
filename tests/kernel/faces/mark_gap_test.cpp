#include "suture/faces/mark_gap.h"

#include "suture/occ/convert.h"

#include <gtest/gtest.h>

#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>

#include <cmath>

namespace suture {
namespace {

using occ::Handle;

/// A curve along a cylinder whose height above it has a narrow peak.
struct Peaked {
    double size, height, peak, first, last;
    Handle<Geom_Surface> surface =
        occ::make<Geom_CylindricalSurface>(gp_Ax3(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), 2.0 * size);
    Handle<Geom2d_Curve> pcurve =
        occ::make<Geom2d_Line>(gp_Pnt2d(0.7, 0.3 * size - first), gp_Dir2d(0.0, 1.0));
    Handle<Geom_Curve> curve = above();

    Peaked(double size_in, double height_in, double peak_in)
        : size(size_in), height(height_in), peak(peak_in), first(-1.0 * size), last(3.0 * size) {}

    [[nodiscard]] Handle<Geom_Curve> above() const {
        constexpr int kPoints = 801;
        const Handle<TColgp_HArray1OfPnt> points = occ::make<TColgp_HArray1OfPnt>(1, kPoints);
        const Handle<TColStd_HArray1OfReal> parameters =
            occ::make<TColStd_HArray1OfReal>(1, kPoints);
        for (int k = 0; k < kPoints; ++k) {
            const double s = k / (kPoints - 1.0);
            const double t = first + (last - first) * s;
            const gp_Pnt2d uv = pcurve->Value(t);
            gp_Pnt at;
            gp_Vec du;
            gp_Vec dv;
            surface->D1(uv.X(), uv.Y(), at, du, dv);
            const double narrow = (s - peak) / 0.012;
            const gp_Vec out = du.Crossed(dv).Normalized();
            points->SetValue(
                k + 1, at.Translated(out * (height * (0.2 + 0.8 * std::exp(-narrow * narrow)))));
            parameters->SetValue(k + 1, t);
        }
        GeomAPI_Interpolate interpolation(points, parameters, Standard_False, 0.0);
        interpolation.Perform();
        return interpolation.Curve();
    }

    [[nodiscard]] double distance(const Geom2d_Curve& on, double t) const {
        const gp_Pnt2d uv = on.Value(t);
        return curve->Value(t).Distance(surface->Value(uv.X(), uv.Y()));
    }
    [[nodiscard]] double largest(const Geom2d_Curve& on, int samples) const {
        double found = 0.0;
        for (int k = 0; k <= samples; ++k) {
            found = std::max(found, distance(on, first + (last - first) * k / samples));
        }
        return found;
    }
};

constexpr int kReaders = 22;       // intervals
constexpr int kDense = 22 * 4000;  // the readers' parameters among them

TEST(MarkGap, LetsAReaderSeeTheWholeGap) {
    for (const double size : {1e-3, 1.0, 1e3}) {
        for (const double height : {1e-6, 1e-4, 1e-2}) {
            for (const double peak : {0.02, 0.31, 0.523, 0.7, 0.98}) {
                SCOPED_TRACE(testing::Message() << size << " " << height << " " << peak);
                const Peaked edge(size, height * size, peak);
                const double gap = edge.largest(*edge.pcurve, kDense);
                const auto marked =
                    mark_gap(edge.curve, edge.first, edge.last, edge.surface, edge.pcurve, gap);
                if (gap <= 1e-7) {
                    EXPECT_EQ(marked, edge.pcurve);
                    continue;
                }
                EXPECT_LT(edge.largest(*edge.pcurve, kReaders), 0.97 * gap);
                const double seen = 1.00001 * edge.largest(*marked, kReaders);
                EXPECT_GE(seen, edge.largest(*marked, kDense));
                EXPECT_GE(seen, gap);
                EXPECT_LE(seen, 1.21 * gap);
            }
        }
    }
}

TEST(MarkGap, LeavesTheTraceAndTheEndsOfThePcurve) {
    const Peaked edge(1.0, 1e-3, 0.523);
    const double gap = edge.largest(*edge.pcurve, kDense);
    const auto marked = mark_gap(edge.curve, edge.first, edge.last, edge.surface, edge.pcurve, gap);
    ASSERT_NE(marked, edge.pcurve);
    EXPECT_EQ(marked->FirstParameter(), edge.first);
    EXPECT_EQ(marked->LastParameter(), edge.last);
    int moved = 0;
    for (int k = 0; k <= 4400; ++k) {
        const double t = edge.first + (edge.last - edge.first) * k / 4400;
        EXPECT_NEAR(marked->Value(t).X(), 0.7, 1e-14);  // the line u = 0.7
        moved += marked->Value(t).Distance(edge.pcurve->Value(t)) > 1e-12 ? 1 : 0;
    }
    EXPECT_GT(moved, 0);
    EXPECT_LE(moved, 4400 / kReaders);
    for (const double t : {edge.first, edge.last}) {
        EXPECT_LT(marked->Value(t).Distance(edge.pcurve->Value(t)), 1e-14);
    }
}

TEST(MarkGap, LeavesAPcurveWhoseGapShows) {
    const Peaked edge(1.0, 1e-3, 11.0 / 22.0);
    const double gap = edge.largest(*edge.pcurve, kDense);
    EXPECT_EQ(mark_gap(edge.curve, edge.first, edge.last, edge.surface, edge.pcurve, gap),
              edge.pcurve);
}

}  // namespace
}  // namespace suture
