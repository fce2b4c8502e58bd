#pragma once

#include "suture/fill/concentric/closed_spline.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// The two factors of the map's Jacobian, which is linear in t:
///     S(s,t) = (1-t) gamma(s) + t c(s),   J = (1-t) [gamma' x (c-gamma)] + t [c' x (c-gamma)],
/// so that the map folds nowhere if and only if neither factor is negative.
struct JacobianFactors {
    Eigen::VectorXd boundary;  ///< Bernstein coefficients of gamma' x (c - gamma)
    Eigen::VectorXd axis;      ///< of c' x (c - gamma)
};

/// Input    pieces over the same interval.
[[nodiscard]] JacobianFactors jacobian_factors(const BezierPiece& gamma, const BezierPiece& c);

/// The verdict on one interval.
enum class Certificate {
    Positive,  ///< proved by Bernstein coefficients, after subdivision where they need it
    Folded     ///< one factor is negative somewhere, or cannot be told from it
};

/// Input    slack: how negative a factor may be by rounding, in the factors' unit, length^2 over
///          parameter.
[[nodiscard]] Certificate certify(const BezierPiece& gamma, const BezierPiece& c, double slack);

/// A closed curve's polynomials, ready to be looked up by parameter, cyclic.
class BoundaryPieces {
  public:
    explicit BoundaryPieces(const ClosedSpline& curve);

    /// The parts that make up [from, to], which may lie on any turn.
    [[nodiscard]] std::vector<BezierPiece> between(double from, double to) const;
    [[nodiscard]] const std::vector<BezierPiece>& all() const { return pieces_; }
    [[nodiscard]] Eigen::Vector2d at(double s) const;

    /// The slack of a certificate for this curve: rounding errors and nothing else.
    [[nodiscard]] double slack() const { return slack_; }

  private:
    std::vector<BezierPiece> pieces_;
    double period_ = 0.0;
    double slack_ = 0.0;
};

/// Certifies a piece of the concentric curve from its start to its end.
[[nodiscard]] Certificate certify(const BoundaryPieces& boundary, const ConcentricCurve& curve,
                                  const Course& course);

/// All courses that are not proved positive, as indices of `courses(curve)`.
[[nodiscard]] std::vector<int> folded_courses(const BoundaryPieces& boundary,
                                              const ConcentricCurve& curve);

}  // namespace suture::concentric
