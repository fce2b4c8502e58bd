#include "suture/fill/manifold/ring.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/series.h"
#include "suture/spline/knots.h"

#include <array>
#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sums the entries of a row that belong to the same control point.
void gather(BorderRow& row) {
    BorderRow result;
    result.weights.resize(row.weights.rows(), 0);
    for (std::size_t k = 0; k < row.points.size(); ++k) {
        const auto found = std::find(result.points.begin(), result.points.end(), row.points[k]);
        const auto column = static_cast<Eigen::Index>(found - result.points.begin());
        if (found == result.points.end()) {
            result.points.push_back(row.points[k]);
            result.weights.conservativeResize(Eigen::NoChange, column + 1);
            result.weights.col(column).setZero();
        }
        result.weights.col(column) += row.weights.col(static_cast<Eigen::Index>(k));
    }
    row = std::move(result);
}

/// Taylor series of the polar coordinates about (rho, 0), by the Cartesian (dx, dy), to order 3.
std::array<Series<1>, 2> polar(double rho) {
    Series<1> radius(3);
    radius.term(1, 0)[0] = 1.0;
    radius.term(0, 2)[0] = 1.0 / (2.0 * rho);
    radius.term(1, 2)[0] = -1.0 / (2.0 * rho * rho);
    Series<1> angle(3);
    angle.term(0, 1)[0] = 1.0 / rho;
    angle.term(1, 1)[0] = -1.0 / (rho * rho);
    angle.term(2, 1)[0] = 1.0 / (rho * rho * rho);
    angle.term(0, 3)[0] = -1.0 / (3.0 * rho * rho * rho);
    return {radius, angle};
}

}  // namespace

Ring::Ring(int k, int layers, int columns) : k_(k), layers_(layers), columns_(columns) {
    knots_x_.assign(static_cast<std::size_t>(degree()), 0.0);
    for (int i = 0; i <= layers; ++i) {
        knots_x_.push_back(i);
    }
    knots_x_.insert(knots_x_.end(), static_cast<std::size_t>(degree()), layers);
    for (int j = -degree(); j <= columns + degree(); ++j) {
        knots_y_.push_back(2.0 * kPi * j / columns);
    }
}

void Ring::add_pole(int i, int j, const VectorXd& weights, BorderRow& row) const {
    const auto add = [&](int point, double factor) {
        row.points.push_back(point);
        row.weights.conservativeResize(weights.size(),
                                       static_cast<Eigen::Index>(row.points.size()));
        row.weights.rightCols(1) = factor * weights;
    };
    const int column = ((j % columns_) + columns_) % columns_;
    if (i >= 2) {
        add(3 + column + columns_ * (i - 2), 1.0);
        return;
    }
    add(0, 1.0);
    if (i == 1) {
        // The middle of the basis function's support.
        const double y = 2.0 * kPi * (column + 0.5 * (degree() + 1) - degree()) / columns_;
        add(1, std::cos(y));
        add(2, std::sin(y));
    }
}

BorderRow Ring::row_at(double y) const {
    const int span_x = find_span(knots_x_, degree(), layers_);
    const int span_y = find_span(knots_y_, degree(), y);
    const MatrixXd bx = basis_derivatives(knots_x_, degree(), span_x, layers_, 2);
    const MatrixXd by = basis_derivatives(knots_y_, degree(), span_y, y, 1);
    BorderRow row;
    for (int b = 0; b <= degree(); ++b) {
        for (int a = 0; a <= degree(); ++a) {
            Eigen::Vector4d weights(bx(0, a) * by(0, b), bx(1, a) * by(0, b), bx(0, a) * by(1, b),
                                    bx(2, a) * by(0, b));
            add_pole(span_x - degree() + a, span_y - degree() + b, weights, row);
        }
    }
    gather(row);
    return row;
}

Eigen::SparseMatrix<double> Ring::energy() const {
    std::vector<Eigen::Triplet<double>> entries;
    const double factorials[] = {1.0, 1.0, 2.0, 6.0};
    const double step_y = 2.0 * kPi / columns_;
    for (int p = 0; p < layers_; ++p) {
        const double x = p + 0.5;
        const double rho = x / layers_;
        const auto [radius, angle] = polar(rho);
        const MatrixXd bx =
            basis_derivatives(knots_x_, degree(), find_span(knots_x_, degree(), x), x, 3);
        for (int q = 0; q < columns_; ++q) {
            const double y = (q + 0.5) * step_y;
            const int span_x = find_span(knots_x_, degree(), x);
            const int span_y = find_span(knots_y_, degree(), y);
            const MatrixXd by = basis_derivatives(knots_y_, degree(), span_y, y, 3);
            BorderRow row;
            for (int b = 0; b <= degree(); ++b) {
                for (int a = 0; a <= degree(); ++a) {
                    Series<1> basis(3);
                    for (int d = 0; d <= 3; ++d) {
                        for (int e = 0; d + e <= 3; ++e) {
                            // x runs to `layers` where the disc's radius runs to 1.
                            basis.term(d, e)[0] = bx(d, a) * by(e, b) * std::pow(layers_, d) /
                                                  (factorials[d] * factorials[e]);
                        }
                    }
                    const Series<1> flat = compose(basis, radius, angle);
                    const Eigen::Vector4d third(flat.derivative(3, 0)[0], flat.derivative(2, 1)[0],
                                                flat.derivative(1, 2)[0], flat.derivative(0, 3)[0]);
                    add_pole(span_x - degree() + a, span_y - degree() + b, third, row);
                }
            }
            gather(row);
            const double area = rho / layers_ * step_y;
            const Eigen::Vector4d multiplicity(1.0, 3.0, 3.0, 1.0);
            const MatrixXd form =
                area * row.weights.transpose() * multiplicity.asDiagonal() * row.weights;
            for (std::size_t a = 0; a < row.points.size(); ++a) {
                for (std::size_t b = 0; b < row.points.size(); ++b) {
                    entries.emplace_back(
                        row.points[a], row.points[b],
                        form(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
                }
            }
        }
    }
    Eigen::SparseMatrix<double> result(count(), count());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

BorderModel Ring::border_model(double diameter) const {
    BorderModel model;
    model.k = k_;
    model.points = count();
    std::vector<double>& knots = model.knots.emplace_back();
    for (int j = 0; j <= columns_; ++j) {
        knots.push_back(2.0 * kPi * j / columns_);
    }
    model.depth = diameter / 2.0 / layers_;
    // Third derivatives of a disc with many columns weigh so much that the border would yield.
    constexpr double kShare = 1e-4;
    model.energy = kShare * energy();
    model.fold = [ring = *this](const Eigen::Matrix3Xd& points) {
        return find_fold(ring.spline(points));
    };
    model.row = [ring = *this](int, double y) { return ring.row_at(y); };
    return model;
}

SplineSurface Ring::spline(const Eigen::Matrix3Xd& points) const {
    SplineSurface spline;
    spline.degree_u = spline.degree_v = degree();
    spline.knots_u = knots_x_;
    spline.knots_v = knots_y_;
    const int count_v = columns_ + degree();
    spline.poles = Eigen::Matrix3Xd::Zero(3, rows() * count_v);
    for (int j = 0; j < count_v; ++j) {
        for (int i = 0; i < rows(); ++i) {
            BorderRow row;
            add_pole(i, j, VectorXd::Ones(1), row);
            for (std::size_t k = 0; k < row.points.size(); ++k) {
                spline.poles.col(spline.index(i, j)) +=
                    row.weights(0, static_cast<Eigen::Index>(k)) * points.col(row.points[k]);
            }
        }
    }
    return restricted(spline, 0.0, layers_, 0.0, 2.0 * kPi);
}

}  // namespace suture::manifold
