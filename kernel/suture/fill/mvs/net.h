#pragma once

#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

inline constexpr int kDegree = 5;
inline constexpr int kOrder = kDegree + 1;      ///< basis functions on a span
inline constexpr int kLocal = kOrder * kOrder;  ///< on a span of the net
inline constexpr int kDerivatives = 9;          ///< in the order of variation.h

/// One direction of the net: a clamped knot vector. Inside are simple knots, and those of knot
/// lines (knot_lines.h), four in one place, between which spans are empty.
struct Axis {
    std::vector<double> knots;

    [[nodiscard]] int count() const { return static_cast<int>(knots.size()) - kOrder; }
    [[nodiscard]] int spans() const { return count() - kDegree; }
    [[nodiscard]] double lower(int span) const {
        return knots[static_cast<std::size_t>(span + kDegree)];
    }
    [[nodiscard]] double upper(int span) const { return lower(span + 1); }
    [[nodiscard]] bool empty(int span) const { return !(upper(span) > lower(span)); }
    /// Whether the span ends at a knot line.
    [[nodiscard]] bool beside_line(int span) const {
        return (span > 0 && empty(span - 1)) || (span + 1 < spans() && empty(span + 1));
    }
    /// The span 0 <= k < spans() that holds t, never an empty one.
    [[nodiscard]] int span_of(double t) const;
};

[[nodiscard]] Axis uniform_axis(double lower, double upper, int spans);

/// The axis with additional knots in the middle of the marked spans.
[[nodiscard]] Axis halved(const Axis& axis, const std::vector<bool>& marked);

/// The same values as coefficients on a finer axis, whose knots contain all of the old ones:
/// Boehm's insertion, exact. Coefficients: dim x count.
[[nodiscard]] Eigen::MatrixXd refine(const Axis& coarse, const Axis& fine,
                                     const Eigen::MatrixXd& coefficients);

/// The six functions that live on a span, and their derivatives up to order three.
struct BasisRow {
    int first = 0;                            ///< the span, and the first of the six
    Eigen::Matrix<double, 4, kOrder> values;  ///< row d: d-th derivatives
};
[[nodiscard]] BasisRow basis_row(const Axis& axis, double t);
/// The same of a given span, at whose ends too.
[[nodiscard]] BasisRow basis_row(const Axis& axis, int span, double t);

/// The 36 products of two rows: column d holds derivative d of variation.h.
using LocalBasis = Eigen::Matrix<double, kLocal, kDerivatives>;
[[nodiscard]] LocalBasis local_basis(const BasisRow& u, const BasisRow& v);
using LocalValues = Eigen::Matrix<double, kLocal, 1>;
[[nodiscard]] LocalValues local_values(const BasisRow& u, const BasisRow& v);

/// A net of poles over two axes.
struct Net {
    Axis u, v;
    Eigen::Matrix3Xd poles;  ///< 3 x (u.count() * v.count()), u fastest

    [[nodiscard]] int unknowns() const { return 3 * u.count() * v.count(); }
    /// The 36 poles behind a span.
    [[nodiscard]] Eigen::Matrix<double, 3, kLocal> local_poles(int span_u, int span_v) const;
};

[[nodiscard]] Net refine(const Net& net, const Axis& u, const Axis& v);

/// The net over other axes between the same ends that has the same points where the functions of
/// those have their middles (Greville's abscissae).
[[nodiscard]] Net interpolated(const Net& net, const Axis& u, const Axis& v);

/// Gram matrices of one axis: entry (d, e) of band k is the integral of B_i^(d) B_{i+k}^(d).
/// Result: matrices[d] is count x kOrder, column k the k-th upper diagonal, for d = 0..3.
[[nodiscard]] std::vector<Eigen::MatrixXd> gram_matrices(const Axis& axis);

/// Nodes and weights on [0,1] of the Gauss rule with 2, 3, 4 or 6 points.
struct GaussRule {
    std::vector<double> nodes, weights;
};
[[nodiscard]] const GaussRule& gauss_rule(int points);

}  // namespace suture::mvs
