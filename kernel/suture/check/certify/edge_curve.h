#pragma once

#include "suture/check/certify/bezier_piece.h"

#include <TopoDS_Edge.hxx>
#include <gp_Ax2.hxx>

#include <optional>
#include <string>
#include <vector>

namespace suture::certify {

/// The curve of an edge as the certificate sees it: line, conic or B-spline.
class EdgeCurve {
  public:
    /// Refuses  any other curve, and an edge without one: `reason` says so.
    explicit EdgeCurve(const TopoDS_Edge& edge);

    [[nodiscard]] const std::string& reason() const { return reason_; }

    /// Stretches of the whole edge in each of which the curve is one piece.
    [[nodiscard]] std::vector<Span> pieces() const;

    /// The curve over a stretch of one piece, counted from the origin.
    [[nodiscard]] TaylorModel3 model(const Span& stretch,
                                     const std::array<double, 3>& origin) const;

  private:
    /// center + f(t) x + g(t) y, with f and g by kind: t and 0; cos t and sin t; t^2 and t; cosh t
    /// and sinh t.
    struct Conic {
        enum class Kind { Line, Ellipse, Parabola, Hyperbola };
        Kind kind = Kind::Line;
        std::array<double, 3> center = {}, x = {}, y = {};
    };
    void set_conic(Conic::Kind kind, const gp_Ax2& frame, double x, double y);

    Span range_;
    std::optional<Conic> conic_;
    std::optional<SplineCurve> spline_;
    std::string reason_;
};

}  // namespace suture::certify
