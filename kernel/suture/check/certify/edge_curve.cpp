#include "suture/check/certify/edge_curve.h"

#include "suture/occ/handle.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Hypr.hxx>
#include <gp_Lin.hxx>
#include <gp_Parab.hxx>

namespace suture::certify {

namespace {

std::array<double, 3> to_array(const gp_XYZ& v) {
    return {v.X(), v.Y(), v.Z()};
}

SplineCurve from_occ(const Geom_BSplineCurve& curve) {
    SplineCurve result;
    result.degree = curve.Degree();
    result.rational = curve.IsRational();
    const TColStd_Array1OfReal& knots = curve.KnotSequence();
    result.knots.assign(knots.begin(), knots.end());
    for (int i = 1; i <= curve.NbPoles(); ++i) {
        const gp_Pnt p = curve.Pole(i);
        const double w = curve.Weight(i);
        result.poles.push_back({w * p.X(), w * p.Y(), w * p.Z(), w});
    }
    return result;
}

}  // namespace

EdgeCurve::EdgeCurve(const TopoDS_Edge& edge) {
    auto curve = BRep_Tool::Curve(edge, range_.low, range_.high);
    if (curve.IsNull()) {
        reason_ = "the edge has no curve in space";
        return;
    }
    while (const auto trimmed = occ::cast<Geom_TrimmedCurve>(curve)) {
        curve = trimmed->BasisCurve();
    }
    const GeomAdaptor_Curve adaptor(curve);
    switch (adaptor.GetType()) {
        case GeomAbs_Line: {
            const gp_Lin line = adaptor.Line();
            conic_ = Conic{Conic::Kind::Line, to_array(line.Location().XYZ()),
                           to_array(line.Direction().XYZ())};
            return;
        }
        case GeomAbs_Circle: {
            const gp_Circ circle = adaptor.Circle();
            set_conic(Conic::Kind::Ellipse, circle.Position(), circle.Radius(), circle.Radius());
            return;
        }
        case GeomAbs_Ellipse: {
            const gp_Elips ellipse = adaptor.Ellipse();
            set_conic(Conic::Kind::Ellipse, ellipse.Position(), ellipse.MajorRadius(),
                      ellipse.MinorRadius());
            return;
        }
        case GeomAbs_Parabola: {
            const gp_Parab parabola = adaptor.Parabola();
            set_conic(Conic::Kind::Parabola, parabola.Position(), 0.25 / parabola.Focal(), 1.0);
            return;
        }
        case GeomAbs_Hyperbola: {
            const gp_Hypr hyperbola = adaptor.Hyperbola();
            set_conic(Conic::Kind::Hyperbola, hyperbola.Position(), hyperbola.MajorRadius(),
                      hyperbola.MinorRadius());
            return;
        }
        case GeomAbs_BSplineCurve:
        case GeomAbs_BezierCurve: {
            auto spline = GeomConvert::CurveToBSplineCurve(curve);
            if (spline->IsPeriodic()) {
                spline = GeomConvert::CurveToBSplineCurve(
                    new Geom_TrimmedCurve(curve, range_.low, range_.high));
            }
            spline_ = from_occ(*spline);
            return;
        }
        default:
            reason_ = "its curve is no line, conic or B-spline";
    }
}

void EdgeCurve::set_conic(Conic::Kind kind, const gp_Ax2& frame, double x, double y) {
    conic_ = Conic{kind, to_array(frame.Location().XYZ()), to_array(x * frame.XDirection().XYZ()),
                   to_array(y * frame.YDirection().XYZ())};
}

std::vector<Span> EdgeCurve::pieces() const {
    std::vector<double> ends = {range_.low, range_.high};
    if (conic_ && conic_->kind != Conic::Kind::Line) {
        // The series of sine, cosine and exponential are good for a radian or so.
        const int parts = static_cast<int>(std::ceil(range_.high - range_.low));
        for (int i = 1; i < parts; ++i) {
            ends.push_back(range_.low + (range_.high - range_.low) * i / parts);
        }
    }
    if (spline_) {
        for (const double knot : spline_->knots) {
            if (knot > range_.low && knot < range_.high) {
                ends.push_back(knot);
            }
        }
    }
    std::ranges::sort(ends);
    std::vector<Span> pieces;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        if (ends[i] < ends[i + 1]) {
            pieces.push_back({ends[i], ends[i + 1]});
        }
    }
    return pieces;
}

TaylorModel3 EdgeCurve::model(const Span& stretch, const std::array<double, 3>& origin) const {
    const double middle = 0.5 * (stretch.low + stretch.high);
    if (spline_) {
        const auto& knots = spline_->knots;
        const auto p = static_cast<std::size_t>(spline_->degree);
        const auto above = std::upper_bound(knots.begin() + spline_->degree,
                                            knots.end() - spline_->degree - 1, middle);
        const auto k = std::max(p, static_cast<std::size_t>(above - knots.begin()) - 1);
        return curve_model(*spline_, static_cast<int>(k), stretch, origin);
    }
    // A little longer than half, so that neighbouring stretches leave nothing out between them.
    const double half = 0.5 * (stretch.high - stretch.low) + 2 * kRounding * std::abs(middle);
    const TaylorModel t = TaylorModel::linear(middle, half);
    TaylorModel f = t;
    TaylorModel g;
    switch (conic_->kind) {
        case Conic::Kind::Line:
            break;
        case Conic::Kind::Ellipse:
            f = cosine(middle, half);
            g = sine(middle, half);
            break;
        case Conic::Kind::Parabola:
            f = t * t;
            g = t;
            break;
        case Conic::Kind::Hyperbola: {
            const TaylorModel growing = exponential(middle, half);
            const TaylorModel falling = exponential(-middle, -half);
            f = TaylorModel(0.5) * (growing + falling);
            g = TaylorModel(0.5) * (growing - falling);
        }
    }
    TaylorModel3 result;
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = std::abs(conic_->center.at(i)) + std::abs(origin.at(i));
        const TaylorModel center =
            TaylorModel(conic_->center.at(i) - origin.at(i)).widened(4 * kRounding * size);
        result.at(i) = center + TaylorModel(conic_->x.at(i)) * f + TaylorModel(conic_->y.at(i)) * g;
    }
    return result;
}

}  // namespace suture::certify
