#include "suture/fill/manifold/surface.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

/// Basis functions of an order up to this are evaluated without asking for memory.
constexpr int kMaxDegree = 25;

/// The span of half-open knot intervals [t_a, t_(a+1)) that holds t, or none.
std::optional<int> span_of(const std::vector<double>& knots, double t) {
    if (!(t >= knots.front() && t < knots.back())) {
        return std::nullopt;
    }
    return static_cast<int>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin()) - 1;
}

/// Values of the basis functions span - degree ... span; those beyond the knots' ends, which no
/// chart has, come out as zero.
void basis(const std::vector<double>& knots, int degree, int span, double t, double* values) {
    std::fill(values, values + degree + 1, 0.0);
    values[degree] = 1.0;
    const int last = static_cast<int>(knots.size()) - 1;
    const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
    // Cox - de Boor, function by function of rising degree d.
    for (int d = 1; d <= degree; ++d) {
        for (int a = degree - d; a <= degree; ++a) {
            const int i = span - degree + a;
            if (i < 0 || i + d + 1 > last) {
                values[a] = 0.0;
                continue;
            }
            double value = 0.0;
            if (a > degree - d) {
                value += (t - knot(i)) / (knot(i + d) - knot(i)) * values[a];
            }
            if (a < degree) {
                value += (knot(i + d + 1) - t) / (knot(i + d + 1) - knot(i + 1)) * values[a + 1];
            }
            values[a] = value;
        }
    }
}

/// Knots with `degree` more at either end, so that every span is an inner one.
std::vector<double> padded(const std::vector<double>& knots, int degree) {
    std::vector<double> result;
    for (int a = degree; a > 0; --a) {
        result.push_back(knots.front() - a);
    }
    result.insert(result.end(), knots.begin(), knots.end());
    for (int a = 1; a <= degree; ++a) {
        result.push_back(knots.back() + a);
    }
    return result;
}

/// Row d: the d-th Taylor coefficients of the basis functions span - degree ... span.
Eigen::MatrixXd taylor_basis(const std::vector<double>& knots, int degree, int span, double t,
                             int order) {
    Eigen::MatrixXd rows =
        basis_derivatives(padded(knots, degree), degree, span + degree, t, order);
    double factorial = 1.0;
    for (int d = 2; d <= order; ++d) {
        factorial *= d;
        rows.row(d) /= factorial;
    }
    return rows;
}

}  // namespace

Shares shares_at(const Star& star, const Vector2d& p) {
    const int degree = star.degree();
    Shares shares;
    std::vector<double> weights;
    double sum = 0.0;
    for (int m = 0; m < star.n(); ++m) {
        const Vector2d local = star.to_side(m, p);
        const double x = local.x() - star.mu(local.y());
        const auto span_x = span_of(star.knots_x(m), x);
        const auto span_y = span_of(star.knots_y(m), local.y());
        if (!span_x || !span_y) {
            continue;
        }
        std::array<double, kMaxDegree + 1> nx{};
        std::array<double, kMaxDegree + 1> ny{};
        basis(star.knots_x(m), degree, *span_x, x, nx.data());
        basis(star.knots_y(m), degree, *span_y, local.y(), ny.data());
        for (int j = std::max(0, *span_y - degree); j <= std::min(star.charts_y(m) - 1, *span_y);
             ++j) {
            for (int i = std::max(0, *span_x - degree); i <= std::min(star.charts_x() - 1, *span_x);
                 ++i) {
                if (!star.kept(m, i, j)) {
                    continue;
                }
                const int point = star.point_of(m, i, j);
                shares.points.push_back(point);
                weights.push_back(star.weight(point) *
                                  nx[static_cast<std::size_t>(i - *span_x + degree)] *
                                  ny[static_cast<std::size_t>(j - *span_y + degree)]);
                sum += weights.back();
            }
        }
    }
    shares.weights =
        Eigen::RowVectorXd::Map(weights.data(), static_cast<Eigen::Index>(weights.size())) / sum;
    return shares;
}

StarSurface::StarSurface(Star star, const Eigen::Matrix3Xd& points) : star_(std::move(star)) {
    move(points);
}

void StarSurface::move(const Eigen::Matrix3Xd& points) {
    SUTURE_EXPECTS(points.cols() == star_.count());
    SUTURE_EXPECTS(star_.degree() <= kMaxDegree);
    points_ = points;
    nets_.clear();
    for (int m = 0; m < star_.n(); ++m) {
        const int rows = star_.charts_x();
        Eigen::Matrix4Xd net = Eigen::Matrix4Xd::Zero(4, rows * star_.charts_y(m));
        for (int j = 0; j < star_.charts_y(m); ++j) {
            for (int i = 0; i < rows; ++i) {
                if (star_.kept(m, i, j)) {
                    const int point = star_.point_of(m, i, j);
                    net.col(i + rows * j) << points.col(point), 1.0;
                    net.col(i + rows * j) *= star_.weight(point);
                }
            }
        }
        nets_.push_back(std::move(net));
    }
}

void StarSurface::add_side(int m, const Vector2d& p, Vector4d& sum) const {
    const Vector2d local = star_.to_side(m, p);
    const std::vector<double>& knots_x = star_.knots_x(m);
    const std::vector<double>& knots_y = star_.knots_y(m);
    const auto span_y = span_of(knots_y, local.y());
    if (!span_y) {
        return;
    }
    const double x = local.x() - star_.mu(local.y());
    const auto span_x = span_of(knots_x, x);
    if (!span_x) {
        return;
    }
    const int degree = star_.degree();
    std::array<double, kMaxDegree + 1> nx{};
    std::array<double, kMaxDegree + 1> ny{};
    basis(knots_x, degree, *span_x, x, nx.data());
    basis(knots_y, degree, *span_y, local.y(), ny.data());
    const Eigen::Matrix4Xd& net = nets_[static_cast<std::size_t>(m)];
    const int rows = star_.charts_x();
    const int from_i = std::max(0, *span_x - degree);
    const int to_i = std::min(rows - 1, *span_x);
    const int to_j = std::min(star_.charts_y(m) - 1, *span_y);
    for (int j = std::max(0, *span_y - degree); j <= to_j; ++j) {
        Vector4d row = Vector4d::Zero();
        for (int i = from_i; i <= to_i; ++i) {
            row += nx[static_cast<std::size_t>(i - *span_x + degree)] * net.col(i + rows * j);
        }
        sum += ny[static_cast<std::size_t>(j - *span_y + degree)] * row;
    }
}

Vector4d StarSurface::sum(const Vector2d& p) const {
    Vector4d sum = Vector4d::Zero();
    for (int m = 0; m < star_.n(); ++m) {
        add_side(m, p, sum);
    }
    return sum;
}

Eigen::Vector3d StarSurface::at(const Vector2d& p) const {
    const Vector4d h = sum(p);
    return h.head<3>() / h[3];
}

Series<4> StarSurface::expand_sum(const Series<1>& x, const Series<1>& y,
                                  const Vector2d& towards) const {
    const int order = x.order();
    const int degree = star_.degree();
    Series<4> total(order);
    for (int m = 0; m < star_.n(); ++m) {
        const Vector2d ex = star_.to_side(m, Vector2d::UnitX());
        const Vector2d ey = star_.to_side(m, Vector2d::UnitY());
        const Vector2d near = star_.to_side(m, towards);
        const auto span_y = span_of(star_.knots_y(m), near.y());
        const auto span_x = span_of(star_.knots_x(m), near.x() - star_.mu(near.y()));
        if (!span_x || !span_y) {
            continue;
        }
        const Series<1> local_y = ex.y() * x + ey.y() * y;
        const double y0 = local_y.term(0, 0)[0];
        const Series<1> dy = increment(local_y);
        const Series<1> local_x =
            ex.x() * x + ey.x() * y - polynomial(star_.mu_series(y0, near.y(), order), dy);
        const double x0 = local_x.term(0, 0)[0];
        const Series<1> dx = increment(local_x);
        const Eigen::MatrixXd nx = taylor_basis(star_.knots_x(m), degree, *span_x, x0, order);
        const Eigen::MatrixXd ny = taylor_basis(star_.knots_y(m), degree, *span_y, y0, order);
        const Eigen::Matrix4Xd& net = nets_[static_cast<std::size_t>(m)];
        const int rows = star_.charts_x();
        Series<4> side(order);
        for (int j = std::max(0, *span_y - degree); j <= std::min(star_.charts_y(m) - 1, *span_y);
             ++j) {
            for (int i = std::max(0, *span_x - degree); i <= std::min(rows - 1, *span_x); ++i) {
                for (int a = 0; a <= order; ++a) {
                    for (int b = 0; a + b <= order; ++b) {
                        side.term(a, b) += nx(a, i - *span_x + degree) *
                                           ny(b, j - *span_y + degree) * net.col(i + rows * j);
                    }
                }
            }
        }
        total += compose(side, dx, dy);
    }
    return total;
}

Series<3> StarSurface::expand(const Series<1>& x, const Series<1>& y,
                              const Vector2d& towards) const {
    return project(expand_sum(x, y, towards));
}

Series<3> StarSurface::expand(const Vector2d& p, int order) const {
    return expand(variable(p.x(), 0, order), variable(p.y(), 1, order), p);
}

}  // namespace suture::manifold
