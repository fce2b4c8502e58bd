#include "suture/fill/concentric/radial.h"

#include "suture/spline/knots.h"

#include <Eigen/LU>

#include <numeric>
#include <utility>

namespace suture::concentric {

Radial::Radial(std::vector<double> breaks) : breaks_(std::move(breaks)), knots_(kDegree, 0.0) {
    knots_.insert(knots_.end(), breaks_.begin(), breaks_.end());
    knots_.insert(knots_.end(), kDegree, 1.0);
    const int n = static_cast<int>(knots_.size()) - kDegree - 1;
    // Greville's abscissae but for the two next to either end, in whose place the ends' slopes and
    // values stand: so each basis function has a condition of its own (Schoenberg, Whitney).
    for (int i = 2; i < n - 2; ++i) {
        const auto first = knots_.begin() + i + 1;
        sites_.push_back(std::accumulate(first, first + kDegree, 0.0) / kDegree);
    }
    Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(n, n);
    const auto add = [&](int row, double t, int order) {
        const int span = find_span(knots_, kDegree, t);
        conditions.row(row).segment(span - kDegree, kDegree + 1) =
            basis_derivatives(knots_, kDegree, span, t, order).row(order);
    };
    add(0, 0.0, 0);
    add(1, 0.0, 1);
    for (int i = 2; i < n - 2; ++i) {
        add(i, sites_[static_cast<std::size_t>(i - 2)], 0);
    }
    add(n - 2, 1.0, 1);
    add(n - 1, 1.0, 0);
    to_poles_ = conditions.inverse();
}

Eigen::MatrixXd Radial::poles(const Eigen::MatrixXd& data) const {
    Eigen::MatrixXd poles = data * to_poles_.transpose();
    poles.col(0) = data.col(0);
    poles.col(count() - 1) = data.col(count() - 1);
    return poles;
}

Eigen::MatrixXd Radial::evaluate(const Eigen::MatrixXd& poles, double t) const {
    const int span = find_span(knots_, kDegree, t);
    return poles.middleCols(span - kDegree, kDegree + 1) *
           basis_derivatives(knots_, kDegree, span, t, 1).transpose();
}

}  // namespace suture::concentric
