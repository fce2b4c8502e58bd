#include "suture/faces/pcurve.h"

#include <gtest/gtest.h>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <gp_Pln.hxx>

#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using occ::Handle;

using Curve = std::function<Vector2d(double)>;

const Handle<Geom_Surface>& plane() {
    static const Handle<Geom_Surface> surface = occ::make<Geom_Plane>(gp_Pln());
    return surface;
}

/// On the unit plane, where parameters are lengths.
double largest_distance(const Curve& at, const Geom2d_Curve& fitted, double first, double last) {
    double largest = 0.0;
    for (int k = 0; k <= 5000; ++k) {
        const double t = first + (last - first) * k / 5000;
        const gp_Pnt2d p = fitted.Value(t);
        largest = std::max(largest, (at(t) - Vector2d(p.X(), p.Y())).norm());
    }
    return largest;
}

TEST(FitPcurve, KeepsALineOfUnitSpeedALine) {
    const Curve at = [](double t) { return Vector2d(1.0 + 0.6 * t, 2.0 - 0.8 * t); };
    const auto curve = fit_pcurve(at, -3.0, 5.0, *plane(), 1e-9);
    EXPECT_TRUE(occ::cast<Geom2d_Line>(curve));
    EXPECT_LT(largest_distance(at, *curve, -3.0, 5.0), 1e-14);
}

// A file has angles to 13 digits: a quarter of a circle runs at unit speed but for that.
TEST(FitPcurve, TakesALineOfRoundedSpeedForOne) {
    for (const double off : {1e-10, 1e-8}) {
        const Curve at = [off](double t) { return Vector2d(1.0 + (1.0 + off) * t, 2.0); };
        const auto curve = fit_pcurve(at, 4.0, 5.5, *plane(), 1e-8);
        EXPECT_EQ(!occ::cast<Geom2d_Line>(curve).IsNull(), off < 1e-9);
        EXPECT_LT(largest_distance(at, *curve, 4.0, 5.5), 1e-10);
        // Not where it would be seen.
        EXPECT_TRUE(occ::cast<Geom2d_BSplineCurve>(fit_pcurve(at, 4.0, 5.5, *plane(), 1e-12)));
    }
}

TEST(FitPcurve, KeepsALineOfAnyOtherSpeedStraight) {
    const Curve at = [](double t) { return Vector2d(1.0 + 6.0 * t, 2.0 - 8.0 * t); };
    const auto spline = occ::cast<Geom2d_BSplineCurve>(fit_pcurve(at, -3.0, 5.0, *plane(), 1e-9));
    ASSERT_TRUE(spline);
    EXPECT_EQ(spline->Degree(), 1);
    EXPECT_EQ(spline->NbPoles(), 2);
    EXPECT_LT(largest_distance(at, *spline, -3.0, 5.0), 1e-13);
}

TEST(FitPcurve, TakesOnePolynomialWhereFewPiecesAreAsked) {
    for (const double size : {1e-3, 1.0, 1e3}) {
        const Curve at = [size](double t) -> Vector2d {
            return size * Vector2d(std::cos(t), std::exp(0.3 * t));
        };
        const auto few = occ::cast<Geom2d_BSplineCurve>(
            fit_pcurve(at, 0.7, 2.2, *plane(), 1e-9 * size, Pieces::Few));
        ASSERT_TRUE(few);
        EXPECT_EQ(few->NbKnots(), 2);
        EXPECT_LE(few->Degree(), 9);
        EXPECT_LT(largest_distance(at, *few, 0.7, 2.2), 1e-9 * size);
        EXPECT_EQ(few->Value(0.7).X(), at(0.7).x());
        EXPECT_EQ(few->Value(2.2).Y(), at(2.2).y());
        const auto cubic =
            occ::cast<Geom2d_BSplineCurve>(fit_pcurve(at, 0.7, 2.2, *plane(), 1e-9 * size));
        EXPECT_EQ(cubic->Degree(), 3);
        EXPECT_GT(cubic->NbPoles(), 50);
    }
    // A kink is no polynomial's.
    const Curve kink = [](double t) { return Vector2d(t, std::abs(t - 0.3)); };
    const auto fitted = fit_pcurve(kink, 0.0, 2.0, *plane(), 1e-3, Pieces::Few);
    EXPECT_LT(largest_distance(kink, *fitted, 0.0, 2.0), 5e-3);
}

TEST(FitPcurve, ReachesTheAccuracyAtEverySize) {
    for (const double size : {1e-3, 1.0, 1e3}) {
        for (const double accuracy : {1e-4, 1e-6, 1e-9}) {
            const Curve at = [size](double t) -> Vector2d {
                return size * Vector2d(std::cos(t) + 0.1 * std::sin(3 * t), std::exp(0.3 * t));
            };
            const double first = 0.7;
            const double last = 4.1;
            const auto curve = fit_pcurve(at, first, last, *plane(), accuracy * size);
            // The error is sampled between the knots only: it may be a little larger.
            EXPECT_LT(largest_distance(at, *curve, first, last), 1.5 * accuracy * size);
            EXPECT_DOUBLE_EQ(curve->FirstParameter(), first);
            EXPECT_DOUBLE_EQ(curve->LastParameter(), last);
        }
    }
}

TEST(FitPcurve, MeetsBothEndsExactly) {
    const Curve at = [](double t) { return Vector2d(std::cos(t), std::sin(2 * t)); };
    const auto curve = fit_pcurve(at, 0.0, 2.0, *plane(), 1e-3);
    for (const double t : {0.0, 2.0}) {
        const gp_Pnt2d end = curve->Value(t);
        EXPECT_NEAR((at(t) - Vector2d(end.X(), end.Y())).norm(), 0.0, 1e-15);
    }
}

TEST(FitPcurve, GivesTheBestThereIsOfACurveWithAKink) {
    const Curve at = [](double t) { return Vector2d(t, std::abs(t - 0.3)); };
    const auto curve = fit_pcurve(at, -1.0, 1.0, *plane(), 1e-12);
    const double largest = largest_distance(at, *curve, -1.0, 1.0);
    EXPECT_GT(largest, 1e-12);
    EXPECT_LT(largest, 1e-3);
}

}  // namespace
}  // namespace suture
