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

/// The row on [from, to], which holds all inner knots: its ends are moved, inwards or outwards.
Row clamped(const Row& row, int degree, double from, double to) {
    const int count = static_cast<int>(row.poles.size());
    Row result = row;
    const auto slice = [&](int span) {
        return std::vector<Vector4d>(row.poles.begin() + span - degree,
                                     row.poles.begin() + span + 1);
    };
    const auto arguments = [&](const std::vector<double>& knots, int i) {
        return std::vector<double>(knots.begin() + i + 1, knots.begin() + i + 1 + degree);
    };
    if (from != row.knots[static_cast<std::size_t>(degree)] || from > row.knots.front()) {
        const int span = find_span(row.knots, degree, from);
        for (int i = 0; i <= degree; ++i) {
            result.knots[static_cast<std::size_t>(i)] = from;
        }
        for (int i = 0; i < degree; ++i) {
            result.poles[static_cast<std::size_t>(i)] =
                blossom(row.knots, degree, span, slice(span), arguments(result.knots, i));
        }
    }
    if (to != row.knots[static_cast<std::size_t>(count)] || to < row.knots.back()) {
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

Row extend_row(const Row& row, int degree, double from, double to) {
    return clamped(row, degree, std::min(from, row.knots[static_cast<std::size_t>(degree)]),
                   std::max(to, row.knots[row.poles.size()]));
}

Row restrict_row(const Row& row, int degree, double from, double to) {
    const double begin = row.knots[static_cast<std::size_t>(degree)];
    const double end = row.knots[row.poles.size()];
    from = std::clamp(from, begin, end);
    to = std::clamp(to, begin, end);
    // What lies in the spans from that of `from` to that of `to`.
    const int first = find_span(row.knots, degree, from);
    int last = find_span(row.knots, degree, to);
    while (last > first && row.knots[static_cast<std::size_t>(last)] >= to) {
        --last;  // `to` begins this span, or it is empty
    }
    const Row part{{row.knots.begin() + first - degree, row.knots.begin() + last + degree + 2},
                   {row.poles.begin() + first - degree, row.poles.begin() + last + 1}};
    return clamped(part, degree, from, to);
}

/// Applies a change of domain to all rows in u, then to all in v.
template <class Change>
SplineSurface by_rows(const SplineSurface& surface, const Change& change) {
    const int nu = surface.count_u();
    const int nv = surface.count_v();
    const Matrix4Xd poles = homogeneous(surface);
    SplineSurface result = surface;
    std::vector<Row> in_u;
    for (int j = 0; j < nv; ++j) {
        Row row{surface.knots_u, {}};
        for (int i = 0; i < nu; ++i) {
            row.poles.push_back(poles.col(surface.index(i, j)));
        }
        in_u.push_back(change(row, 0));
    }
    result.knots_u = in_u.front().knots;
    std::vector<Row> in_v;
    for (std::size_t i = 0; i < in_u.front().poles.size(); ++i) {
        Row row{surface.knots_v, {}};
        for (const Row& other : in_u) {
            row.poles.push_back(other.poles[i]);
        }
        in_v.push_back(change(row, 1));
    }
    result.knots_v = in_v.front().knots;
    const auto count = static_cast<Eigen::Index>(in_v.size() * in_v.front().poles.size());
    result.poles.resize(3, count);
    result.weights.resize(surface.rational() ? count : 0);
    Eigen::Index k = 0;
    for (std::size_t j = 0; j < in_v.front().poles.size(); ++j) {
        for (const Row& row : in_v) {
            const Vector4d& pole = row.poles[j];
            result.poles.col(k) = pole.head<3>() / pole[3];
            if (surface.rational()) {
                result.weights[k] = pole[3];
            }
            ++k;
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
    return by_rows(surface, [&](const Row& row, int c) {
        return c == 0 ? extend_row(row, surface.degree_u, u0, u1)
                      : extend_row(row, surface.degree_v, v0, v1);
    });
}

SplineSurface restricted(const SplineSurface& surface, double u0, double u1, double v0, double v1) {
    return by_rows(surface, [&](const Row& row, int c) {
        return c == 0 ? restrict_row(row, surface.degree_u, u0, u1)
                      : restrict_row(row, surface.degree_v, v0, v1);
    });
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
