#include "suture/faces/mark_gap.h"

#include "suture/occ/convert.h"

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using occ::Handle;

/// The intervals between the 23 parameters at which OCCT's readers look.
constexpr int kIntervals = 22;

/// OCCT's readers multiply what they find by 1.00001; a check may find this much more than is
/// there.
constexpr double kReadersMargin = 1.00001;

/// The distance at the mark: enough above the gap to be the largest, and enough above the distance
/// that is there already to be made by running ahead. At most so many gaps in all.
constexpr double kAboveGap = 1.002;
constexpr double kAboveDistance = 1.2;

/// Knots on either side of the mark, and how many of their intervals make one between parameters.
constexpr int kKnots = 3;
constexpr int kKnotsPerInterval = 8;

/// Corrections of the mark's height and slope until the largest distance is at it.
constexpr int kCorrections = 6;

/// Between marks and parameters, samples that show whether the mark is the highest.
constexpr int kSamples = 64;

/// The curve, the surface, and the distance between them by a pcurve.
struct Course {
    const Geom_Curve& curve;
    const Geom_Surface& surface;
    double first, last;

    [[nodiscard]] double parameter(int sample) const {
        // As OCCT has it, to the last bit.
        return ((kIntervals - sample) * first + sample * last) / kIntervals;
    }
    [[nodiscard]] double distance(const Geom2d_Curve& pcurve, double t) const {
        const gp_Pnt2d uv = pcurve.Value(t);
        return curve.Value(t).Distance(surface.Value(uv.X(), uv.Y()));
    }
    [[nodiscard]] double shown(const Geom2d_Curve& pcurve) const {
        double largest = 0.0;
        for (int k = 0; k <= kIntervals; ++k) {
            largest = std::max(largest, distance(pcurve, parameter(k)));
        }
        return largest * kReadersMargin;
    }
    /// The largest distance within one interval on either side of a parameter.
    [[nodiscard]] double largest_about(const Geom2d_Curve& pcurve, int sample) const {
        double largest = 0.0;
        const double t = parameter(sample);
        for (int k = -kSamples; k <= kSamples; ++k) {
            largest = std::max(largest,
                               distance(pcurve, t + (last - first) * k / (kIntervals * kSamples)));
        }
        return largest;
    }
};

Handle<Geom2d_BSplineCurve> cubic(const Handle<Geom2d_Curve>& pcurve, double first, double last) {
    constexpr int kDegree = 3;
    auto spline = occ::cast<Geom2d_BSplineCurve>(pcurve);
    spline = spline.IsNull() ? Geom2dConvert::CurveToBSplineCurve(
                                   occ::make<Geom2d_TrimmedCurve>(pcurve, first, last))
                             : occ::cast<Geom2d_BSplineCurve>(spline->Copy());
    if (spline->Degree() < kDegree) {
        spline->IncreaseDegree(kDegree);
    }
    return spline;
}

/// A pcurve with a mark: three cubic B-splines about a parameter, added to it. The middle one makes
/// the height there, the other two the slope.
class Mark {
  public:
    Mark(const Course& course, const Handle<Geom2d_Curve>& pcurve, int sample)
        : course_(course),
          at_(course.parameter(sample)),
          marked_(cubic(pcurve, course.first, course.last)) {
        step_ = (course.last - course.first) / (kIntervals * kKnotsPerInterval);
        std::vector<double> values{course.first};
        for (int k = -kKnots; k <= kKnots; ++k) {
            values.push_back(at_ + k * step_);
        }
        values.push_back(course.last);
        constexpr int kDegree = 3;
        const int knots = static_cast<int>(values.size());
        TColStd_Array1OfReal knot_values(1, knots);
        TColStd_Array1OfInteger multiplicities(1, knots);
        multiplicities.Init(1);
        multiplicities(1) = multiplicities(knots) = kDegree + 1;
        for (int k = 1; k <= knots; ++k) {
            knot_values(k) = values[static_cast<std::size_t>(k - 1)];
        }
        TColgp_Array1OfPnt2d poles(1, knots + kDegree - 1);
        const int middle = kDegree + kKnots;  // the pole whose B-spline is highest at the mark
        const gp_Pnt2d none(0.0, 0.0);
        poles.Init(none);
        // One component carries the height, the other the slope: both are scalars here.
        poles(middle) = gp_Pnt2d(1.0, 0.0);
        poles(middle - 1) = gp_Pnt2d(0.0, -1.0);
        poles(middle + 1) = gp_Pnt2d(0.0, 1.0);
        shape_ = occ::make<Geom2d_BSplineCurve>(poles, knot_values, multiplicities, kDegree);
        unite_knots();
        plain_ = occ::cast<Geom2d_BSplineCurve>(marked_->Copy());
        gp_Pnt2d uv;
        gp_Vec2d along;
        plain_->D1(at_, uv, along);
        direction_ = Vector2d(along.X(), along.Y());
    }

    /// Makes the distance at the mark the wanted one and the largest about it.
    void raise_to(double wanted) {
        for (int k = 0; k < kCorrections; ++k) {
            correct(wanted);
        }
    }

    [[nodiscard]] const Handle<Geom2d_BSplineCurve>& pcurve() const { return marked_; }

  private:
    void unite_knots() {
        const auto insert = [](const Handle<Geom2d_BSplineCurve>& from,
                               const Handle<Geom2d_BSplineCurve>& into) {
            const int inner = from->NbKnots() - 2;
            if (inner == 0) {
                return;
            }
            TColStd_Array1OfReal knots(1, inner);
            TColStd_Array1OfInteger multiplicities(1, inner);
            for (int k = 1; k <= inner; ++k) {
                knots(k) = from->Knot(k + 1);
                multiplicities(k) = from->Multiplicity(k + 1);
            }
            into->InsertKnots(knots, multiplicities);
        };
        if (shape_->Degree() < marked_->Degree()) {
            shape_->IncreaseDegree(marked_->Degree());
        }
        insert(shape_, marked_);
        insert(marked_, shape_);
    }

    /// One of Newton's steps.
    void correct(double wanted) {
        gp_Pnt at;
        gp_Vec along;
        course_.curve.D1(at_, at, along);
        gp_Pnt2d uv;
        gp_Vec2d speed;
        marked_->D1(at_, uv, speed);
        gp_Pnt image;
        gp_Vec du;
        gp_Vec dv;
        course_.surface.D1(uv.X(), uv.Y(), image, du, dv);
        const Vector3d miss = occ::from_occ(gp_Vec(image, at));
        const Vector3d u = occ::from_occ(du);
        const Vector3d v = occ::from_occ(dv);
        const Vector3d ahead = u * direction_.x() + v * direction_.y();
        // |miss - x ahead| = wanted, on the side where the mark is already.
        const double a = ahead.squaredNorm();
        const double b = miss.dot(ahead);
        const double root = b * b - a * (miss.squaredNorm() - wanted * wanted);
        if (!(root > 0.0) || a == 0.0) {
            return;
        }
        const double x = (b + (b <= 0.0 ? std::sqrt(root) : -std::sqrt(root))) / a;
        gp_Pnt2d value;
        gp_Vec2d slopes;
        shape_->D1(at_, value, slopes);
        height_ += x / value.X();
        apply();
        // The slope of the distance vanishes where the miss is square to its own change.
        marked_->D1(at_, uv, speed);
        course_.surface.D1(uv.X(), uv.Y(), image, du, dv);
        const Vector3d now = occ::from_occ(gp_Vec(image, at));
        const Vector3d change =
            occ::from_occ(along) - occ::from_occ(du) * speed.X() - occ::from_occ(dv) * speed.Y();
        slope_ += now.dot(change) / (now.dot(ahead) * slopes.Y());
        apply();
    }

    void apply() {
        for (int k = 1; k <= marked_->NbPoles(); ++k) {
            const gp_Pnt2d share = shape_->Pole(k);
            const Vector2d moved = occ::from_occ(plain_->Pole(k)) +
                                   (height_ * share.X() + slope_ * share.Y()) * direction_;
            marked_->SetPole(k, occ::to_point(moved));
        }
    }

    const Course& course_;
    double at_;
    double step_ = 0.0;
    Handle<Geom2d_BSplineCurve> marked_, plain_, shape_;
    Vector2d direction_;
    double height_ = 0.0, slope_ = 0.0;
};

}  // namespace

Handle<Geom2d_Curve> mark_gap(const Handle<Geom_Curve>& curve, double first, double last,
                              const Handle<Geom_Surface>& surface,
                              const Handle<Geom2d_Curve>& pcurve, double gap) {
    const Course course{*curve, *surface, first, last};
    if (gap <= Precision::Confusion() || course.shown(*pcurve) >= gap) {
        return pcurve;
    }
    // Where the least is there already; not at the ends, where curves meet.
    std::array<double, kIntervals - 1> distances{};
    std::array<int, kIntervals - 1> order{};
    std::iota(order.begin(), order.end(), 0);
    for (const int k : order) {
        distances[static_cast<std::size_t>(k)] = course.distance(*pcurve, course.parameter(k + 1));
    }
    std::ranges::stable_sort(order, {},
                             [&](int k) { return distances[static_cast<std::size_t>(k)]; });
    for (const int k : order) {
        const double wanted =
            std::max(kAboveGap * gap, kAboveDistance * distances[static_cast<std::size_t>(k)]);
        Mark mark(course, pcurve, k + 1);
        mark.raise_to(wanted);
        const Handle<Geom2d_Curve> marked = mark.pcurve();
        const double shown = course.shown(*marked);
        if (shown >= gap && shown >= course.largest_about(*marked, k + 1) &&
            shown <= kAboveDistance * kReadersMargin * wanted) {
            return marked;
        }
    }
    return pcurve;
}

}  // namespace suture
