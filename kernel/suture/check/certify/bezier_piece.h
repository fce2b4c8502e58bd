#pragma once

#include "suture/check/certify/taylor_model.h"

#include <array>
#include <vector>

namespace suture::certify {

/// A non-periodic B-spline surface with homogeneous poles (w x, w y, w z, w), numbered with v
/// fastest.
struct SplineSurface {
    int degree_u = 1, degree_v = 1;
    std::vector<double> knots_u, knots_v;  ///< with their multiplicities
    std::vector<std::array<double, 4>> poles;
    bool rational = false;

    [[nodiscard]] int poles_u() const { return static_cast<int>(knots_u.size()) - degree_u - 1; }
    [[nodiscard]] int poles_v() const { return static_cast<int>(knots_v.size()) - degree_v - 1; }
};

/// The same for a curve.
struct SplineCurve {
    int degree = 1;
    std::vector<double> knots;
    std::vector<std::array<double, 4>> poles;
    bool rational = false;
};

struct Span {
    double low = 0.0, high = 1.0;
};

/// A curve over one stretch inside a knot span.
///
/// Input   k: knots[k] <= low, high <= knots[k + 1]; origin: from which the points are counted, so
///         that they, and their rounding errors, are small.
[[nodiscard]] TaylorModel3 curve_model(const SplineCurve& curve, int k, const Span& stretch,
                                       const std::array<double, 3>& origin);

/// One polynomial (or rational) piece of a surface over a box of its parameters, as a function of
/// x, y in [-1, 1] that run over the box. The box may reach beyond the piece: then this is the
/// continued polynomial.
class BezierPiece {
  public:
    BezierPiece(const SplineSurface& surface, int ku, int kv, const Span& u, const Span& v,
                const std::array<double, 3>& origin);

    /// A derivative by x and y along the path x(t), y(t).
    struct Jet {
        TaylorModel3 S, Sx, Sy;
    };
    [[nodiscard]] Jet along(const TaylorModel& x, const TaylorModel& y) const;

    /// Bounds of the derivatives over the whole box.
    struct Bounds {
        Interval3 S, Sx, Sy, Sxx, Sxy, Syy;
    };
    [[nodiscard]] Bounds bounds() const;

    /// Where the piece is one point P for x = -1: (S - P) / (x + 1), a polynomial or rational too.
    [[nodiscard]] Jet divided(const TaylorModel& x, const TaylorModel& y) const;

  private:
    /// Homogeneous derivative of order (i, j) along the path.
    [[nodiscard]] std::array<TaylorModel, 4> derivative(int i, int j, const TaylorModel& x,
                                                        const TaylorModel& y) const;
    [[nodiscard]] std::array<Interval, 4> bound(int i, int j) const;

    int p_, q_;
    bool rational_;
    // Coefficients of x^i y^j at i (q + 1) + j, and how far each may be off.
    std::array<std::vector<double>, 4> powers_;
    std::array<std::vector<double>, 4> errors_;
    // How far a Bezier point may be off. A derivative by x is p/2 times a difference of two of
    // them.
    std::array<double, 4> net_error_ = {};
};

}  // namespace suture::certify
