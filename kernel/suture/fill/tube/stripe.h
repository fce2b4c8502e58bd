#pragma once

#include "suture/fill/tube/net.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

/// The paper's preliminary stripe: quadratic pieces of the border and of its tangent field, and the
/// control points that have them as their curve. The method itself interpolates the border
/// (border_fit.h), which is more exact than either, unless it is asked for these; both are exact
/// where the pieces join with a continuous tangent.
namespace suture::tube {

/// a0 + a1 x + a2 x^2 for x in [0,1], one column each.
using Piece = Eigen::Matrix3d;
/// A curve or a field of vectors.
using Curve = std::function<Eigen::Vector3d(double t)>;

/// Pieces through the curve's points at t_k, t_k+1 and in the middle between: Bezier segments in
/// the curve's own parameter.
[[nodiscard]] std::vector<Piece> bezier_pieces(const Curve& curve, const std::vector<double>& t);

/// Taylor polynomials of degree 2 about the beginning of each piece.
[[nodiscard]] std::vector<Piece> taylor_pieces(const Curve& curve, const Curve& first,
                                               const Curve& second, const std::vector<double>& t);

/// Knot intervals around in proportion to the pieces' chords, as many as pieces, their mean 1.
[[nodiscard]] std::vector<double> chord_lengths(const std::vector<Piece>& pieces);

/// What is beyond the ends of a row of intervals.
enum class Ends {
    Repeated,  ///< the outermost intervals again
    Clamped,   ///< none: the spline ends in its first and last column
    Closed,    ///< the intervals go around; the last two columns are the first two
};

/// Control points of the quadratic spline with these intervals, two more than pieces; interval k
/// has columns k, k + 1 and k + 2.
///
/// march      each piece in its turn sets its three columns, as equations (10) and (11) do, so that
///            the columns of the last one to come remain.
/// fit_all    the least squares of the difference to all pieces at once.
[[nodiscard]] Eigen::Matrix3Xd march(const std::vector<Piece>& pieces,
                                     const std::vector<double>& intervals, Ends ends);
[[nodiscard]] Eigen::Matrix3Xd fit_all(const std::vector<Piece>& pieces,
                                       const std::vector<double>& intervals, Ends ends);

/// The points in rows 0 and 1 of one patch of the closing part on uniform knots: equations (18) to
/// (23). As they stand they give one patch its conditions (12) to (17); for a whole tube they would
/// contradict each other from patch to patch, so there every column has an end tangent of its own.
///
/// Input    third: the patch's row 2; first, other: end tangents at its two sides.
/// Result   [row][column]
[[nodiscard]] std::array<std::array<Eigen::Vector3d, 3>, 2> closing_points(
    const Eigen::Vector3d& pole, const Eigen::Vector3d& first, const Eigen::Vector3d& other,
    const std::array<Eigen::Vector3d, 3>& third);

/// The five rows on uniform, unclamped knots across that have the same surface as a net with the
/// knots 0 0 0 0 1 2 2 2 2: the paper's own, with phantom points in rows 0, 1, 3 and 4.
[[nodiscard]] Eigen::Matrix3Xd phantom_rows(const Net& net);

}  // namespace suture::tube
