#include "suture/fill/concentric/complete_cubic.h"

#include "suture/spline/knots.h"

#include <Eigen/LU>

namespace suture::concentric {
namespace {

constexpr int kCubic = 3;

}  // namespace

CompleteCubic::CompleteCubic(int spans) : spans_(spans), knots_(kCubic + 1, 0.0) {
    for (int k = 1; k < spans; ++k) {
        knots_.push_back(static_cast<double>(k) / spans);
    }
    knots_.insert(knots_.end(), kCubic + 1, 1.0);
    Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(count(), count());
    const auto add = [&](int row, double t, int order) {
        const int span = find_span(knots_, kCubic, t);
        conditions.row(row).segment(span - kCubic, kCubic + 1) =
            basis_derivatives(knots_, kCubic, span, t, order).row(order);
    };
    add(0, 0.0, 0);
    add(1, 0.0, 1);
    for (int k = 1; k < spans; ++k) {
        add(k + 1, static_cast<double>(k) / spans, 0);
    }
    add(count() - 2, 1.0, 1);
    add(count() - 1, 1.0, 0);
    to_poles_ = conditions.inverse();
}

double CompleteCubic::greville(int pole) const {
    const auto k = static_cast<std::size_t>(pole);
    return (knots_[k + 1] + knots_[k + 2] + knots_[k + 3]) / kCubic;
}

Eigen::MatrixXd CompleteCubic::poles(const Eigen::MatrixXd& data) const {
    Eigen::MatrixXd poles = data * to_poles_.transpose();
    poles.col(0) = data.col(0);
    poles.col(count() - 1) = data.col(count() - 1);
    return poles;
}

SplineCurve CompleteCubic::spline(const Eigen::MatrixXd& data) const {
    return {kCubic, knots_, poles(data)};
}

}  // namespace suture::concentric
