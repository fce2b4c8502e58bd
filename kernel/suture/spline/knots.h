#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture {

/// The span [knots[k], knots[k+1]) that holds t, with degree <= k < count; outside of the domain
/// the first or last span that is not empty.
[[nodiscard]] int find_span(const std::vector<double>& knots, int degree, double t);

/// The degree + 1 basis functions that live on a span, and their derivatives.
///
/// Result   (orders + 1) x (degree + 1): row d holds the d-th derivatives of N[span-degree..span].
/// Source   Piegl & Tiller, The NURBS Book, A2.3.
[[nodiscard]] Eigen::MatrixXd basis_derivatives(const std::vector<double>& knots, int degree,
                                                int span, double t, int orders);

}  // namespace suture
