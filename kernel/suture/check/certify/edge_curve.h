#pragma once

#include "suture/check/certify/bezier_piece.h"

#include <TopoDS_Edge.hxx>

#include <optional>
#include <string>
#include <vector>

namespace suture::certify {

/// The curve of an edge as the certificate sees it: line, circle, ellipse or B-spline.
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
    /// center + cos(t) x + sin(t) y, or center + t x.
    struct Conic {
        std::array<double, 3> center = {}, x = {}, y = {};
        bool straight = false;
    };
    Span range_;
    std::optional<Conic> conic_;
    std::optional<SplineCurve> spline_;
    std::string reason_;
};

}  // namespace suture::certify
