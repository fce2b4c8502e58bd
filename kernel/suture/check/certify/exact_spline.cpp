#include "suture/check/certify/exact_spline.h"

#include <BRepTools.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_SweptSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>

namespace suture::certify {

namespace {

// Roundings of a conversion, of the largest coordinate: sines and products of a few numbers.
constexpr double kConversion = 64 * kRounding;

// A swept surface is converted this part of its face's range beyond it, so that an edge of the face
// is none of the spline's border.
constexpr double kBeyond = 0.05;

constexpr int kNewtonSteps = 12;

occ::Handle<Geom_Surface> untrimmed(occ::Handle<Geom_Surface> surface) {
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    return surface;
}

/// A range of one parameter of a face, widened as far as the surface goes.
struct Range {
    double low = 0.0, high = 0.0;

    /// Input  period: 0 where there is none.
    void widen(double first, double last, double period) {
        double by = kBeyond * (high - low);
        if (period > 0.0) {
            by = std::clamp(0.5 * (period - (high - low)), 0.0, by);
            low -= by;
            high += by;
            return;
        }
        low = std::max(low - by, first);
        high = std::min(high + by, last);
    }
};

bool is_conic_or_spline(const occ::Handle<Geom_Curve>& curve) {
    const GeomAbs_CurveType type = GeomAdaptor_Curve(curve).GetType();
    return type != GeomAbs_OffsetCurve && type != GeomAbs_OtherCurve;
}

/// Knot index ranges between knots of multiplicity `degree` or more, each with full ends.
struct Part {
    std::vector<double> knots;
    int first_pole = 0;
};

std::vector<Part> smooth_parts(const std::vector<double>& knots, int degree) {
    const auto p = static_cast<std::size_t>(degree);
    std::vector<Part> parts;
    std::size_t start = 0;  // before the last `degree` knots at the part's beginning
    for (std::size_t k = p + 1; k < knots.size();) {
        std::size_t end = k;
        while (end < knots.size() && knots[end] == knots[k]) {
            ++end;
        }
        if (end - k >= p) {
            // The last p of the knots at the part's beginning, and the first p at its end.
            const auto from = static_cast<std::ptrdiff_t>(start);
            const auto to = static_cast<std::ptrdiff_t>(k + p);
            Part part;
            part.knots.push_back(knots[start + 1]);
            part.knots.insert(part.knots.end(), knots.begin() + from + 1, knots.begin() + to);
            part.knots.push_back(knots[k]);
            part.first_pole = static_cast<int>(start);
            parts.push_back(std::move(part));
            start = end - p - 1;
        }
        k = end;
    }
    return parts;
}

std::vector<double> to_vector(const TColStd_Array1OfReal& knots) {
    return {knots.begin(), knots.end()};
}

}  // namespace

ExactSpline::ExactSpline(const TopoDS_Face& face, const occ::Handle<Geom_Surface>& surface) {
    whole_ = convert(face, surface);
    if (!reason_.empty()) {
        return;
    }
    whole_->SetUNotPeriodic();
    whole_->SetVNotPeriodic();
    const auto parts_u = smooth_parts(to_vector(whole_->UKnotSequence()), whole_->UDegree());
    const auto parts_v = smooth_parts(to_vector(whole_->VKnotSequence()), whole_->VDegree());
    for (const Part& u : parts_u) {
        for (const Part& v : parts_v) {
            SplineSurface piece;
            piece.degree_u = whole_->UDegree();
            piece.degree_v = whole_->VDegree();
            piece.knots_u = u.knots;
            piece.knots_v = v.knots;
            piece.rational = whole_->IsURational() || whole_->IsVRational();
            for (int i = 1; i <= piece.poles_u(); ++i) {
                for (int j = 1; j <= piece.poles_v(); ++j) {
                    const gp_Pnt p = whole_->Pole(u.first_pole + i, v.first_pole + j);
                    const double w = whole_->Weight(u.first_pole + i, v.first_pole + j);
                    piece.poles.push_back({w * p.X(), w * p.Y(), w * p.Z(), w});
                    const double size =
                        std::max({std::abs(p.X()), std::abs(p.Y()), std::abs(p.Z())});
                    rounding_ = std::max(rounding_, other_parameters_ ? kConversion * size : 0.0);
                }
            }
            std::vector<PoleOfSpline> poles = find_poles(piece);
            pieces_.push_back({std::move(piece), std::move(poles)});
        }
    }
}

occ::Handle<Geom_BSplineSurface> ExactSpline::convert(const TopoDS_Face& face,
                                                      const occ::Handle<Geom_Surface>& surface) {
    if (const auto offset = occ::cast<Geom_OffsetSurface>(surface)) {
        const auto basis = untrimmed(offset->BasisSurface());
        const auto type = GeomAdaptor_Surface(basis).GetType();
        if (type != GeomAbs_BSplineSurface && type != GeomAbs_BezierSurface) {
            reason_ = "an offset of a surface that is no B-spline";
            return {};
        }
        offset_ = offset->Offset();
        return GeomConvert::SurfaceToBSplineSurface(basis);
    }
    const auto swept = occ::cast<Geom_SweptSurface>(surface);
    if (!swept) {
        if (!occ::cast<Geom_BSplineSurface>(surface) && !occ::cast<Geom_BezierSurface>(surface)) {
            reason_ = "of a kind that is not treated";
            return {};
        }
        return GeomConvert::SurfaceToBSplineSurface(surface);
    }
    if (!is_conic_or_spline(swept->BasisCurve())) {
        reason_ = "a sweep of a curve that is no line, conic or B-spline";
        return {};
    }
    other_parameters_ = true;
    Range u;
    Range v;
    BRepTools::UVBounds(face, u.low, u.high, v.low, v.high);
    double first_u = 0.0;
    double last_u = 0.0;
    double first_v = 0.0;
    double last_v = 0.0;
    surface->Bounds(first_u, last_u, first_v, last_v);
    periods_ = {surface->IsUPeriodic() ? surface->UPeriod() : 0.0,
                surface->IsVPeriodic() ? surface->VPeriod() : 0.0};
    u.widen(first_u, last_u, periods_[0]);
    v.widen(first_v, last_v, periods_[1]);
    return GeomConvert::SurfaceToBSplineSurface(
        new Geom_RectangularTrimmedSurface(surface, u.low, u.high, v.low, v.high));
}

Span ExactSpline::range(std::size_t direction) const {
    const auto knots = [&](const SmoothPiece& piece) -> const std::vector<double>& {
        return direction == 0 ? piece.surface.knots_u : piece.surface.knots_v;
    };
    return {knots(pieces_.front()).front(), knots(pieces_.back()).back()};
}

std::vector<double> ExactSpline::kinks(std::size_t direction) const {
    std::vector<double> kinks;
    for (const SmoothPiece& piece : pieces_) {
        kinks.push_back(direction == 0 ? piece.surface.knots_u.front()
                                       : piece.surface.knots_v.front());
    }
    std::ranges::sort(kinks);
    kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
    kinks.erase(kinks.begin());
    return kinks;
}

std::array<double, 2> ExactSpline::parameters(const gp_Pnt2d& uv, const gp_Pnt& point) const {
    if (!other_parameters_) {
        return {uv.X(), uv.Y()};
    }
    // Both run over the same ranges, but not equally fast: from there, by Gauss and Newton.
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    whole_->Bounds(u0, u1, v0, v1);
    const auto inside = [](double value, double low, double high, double period) {
        const double rounding = 1e-9 * (high - low);
        if (period > 0.0 && (value < low - rounding || value > high + rounding)) {
            value -= period * std::floor((value - low) / period);
        }
        return std::clamp(value, low, high);
    };
    double u = inside(uv.X(), u0, u1, periods_[0]);
    double v = inside(uv.Y(), v0, v1, periods_[1]);
    for (int step = 0; step < kNewtonSteps; ++step) {
        gp_Pnt at;
        gp_Vec along_u;
        gp_Vec along_v;
        whole_->D1(u, v, at, along_u, along_v);
        const gp_Vec to(at, point);
        const double a = along_u.SquareMagnitude();
        const double b = along_u * along_v;
        const double c = along_v.SquareMagnitude();
        const double determinant = a * c - b * b;
        if (!(determinant > 0.0)) {
            break;
        }
        const double gu = to * along_u;
        const double gv = to * along_v;
        const double next_u = std::clamp(u + (c * gu - b * gv) / determinant, u0, u1);
        const double next_v = std::clamp(v + (a * gv - b * gu) / determinant, v0, v1);
        const bool settled =
            std::abs(next_u - u) < 1e-14 * (u1 - u0) && std::abs(next_v - v) < 1e-14 * (v1 - v0);
        u = next_u;
        v = next_v;
        if (settled) {
            break;
        }
    }
    return {u, v};
}

}  // namespace suture::certify
