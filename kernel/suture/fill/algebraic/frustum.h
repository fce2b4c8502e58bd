#pragma once

#include "suture/fill/algebraic/polynomial.h"

#include <Eigen/Core>

#include <vector>

namespace suture::algebraic {

/// A part of a cone of rays from a centre: the points centre + t (b0 d0 + b1 d1 + b2 d2) with
/// b0 + b1 + b2 = 1, b >= 0 and t0 <= t <= t1. With t0 = 0 it is a tetrahedron.
struct Frustum {
    Eigen::Vector3d centre;
    Eigen::Matrix3d directions;  ///< columns d0, d1, d2
    double t0 = 0.0, t1 = 1.0;
};

/// How many Bernstein coefficients a layer has.
constexpr int layer_size(int degree) {
    return (degree + 1) * (degree + 2) / 2;
}

/// The map from a polynomial's coefficients to its Bernstein coefficients over a frustum: of degree
/// `degree` both in t, which counts the layers from t0 to t1, and in b, within a layer.
/// Over each ray b the polynomial is one in t whose coefficients lie between a layer's extremes.
///
/// Result  (degree + 1) layer_size(degree) x monomial_count(degree), layer after layer.
[[nodiscard]] Eigen::MatrixXd bernstein_map(const Frustum& frustum, int degree);

/// The four frusta over the quarters of the triangle of rays.
[[nodiscard]] std::vector<Frustum> quartered(const Frustum& frustum);

/// What Bernstein coefficients prove of a polynomial over a frustum.
struct Proof {
    /// Each ray meets the zero set exactly once, and across it.
    bool single = false;
    /// dg/dt >= slope everywhere in the frustum, if positive.
    double slope = 0.0;
};

/// Input    sign: +1 if the polynomial grows with t where it is zero; margin: coefficients must
///          keep away from zero by as much; depth: how often the triangle may be quartered.
/// Source   one change of sign among Bernstein coefficients is one root (Descartes); Bajaj, Chen,
///          Xu, Modeling with cubic A-patches, 1995.
[[nodiscard]] Proof prove(const Polynomial<double>& p, const Frustum& frustum, double sign,
                          double margin, int depth);

}  // namespace suture::algebraic
