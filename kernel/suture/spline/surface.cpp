#include "suture/spline/surface.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace suture {
namespace {

using Eigen::Matrix4Xd;
using Eigen::Vector4d;

/// Homogeneous poles (w x, w y, w z, w).
Matrix4Xd homogeneous(const SplineSurface& surface) {
    Matrix4Xd result(4, surface.poles.cols());
    for (Eigen::Index k = 0; k < surface.poles.cols(); ++k) {
        const double w = surface.rational() ? surface.weights[k] : 1.0;
        result.col(k) << w * surface.poles.col(k), w;
    }
    return result;
}

/// The blossom of the span [knots[span], knots[span+1]] at the given arguments, one per degree.
/// poles: the degree + 1 poles of that span.
Vector4d blossom(const std::vector<double>& knots, int degree, int span,
                 std::vector<Vector4d> poles, const std::vector<double>& arguments) {
    for (int r = 1; r <= degree; ++r) {
        for (int i = degree; i >= r; --i) {
            const double a = knots[static_cast<std::size_t>(span - degree + i)];
            const double b = knots[static_cast<std::size_t>(span + 1 + i - r)];
            const double s = (arguments[static_cast<std::size_t>(r - 1)] - a) / (b - a);
            const auto k = static_cast<std::size_t>(i);
            poles[k] = (1.0 - s) * poles[k - 1] + s * poles[k];
        }
    }
    return poles[static_cast<std::size_t>(degree)];
}

/// One row of poles on a domain that reaches to `from` and `to`.
struct Row {
    std::vector<double> knots;
    std::vector<Vector4d> poles;
};

Row extend_row(const Row& row, int degree, double from, double to) {
    const int count = static_cast<int>(row.poles.size());
    Row result = row;
    const auto slice = [&](int span) {
        return std::vector<Vector4d>(row.poles.begin() + span - degree,
                                     row.poles.begin() + span + 1);
    };
    const auto arguments = [&](const std::vector<double>& knots, int i) {
        return std::vector<double>(knots.begin() + i + 1, knots.begin() + i + 1 + degree);
    };
    from = std::min(from, row.knots[static_cast<std::size_t>(degree)]);
    to = std::max(to, row.knots[static_cast<std::size_t>(count)]);
    if (from < row.knots[static_cast<std::size_t>(degree)] || from > row.knots.front()) {
        const int span = find_span(row.knots, degree, from);
        for (int i = 0; i <= degree; ++i) {
            result.knots[static_cast<std::size_t>(i)] = from;
        }
        for (int i = 0; i < degree; ++i) {
            result.poles[static_cast<std::size_t>(i)] =
                blossom(row.knots, degree, span, slice(span), arguments(result.knots, i));
        }
    }
    if (to > row.knots[static_cast<std::size_t>(count)] || to < row.knots.back()) {
        const int span = find_span(row.knots, degree, to);
        for (int i = 0; i <= degree; ++i) {
            result.knots[static_cast<std::size_t>(count + i)] = to;
        }
        for (int i = count - degree; i < count; ++i) {
            result.poles[static_cast<std::size_t>(i)] =
                blossom(row.knots, degree, span, slice(span), arguments(result.knots, i));
        }
    }
    return result;
}

}  // namespace

SurfaceJet evaluate(const SplineSurface& surface, double u, double v) {
    SUTURE_EXPECTS(surface.poles.cols() == surface.count_u() * surface.count_v());
    const int p = surface.degree_u;
    const int q = surface.degree_v;
    const int span_u = find_span(surface.knots_u, p, u);
    const int span_v = find_span(surface.knots_v, q, v);
    const Eigen::MatrixXd Nu = basis_derivatives(surface.knots_u, p, span_u, u, 2);
    const Eigen::MatrixXd Nv = basis_derivatives(surface.knots_v, q, span_v, v, 2);
    // A(i, j): homogeneous derivative of order i in u and j in v, i + j <= 2.
    Vector4d A[3][3];
    for (int i = 0; i <= 2; ++i) {
        for (int j = 0; i + j <= 2; ++j) {
            Vector4d sum = Vector4d::Zero();
            for (int b = 0; b <= q; ++b) {
                for (int a = 0; a <= p; ++a) {
                    const int k = surface.index(span_u - p + a, span_v - q + b);
                    const double w = surface.rational() ? surface.weights[k] : 1.0;
                    Vector4d pole;
                    pole << w * surface.poles.col(k), w;
                    sum += Nu(i, a) * Nv(j, b) * pole;
                }
            }
            A[i][j] = sum;
        }
    }
    const double w = A[0][0][3];
    const double wu = A[1][0][3];
    const double wv = A[0][1][3];
    SurfaceJet jet;
    jet.point = A[0][0].head<3>() / w;
    jet.u = (A[1][0].head<3>() - wu * jet.point) / w;
    jet.v = (A[0][1].head<3>() - wv * jet.point) / w;
    jet.uu = (A[2][0].head<3>() - 2.0 * wu * jet.u - A[2][0][3] * jet.point) / w;
    jet.uv = (A[1][1].head<3>() - wu * jet.v - wv * jet.u - A[1][1][3] * jet.point) / w;
    jet.vv = (A[0][2].head<3>() - 2.0 * wv * jet.v - A[0][2][3] * jet.point) / w;
    return jet;
}

SplineSurface extended(const SplineSurface& surface, double u0, double u1, double v0, double v1) {
    const int nu = surface.count_u();
    const int nv = surface.count_v();
    Matrix4Xd poles = homogeneous(surface);
    SplineSurface result = surface;
    for (int j = 0; j < nv; ++j) {
        Row row{surface.knots_u, {}};
        for (int i = 0; i < nu; ++i) {
            row.poles.push_back(poles.col(surface.index(i, j)));
        }
        row = extend_row(row, surface.degree_u, u0, u1);
        for (int i = 0; i < nu; ++i) {
            poles.col(surface.index(i, j)) = row.poles[static_cast<std::size_t>(i)];
        }
        result.knots_u = row.knots;
    }
    for (int i = 0; i < nu; ++i) {
        Row row{surface.knots_v, {}};
        for (int j = 0; j < nv; ++j) {
            row.poles.push_back(poles.col(surface.index(i, j)));
        }
        row = extend_row(row, surface.degree_v, v0, v1);
        for (int j = 0; j < nv; ++j) {
            poles.col(surface.index(i, j)) = row.poles[static_cast<std::size_t>(j)];
        }
        result.knots_v = row.knots;
    }
    for (Eigen::Index k = 0; k < poles.cols(); ++k) {
        result.poles.col(k) = poles.col(k).head<3>() / poles(3, k);
        if (result.rational()) {
            result.weights[k] = poles(3, k);
        }
    }
    return result;
}

SplineSurface transposed(const SplineSurface& surface) {
    SplineSurface result = surface;
    std::swap(result.degree_u, result.degree_v);
    std::swap(result.knots_u, result.knots_v);
    for (int j = 0; j < surface.count_v(); ++j) {
        for (int i = 0; i < surface.count_u(); ++i) {
            result.poles.col(result.index(j, i)) = surface.poles.col(surface.index(i, j));
            if (surface.rational()) {
                result.weights[result.index(j, i)] = surface.weights[surface.index(i, j)];
            }
        }
    }
    return result;
}

SplineSurface repeated_v(const SplineSurface& surface, int turns, int first) {
    const int n = surface.count_v();
    const int q = surface.degree_v;
    const auto& knots = surface.knots_v;
    const double period = knots[static_cast<std::size_t>(n)] - knots[static_cast<std::size_t>(q)];
    const int nu = surface.count_u();
    SplineSurface result = surface;
    result.knots_v.assign(knots.begin(), knots.begin() + q + 1);
    for (int turn = 0; turn < turns; ++turn) {
        // Each turn brings its inner knots and the next joint, with one knot less than a border.
        for (int k = q + 1; k < n + q; ++k) {
            result.knots_v.push_back(knots[static_cast<std::size_t>(k)] + turn * period);
        }
    }
    result.knots_v.push_back(result.knots_v.back());
    for (double& knot : result.knots_v) {
        knot -= first * period;
    }
    const int rows = (n - 1) * turns + 1;
    result.poles.resize(3, nu * rows);
    result.weights.resize(surface.rational() ? nu * rows : 0);
    for (int j = 0; j < rows; ++j) {
        const int from = j == rows - 1 ? n - 1 : j % (n - 1);
        for (int i = 0; i < nu; ++i) {
            result.poles.col(i + nu * j) = surface.poles.col(surface.index(i, from));
            if (surface.rational()) {
                result.weights[i + nu * j] = surface.weights[surface.index(i, from)];
            }
        }
    }
    return result;
}

SplineSurface repeated_u(const SplineSurface& surface, int turns, int first) {
    return transposed(repeated_v(transposed(surface), turns, first));
}

}  // namespace suture
