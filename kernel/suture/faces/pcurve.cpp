#include "suture/faces/pcurve.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"

#include <Eigen/LU>

#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <gp_Dir2d.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using occ::Handle;

using Curve = std::function<Vector2d(double)>;

constexpr int kFewestPoints = 9;
constexpr int kMostPoints = 1025;

/// Degrees of the curves without inner knots that are tried: OCCT and most readers take 25.
constexpr int kDegrees[] = {3, 5, 7, 9, 11, 13};

/// How far from unit speed a line may run and still be written as one: rounding only.
constexpr double kUnitSpeed = 1e-12;

/// And where the angles of a file are rounded as well, if in space that is this share of the
/// accuracy.
constexpr double kRoundedSpeed = 1e-9;
constexpr double kOfAccuracy = 1e-2;

/// The largest distance of a fitted curve; where that is not below `best`, any that is not either.
double distance(const Curve& at, const Geom2d_Curve& curve, const Geom_Surface& surface,
                double first, double last, int intervals, double best = INFINITY) {
    double largest = 0.0;
    for (int k = 0; k < intervals && largest < best; ++k) {
        // Off-centre: an interpolant's error can vanish in the middle by symmetry.
        const double t = first + (last - first) * (k + 0.4) / intervals;
        const gp_Pnt2d fitted = curve.Value(t);
        const Vector2d wanted = at(t);
        largest = std::max(
            largest,
            surface.Value(fitted.X(), fitted.Y()).Distance(surface.Value(wanted.x(), wanted.y())));
    }
    return largest;
}

/// Input    rounding: how far from unit speed it may be taken for OCCT's line.
Handle<Geom2d_Curve> straight(const Curve& at, double first, double last, double rounding) {
    const Vector2d a = at(first);
    const Vector2d b = at(last);
    const Vector2d velocity = (b - a) / (last - first);
    if (std::abs(velocity.norm() - 1.0) < rounding) {
        const Vector2d along = velocity.normalized();
        const Vector2d origin = 0.5 * (a + b) - along * (0.5 * (first + last));
        return occ::make<Geom2d_Line>(occ::to_point(origin), gp_Dir2d(along.x(), along.y()));
    }
    TColgp_Array1OfPnt2d poles(1, 2);
    poles.SetValue(1, occ::to_point(a));
    poles.SetValue(2, occ::to_point(b));
    TColStd_Array1OfReal knots(1, 2);
    knots.SetValue(1, first);
    knots.SetValue(2, last);
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return occ::make<Geom2d_BSplineCurve>(poles, knots, multiplicities, 1);
}

/// Bernstein's polynomials of a degree at x.
Eigen::RowVectorXd bernstein(int degree, double x) {
    Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(degree + 1);
    values[0] = 1.0;
    for (int n = 1; n <= degree; ++n) {
        for (int i = n; i > 0; --i) {
            values[i] = (1.0 - x) * values[i] + x * values[i - 1];
        }
        values[0] *= 1.0 - x;
    }
    return values;
}

/// One polynomial through both ends and the curve's points at Chebyshev's places between.
Handle<Geom2d_Curve> polynomial(const Curve& at, double first, double last, int degree) {
    Eigen::MatrixXd basis(degree + 1, degree + 1);
    Eigen::MatrixX2d values(degree + 1, 2);
    for (int k = 0; k <= degree; ++k) {
        const double x = 0.5 - 0.5 * std::cos(kPi * k / degree);
        basis.row(k) = bernstein(degree, x);
        values.row(k) = at(first + (last - first) * x).transpose();
    }
    Eigen::MatrixX2d found = basis.partialPivLu().solve(values);
    found.row(0) = values.row(0);
    found.row(degree) = values.row(degree);
    TColgp_Array1OfPnt2d poles(1, degree + 1);
    for (int k = 0; k <= degree; ++k) {
        poles.SetValue(k + 1, occ::to_point(Vector2d(found.row(k).transpose())));
    }
    TColStd_Array1OfReal knots(1, 2);
    knots.SetValue(1, first);
    knots.SetValue(2, last);
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(degree + 1);
    return occ::make<Geom2d_BSplineCurve>(poles, knots, multiplicities, degree);
}

Handle<Geom2d_Curve> interpolated(const Curve& at, double first, double last, int points) {
    const Handle<TColgp_HArray1OfPnt2d> values = occ::make<TColgp_HArray1OfPnt2d>(1, points);
    const Handle<TColStd_HArray1OfReal> parameters = occ::make<TColStd_HArray1OfReal>(1, points);
    for (int k = 0; k < points; ++k) {
        const double t = first + (last - first) * k / (points - 1);
        values->SetValue(k + 1, occ::to_point(at(t)));
        parameters->SetValue(k + 1, t);
    }
    Geom2dAPI_Interpolate interpolation(values, parameters, Standard_False, 0.0);
    // One-sided fourth-order differences, so that the spline keeps its order at the ends.
    const double h = (last - first) / (points - 1);
    const auto slope = [&](double t, double step) -> Vector2d {
        return (-25.0 * at(t) + 48.0 * at(t + step) - 36.0 * at(t + 2 * step) +
                16.0 * at(t + 3 * step) - 3.0 * at(t + 4 * step)) /
               (12.0 * step);
    };
    const double step = h / 4.0;
    const Vector2d start = slope(first, step);
    const Vector2d end = slope(last, -step);
    interpolation.Load(gp_Vec2d(start.x(), start.y()), gp_Vec2d(end.x(), end.y()),
                       /*Scale=*/Standard_False);
    interpolation.Perform();
    return interpolation.Curve();
}

}  // namespace

Handle<Geom2d_Curve> fit_pcurve(const Curve& at, double first, double last,
                                const Geom_Surface& surface, double accuracy, Pieces pieces) {
    Handle<Geom2d_Curve> best = straight(at, first, last, kRoundedSpeed);
    double best_distance = distance(at, *best, surface, first, last, kFewestPoints);
    if (best_distance > kOfAccuracy * accuracy) {
        best = straight(at, first, last, kUnitSpeed);
        best_distance = distance(at, *best, surface, first, last, kFewestPoints);
    }
    const auto take = [&](const Handle<Geom2d_Curve>& curve, int intervals) {
        const double d = distance(at, *curve, surface, first, last, intervals, best_distance);
        if (d < best_distance) {
            best = curve;
            best_distance = d;
        }
    };
    for (const int degree : kDegrees) {
        if (pieces == Pieces::Few && best_distance > accuracy) {
            take(polynomial(at, first, last, degree), 4 * degree);
        }
    }
    for (int points = kFewestPoints; best_distance > accuracy && points <= kMostPoints;
         points = 2 * points - 1) {
        take(interpolated(at, first, last, points), points - 1);
    }
    return best;
}

}  // namespace suture
