#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture {

/// A polynomial B-spline curve in any dimension, 0-based; its domain is
/// [knots[degree], knots[count]], and the knots at its ends may be simple.
struct SplineCurve {
    int degree = 1;
    std::vector<double> knots;
    Eigen::MatrixXd poles;  ///< dimension x count

    [[nodiscard]] int count() const { return static_cast<int>(poles.cols()); }
    [[nodiscard]] double begin() const { return knots[static_cast<std::size_t>(degree)]; }
    [[nodiscard]] double end() const { return knots[static_cast<std::size_t>(count())]; }
};

/// A polynomial on [from, to] by its Bezier points.
struct BezierPiece {
    double from = 0.0;
    double to = 1.0;
    Eigen::MatrixXd poles;  ///< dimension x (degree + 1)

    [[nodiscard]] int degree() const { return static_cast<int>(poles.cols()) - 1; }
};

/// The derivatives of order 0 to `orders` at t, one a column: dimension x (orders + 1).
[[nodiscard]] Eigen::MatrixXd evaluate(const SplineCurve& curve, double t, int orders = 0);

/// The blossom of the polynomial on the span [knots[span], knots[span + 1]] at `arguments`, one
/// for each degree.
[[nodiscard]] Eigen::VectorXd blossom(const SplineCurve& curve, int span,
                                      const std::vector<double>& arguments);

/// The same curve over other knots, all inside of its domain: a refinement of its own, whose ends
/// may lie anywhere.
///
/// Source   Ramshaw, Blossoming, 1987: the new poles are blossoms at the new knots.
[[nodiscard]] SplineCurve refined(const SplineCurve& curve, const std::vector<double>& knots);

/// The same curve with further knots inserted.
[[nodiscard]] SplineCurve with_knots(const SplineCurve& curve, const std::vector<double>& more);

/// The same curve with a degree that is at least its own, smooth as it was.
[[nodiscard]] SplineCurve elevated(const SplineCurve& curve, int degree);

/// The mean of the degree inner knots of each pole: where its influence is greatest.
[[nodiscard]] std::vector<double> greville(const SplineCurve& curve);

/// The polynomials that it is made of.
[[nodiscard]] std::vector<BezierPiece> bezier_pieces(const SplineCurve& curve);

/// A polynomial's part on [from, to].
[[nodiscard]] BezierPiece part_of(const BezierPiece& piece, double from, double to);

/// All pieces as one curve that is continuous: knots between them stand `degree` times.
///
/// Input    pieces of one degree, each beginning where the last one ends.
[[nodiscard]] SplineCurve joined(const std::vector<BezierPiece>& pieces);

}  // namespace suture
