// Set-up, normals and curvatures of a FaceSide; its nearest points are in face_side_nearest.cpp.
#include "suture/check/face_side.h"

#include "suture/occ/handle.h"

#include <BRep_Tool.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

// A point nearer to a knot than this part of the parameter range lies on it. The steps off the knot
// are larger than that; what is extrapolated from two of them is off by about their square.
constexpr double kOnBreak = 1e-8;
constexpr double kOffBreak = 1e-6;
// An edge that crosses a knot line does not run along it: its inward direction is across by more
// than this part.
constexpr double kAcrossBreak = 1e-3;

// Below this ratio of the two tangents, or sine of the angle between them, the surface is singular:
// the normal's rounding error would reach 1e-8.
constexpr double kSingular = 1e-8;

// Step of the limit of a normal, as a part of the parameter ranges: three values at 1, 2, 4 steps
// are extrapolated, with an error of about 8 times the step's cube.
constexpr double kLimitStep = 1e-4;
// Extrapolated unit normals that keep less than this of their length have no common limit.
constexpr double kLimitLength = 0.9;

// Points of the edge at which the surface's knots that it passes are looked up.
constexpr int kPieceSamples = 129;
// How exactly a passage over a knot with a kink is found, and half of the piece around it.
constexpr int kHalvings = 24;
constexpr double kAtKink = 1e-5;

occ::Handle<Geom_Surface> untrimmed(occ::Handle<Geom_Surface> surface) {
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    return surface;
}

std::vector<double> intervals(const GeomAdaptor_Surface& surface, bool is_u, GeomAbs_Shape order) {
    const int count = is_u ? surface.NbUIntervals(order) : surface.NbVIntervals(order);
    TColStd_Array1OfReal ends(1, count + 1);
    if (is_u) {
        surface.UIntervals(ends, order);
    } else {
        surface.VIntervals(ends, order);
    }
    return {ends.begin(), ends.end()};
}

/// Where the surface's polynomial pieces end. OCCT calls a spline of class C4 CN, and counts one
/// interval.
std::vector<double> piece_ends(const GeomAdaptor_Surface& surface, bool is_u) {
    if (surface.GetType() != GeomAbs_BSplineSurface) {
        return intervals(surface, is_u, GeomAbs_CN);
    }
    const auto spline = surface.BSpline();
    const TColStd_Array1OfReal& knots = is_u ? spline->UKnots() : spline->VKnots();
    return {knots.begin(), knots.end()};
}

/// Where what is below at `low` ceases to be, up to `high`.
template <class Below>
double passage(double low, double high, Below&& below) {
    const bool low_is_below = below(low);
    for (int step = 0; step < kHalvings; ++step) {
        const double middle = 0.5 * (low + high);
        (below(middle) == low_is_below ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

bool is_finite(double value) {
    return !Precision::IsInfinite(value);
}

}  // namespace

FaceSide::FaceSide(const TopoDS_Face& face, const TopoDS_Edge& edge, EdgeRange range, double length)
    : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
      edge_(edge),
      range_(range),
      reversed_(face.Orientation() == TopAbs_REVERSED) {
    TopLoc_Location location;
    const auto surface = untrimmed(BRep_Tool::Surface(face_, location));
    moved_ = !location.IsIdentity();
    if (moved_) {
        to_model_ = location.Transformation();
        to_local_ = to_model_.Inverted();
        scale_ = std::abs(to_model_.ScaleFactor());
    }
    length_ = length / scale_;
    surface_.Load(surface);
    set_up_direction(directions_[0], true);
    set_up_direction(directions_[1], false);
    count_pieces();
}

bool FaceSide::is_elementary() const {
    switch (surface_.GetType()) {
        case GeomAbs_Plane:
        case GeomAbs_Cylinder:
        case GeomAbs_Cone:
        case GeomAbs_Sphere:
        case GeomAbs_Torus:
            return true;
        default:
            return false;
    }
}

void FaceSide::set_up_direction(Direction& direction, bool is_u) const {
    direction.low = is_u ? surface_.FirstUParameter() : surface_.FirstVParameter();
    direction.high = is_u ? surface_.LastUParameter() : surface_.LastVParameter();
    direction.periodic = is_u ? surface_.IsUPeriodic() : surface_.IsVPeriodic();
    direction.finite = is_finite(direction.low) && is_finite(direction.high);
    direction.bounded = direction.finite && !direction.periodic;
    direction.size = direction.finite ? direction.high - direction.low : length_;
    if (is_elementary()) {
        return;
    }
    direction.breaks = intervals(surface_, is_u, GeomAbs_C2);
    if (!direction.periodic) {
        direction.breaks.erase(direction.breaks.begin());
        direction.breaks.pop_back();
    }
}

double FaceSide::Direction::clamped(double value) const {
    return bounded ? std::clamp(value, low, high) : value;
}

bool FaceSide::Direction::at_break(double value) const {
    if (periodic) {
        value -= std::floor((value - low) / size) * size;
    }
    return std::ranges::any_of(
        breaks, [&](double knot) { return std::abs(value - knot) < kOnBreak * size; });
}

bool FaceSide::load_pcurve() {
    if (!pcurve_known_) {
        pcurve_known_ = true;
        const auto curve =
            BRep_Tool::CurveOnSurface(edge_, face_, pcurve_range_.first, pcurve_range_.last);
        if (!curve.IsNull()) {
            pcurve_.emplace(curve);
        }
    }
    return pcurve_.has_value();
}

double FaceSide::to_pcurve(double t) const {
    const double s = (t - range_.first) / (range_.last - range_.first);
    return pcurve_range_.first + s * (pcurve_range_.last - pcurve_range_.first);
}

void FaceSide::count_pieces() {
    if (is_elementary() || !load_pcurve()) {
        return;
    }
    std::array<std::vector<double>, 2> knots = {piece_ends(surface_, true),
                                                piece_ends(surface_, false)};
    std::array<double, 2> before = {};
    for (int i = 0; i < kPieceSamples; ++i) {
        const double s = static_cast<double>(i) / (kPieceSamples - 1);
        const gp_Pnt2d uv =
            pcurve_->Value(to_pcurve(range_.first + s * (range_.last - range_.first)));
        const std::array<double, 2> now = {uv.X(), uv.Y()};
        for (const std::size_t k : {0U, 1U}) {
            for (const double knot : knots.at(k)) {
                if (i == 0 || (before.at(k) < knot) == (now.at(k) < knot)) {
                    continue;
                }
                const double t = (knot - before.at(k)) / (now.at(k) - before.at(k));
                const double at = (i - 1 + t) / (kPieceSamples - 1);
                if (!directions_.at(k).at_break(knot)) {
                    passages_.push_back(at);
                    continue;
                }
                // The curvature jumps there: a narrow piece of its own, so that both limits are
                // seen.
                const double exact =
                    passage((i - 1.0) / (kPieceSamples - 1),
                            static_cast<double>(i) / (kPieceSamples - 1), [&](double part) {
                                const gp_Pnt2d there = pcurve_->Value(
                                    to_pcurve(range_.first + part * (range_.last - range_.first)));
                                return (k == 0 ? there.X() : there.Y()) < knot;
                            });
                passages_.push_back(std::max(0.0, exact - kAtKink));
                passages_.push_back(std::min(1.0, exact + kAtKink));
            }
        }
        before = now;
    }
    pieces_ += static_cast<int>(passages_.size());
    if (surface_.GetType() == GeomAbs_BSplineSurface ||
        surface_.GetType() == GeomAbs_BezierSurface) {
        degree_ = std::max(surface_.UDegree(), surface_.VDegree());
    }
}

FaceSide::Jet FaceSide::jet(const gp_Pnt2d& uv) const {
    Jet result;
    surface_.D2(uv.X(), uv.Y(), result.P, result.Su, result.Sv, result.Suu, result.Svv, result.Suv);
    return result;
}

gp_Vec2d FaceSide::inward(double t) {
    if (!load_pcurve()) {
        return {};
    }
    gp_Pnt2d at;
    gp_Vec2d along;
    pcurve_->D1(to_pcurve(t), at, along);
    const double side = edge_.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    // In units of the parameter ranges, so that both directions count alike.
    const gp_Vec2d left(-along.Y() * side / directions_[1].size,
                        along.X() * side / directions_[0].size);
    const double size = left.Magnitude();
    return size > 0.0 ? left / size : gp_Vec2d();
}

gp_Vec2d FaceSide::off_breaks(double t, const gp_Pnt2d& uv) {
    std::array<double, 2> offset = {0.0, 0.0};
    for (const std::size_t k : {0U, 1U}) {
        const Direction& direction = directions_.at(k);
        if (!direction.at_break(k == 0 ? uv.X() : uv.Y())) {
            continue;
        }
        const gp_Vec2d into = inward(t);
        const double across = k == 0 ? into.X() : into.Y();
        if (std::abs(across) > kAcrossBreak) {
            offset.at(k) = std::copysign(kOffBreak * direction.size, across);
        }
    }
    return {offset[0], offset[1]};
}

bool FaceSide::regular(const Jet& at) const {
    const double along_u = at.Su.Magnitude();
    const double along_v = at.Sv.Magnitude();
    const double size_u = along_u * directions_[0].size;
    const double size_v = along_v * directions_[1].size;
    const double size = std::max(size_u, size_v);
    return std::min(size_u, size_v) > kSingular * size &&
           at.Su.CrossMagnitude(at.Sv) > kSingular * along_u * along_v;
}

gp_Vec FaceSide::local_normal(const Jet& at) const {
    const gp_Vec n = at.Su.Crossed(at.Sv).Normalized();
    return reversed_ ? -n : n;
}

std::optional<gp_Vec> FaceSide::limit_normal(double t, const gp_Pnt& local) {
    if (surface_.GetType() == GeomAbs_Sphere) {
        const gp_Sphere sphere = surface_.Sphere();
        const gp_Vec radial = gp_Vec(sphere.Location(), local).Normalized();
        return sphere.Direct() != reversed_ ? radial : -radial;
    }
    if (!load_pcurve()) {
        return std::nullopt;
    }
    // Into the face and along the edge to its middle, so that a pole that is an end of the edge and
    // a side of the surface that is singular as a whole are both left.
    const double along = t < 0.5 * (range_.first + range_.last) ? 1.0 : -1.0;
    const gp_Vec2d into = inward(t);
    gp_Vec sum;
    for (const auto& [steps, weight] : {std::pair(1.0, 8.0), {2.0, -6.0}, {4.0, 1.0}}) {
        const double h = steps * kLimitStep;
        const gp_Pnt2d on_curve =
            pcurve_->Value(to_pcurve(t + along * h * (range_.last - range_.first)));
        const gp_Pnt2d uv(
            directions_[0].clamped(on_curve.X() + h * into.X() * directions_[0].size),
            directions_[1].clamped(on_curve.Y() + h * into.Y() * directions_[1].size));
        const Jet near = jet(uv);
        if (!regular(near)) {
            return std::nullopt;
        }
        sum += weight / 3.0 * local_normal(near);
    }
    if (std::abs(sum.Magnitude() - 1.0) > 1.0 - kLimitLength) {
        return std::nullopt;
    }
    return sum.Normalized();
}

std::optional<double> FaceSide::curvature(const Jet& at, const gp_Vec& normal,
                                          const gp_Vec& tangent) const {
    const gp_Vec d = normal.Crossed(tangent);
    if (d.Magnitude() <= kSingular * tangent.Magnitude()) {
        return std::nullopt;
    }
    // d = a Su + b Sv by the first fundamental form; d lies in the tangent plane.
    const double E = at.Su.SquareMagnitude();
    const double F = at.Su * at.Sv;
    const double G = at.Sv.SquareMagnitude();
    const double determinant = E * G - F * F;
    const double a = (G * (d * at.Su) - F * (d * at.Sv)) / determinant;
    const double b = (E * (d * at.Sv) - F * (d * at.Su)) / determinant;
    const double second =
        a * a * (normal * at.Suu) + 2.0 * a * b * (normal * at.Suv) + b * b * (normal * at.Svv);
    return second / d.SquareMagnitude();
}

/// Let x run along d in the tangent plane and w(x) = a x + b x^2/2 + ... be the parameters of the
/// section's points: a solves dS(a) = d, b cancels the tangential part of d2S(a,a). The height's
/// third derivative, n (d3S(a,a,a) + 3 d2S(a,b)), is the curvature's first: the height's second
/// derivative is the curvature but for terms of second order in x.
double FaceSide::slope(const gp_Pnt2d& uv, const Jet& at, const gp_Vec& normal,
                       const gp_Vec& tangent) const {
    gp_Pnt P;
    gp_Vec Su, Sv, Suu, Svv, Suv, Suuu, Svvv, Suuv, Suvv;
    surface_.D3(uv.X(), uv.Y(), P, Su, Sv, Suu, Svv, Suv, Suuu, Svvv, Suuv, Suvv);
    const double E = at.Su.SquareMagnitude();
    const double F = at.Su * at.Sv;
    const double G = at.Sv.SquareMagnitude();
    const double determinant = E * G - F * F;
    const auto parameters = [&](const gp_Vec& d) {
        return gp_Vec2d((G * (d * at.Su) - F * (d * at.Sv)) / determinant,
                        (E * (d * at.Sv) - F * (d * at.Su)) / determinant);
    };
    const gp_Vec2d a = parameters(normal.Crossed(tangent).Normalized());
    const gp_Vec second =
        a.X() * a.X() * at.Suu + 2.0 * a.X() * a.Y() * at.Suv + a.Y() * a.Y() * at.Svv;
    const gp_Vec2d b = parameters(-second);
    const gp_Vec third = a.X() * a.X() * (a.X() * Suuu + 3.0 * a.Y() * Suuv) +
                         a.Y() * a.Y() * (a.Y() * Svvv + 3.0 * a.X() * Suvv);
    const gp_Vec mixed =
        a.X() * b.X() * at.Suu + (a.X() * b.Y() + a.Y() * b.X()) * at.Suv + a.Y() * b.Y() * at.Svv;
    return normal * (third + 3.0 * mixed);
}

void FaceSide::set_local(BorderPoint& result, double t, const gp_Pnt2d& uv, const gp_Pnt& local,
                         const gp_Vec& tangent, bool with_slope) {
    const gp_Vec2d offset = off_breaks(t, uv);
    const bool on_break = offset.SquareMagnitude() > 0.0;
    const gp_Pnt2d inside = on_break ? uv.Translated(offset) : uv;
    const Jet there = jet(inside);
    if (!regular(there)) {
        result.normal = limit_normal(t, local);
        return;
    }
    result.normal = local_normal(there);
    result.curvature = curvature(there, *result.normal, tangent);
    if (with_slope && result.curvature) {
        // On a knot line not extrapolated: of a third derivative, a step off the knot is exact
        // enough.
        result.curvature_slope = slope(inside, there, *result.normal, tangent);
    }
    if (!on_break) {
        return;
    }
    // On a knot line: the limits from inside the face, from two values.
    const Jet further = jet(uv.Translated(2.0 * offset));
    if (!regular(further)) {
        return;
    }
    const gp_Vec normal = local_normal(further);
    const auto bend = curvature(further, normal, tangent);
    result.normal = (2.0 * *result.normal - normal).Normalized();
    if (result.curvature && bend) {
        result.curvature = 2.0 * *result.curvature - *bend;
    }
}

gp_Pnt2d FaceSide::parameters(double t, const gp_Pnt& point) {
    gp_Pnt on_surface;
    return nearest(t, moved_ ? point.Transformed(to_local_) : point, on_surface);
}

BorderPoint FaceSide::at(double t, const gp_Pnt& point, const gp_Vec& derivative, bool with_slope) {
    const gp_Pnt local = moved_ ? point.Transformed(to_local_) : point;
    const gp_Vec tangent = moved_ ? derivative.Transformed(to_local_) : derivative;
    BorderPoint result;
    const gp_Pnt2d uv = nearest(t, local, result.point);
    set_local(result, t, uv, local, tangent, with_slope);
    if (moved_) {
        result.point.Transform(to_model_);
        // A mirror turns X_u x X_v round; the border, which it turns too, stays on its left.
        const double sign = to_model_.IsNegative() ? -1.0 : 1.0;
        if (result.normal) {
            result.normal = sign * result.normal->Transformed(to_model_).Normalized();
        }
        if (result.curvature) {
            *result.curvature *= sign / scale_;
        }
        if (result.curvature_slope) {
            *result.curvature_slope *= sign / (scale_ * scale_);
        }
    }
    return result;
}

}  // namespace suture
