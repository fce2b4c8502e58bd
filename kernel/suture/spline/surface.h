#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture {

/// A tensor-product B-spline surface, polynomial or rational, 0-based.
///
/// knots_u has count_u + degree_u + 1 entries, non-decreasing; likewise v. The domain is
/// [knots_u[degree_u], knots_u[count_u]] x [knots_v[degree_v], knots_v[count_v]].
struct SplineSurface {
    int degree_u = 1;
    int degree_v = 1;
    std::vector<double> knots_u;
    std::vector<double> knots_v;
    Eigen::Matrix3Xd poles;   ///< 3 x (count_u * count_v), u fastest
    Eigen::VectorXd weights;  ///< count_u * count_v, or empty when polynomial

    [[nodiscard]] int count_u() const { return static_cast<int>(knots_u.size()) - degree_u - 1; }
    [[nodiscard]] int count_v() const { return static_cast<int>(knots_v.size()) - degree_v - 1; }
    [[nodiscard]] int index(int i, int j) const { return i + count_u() * j; }
    [[nodiscard]] bool rational() const { return weights.size() > 0; }
};

/// A planar B-spline curve, the trimming curve of a surface.
struct SplineCurve2d {
    int degree = 1;
    std::vector<double> knots;
    Eigen::Matrix2Xd poles;  ///< 2 x count
};

/// Value and partial derivatives of a surface at one parameter.
struct SurfaceJet {
    Eigen::Vector3d point, u, v, uu, uv, vv;
};

/// Point and derivatives up to order two.
///
/// Input    u, v anywhere; outside of the domain the outermost span's polynomial goes on.
/// Source   de Boor, A practical guide to splines, ch. X; quotient rule for the rational case.
[[nodiscard]] SurfaceJet evaluate(const SplineSurface& surface, double u, double v);

/// The same surface on a domain that contains [u0,u1] x [v0,v1]: the outermost spans' polynomials
/// go on, exactly (blossoming). Bounds inside the old domain leave that side where it is. The knots
/// at the ends of the result have multiplicity degree + 1.
[[nodiscard]] SplineSurface extended(const SplineSurface& surface, double u0, double u1, double v0,
                                     double v1);

/// The same surface on the part of its domain in [u0,u1] x [v0,v1]. Bounds outside of the domain
/// leave that side where it is; u0 < u1 and v0 < v1 meet the domain.
[[nodiscard]] SplineSurface restricted(const SplineSurface& surface, double u0, double u1,
                                       double v0, double v1);

/// A surface that closes on itself, on `turns` of its periods: the same points again and again.
///
/// Input    the first and last row of poles (in u, in v) agree; turns >= 1; first: by how many
///          periods the new domain begins before the old one.
[[nodiscard]] SplineSurface repeated_u(const SplineSurface& surface, int turns, int first);
[[nodiscard]] SplineSurface repeated_v(const SplineSurface& surface, int turns, int first);

/// The same surface with u and v exchanged.
[[nodiscard]] SplineSurface transposed(const SplineSurface& surface);

}  // namespace suture
