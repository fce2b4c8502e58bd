#include "suture/fill/concentric/height.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr int kQuadratic = 6;

double phi(const Vector2d& d) {
    const double r = d.norm();
    return std::pow(r, 5);
}
Vector2d gradient_of_phi(const Vector2d& d) {
    const double r = d.norm();
    return 5.0 * r * r * r * d;
}
Matrix2d hessian_of_phi(const Vector2d& d) {
    const double r = d.norm();
    return 5.0 * r * (r * r * Matrix2d::Identity() + 3.0 * d * d.transpose());
}

/// 1, x, y, x^2, x y, y^2 and their gradients.
VectorXd quadratic(const Vector2d& x) {
    VectorXd q(kQuadratic);
    q << 1.0, x.x(), x.y(), x.x() * x.x(), x.x() * x.y(), x.y() * x.y();
    return q;
}
MatrixXd gradient_of_quadratic(const Vector2d& x) {
    MatrixXd g(2, kQuadratic);
    g << 0.0, 1.0, 0.0, 2.0 * x.x(), x.y(), 0.0,  //
        0.0, 0.0, 1.0, 0.0, x.x(), 2.0 * x.y();
    return g;
}

}  // namespace

HeightField::HeightField(const std::vector<HeightSample>& samples) : samples_(samples) {
    Vector2d low = samples.front().at;
    Vector2d high = low;
    for (const HeightSample& sample : samples) {
        low = low.cwiseMin(sample.at);
        high = high.cwiseMax(sample.at);
    }
    centre_ = 0.5 * (low + high);
    scale_ = std::max((high - low).maxCoeff(), 1e-300);
    const auto n = static_cast<int>(samples.size());
    const int size = 2 * n + kQuadratic;
    MatrixXd A = MatrixXd::Zero(size, size);
    VectorXd b = VectorXd::Zero(size);
    for (HeightSample& sample : samples_) {
        sample.at = local(sample.at);
        sample.height /= scale_;
    }
    for (int i = 0; i < n; ++i) {
        const HeightSample& to = samples_[static_cast<std::size_t>(i)];
        for (int j = 0; j < n; ++j) {
            const HeightSample& from = samples_[static_cast<std::size_t>(j)];
            const Vector2d d = to.at - from.at;
            A(i, j) = phi(d);
            A(i, n + j) = -from.direction.dot(gradient_of_phi(d));
            A(n + i, j) = to.direction.dot(gradient_of_phi(d));
            A(n + i, n + j) = -to.direction.dot(hessian_of_phi(d) * from.direction);
        }
        A.row(i).tail(kQuadratic) = quadratic(to.at).transpose();
        A.row(n + i).tail(kQuadratic) = to.direction.transpose() * gradient_of_quadratic(to.at);
        A.col(i).tail(kQuadratic) = quadratic(to.at);
        A.col(n + i).tail(kQuadratic) = gradient_of_quadratic(to.at).transpose() * to.direction;
        b[i] = to.height;
        b[n + i] = to.slope;
        if (to.direction.isZero()) {
            A(n + i, n + i) = 1.0;  // no slope is asked for there
            b[n + i] = 0.0;
        }
    }
    weights_ = A.colPivHouseholderQr().solve(b);
}

double HeightField::height(const Vector2d& x) const {
    const auto n = static_cast<int>(samples_.size());
    const Vector2d at = local(x);
    double sum = quadratic(at).dot(weights_.tail(kQuadratic));
    for (int j = 0; j < n; ++j) {
        const HeightSample& from = samples_[static_cast<std::size_t>(j)];
        sum += weights_[j] * phi(at - from.at) -
               weights_[n + j] * from.direction.dot(gradient_of_phi(at - from.at));
    }
    return sum * scale_;
}

Vector2d HeightField::gradient(const Vector2d& x) const {
    const auto n = static_cast<int>(samples_.size());
    const Vector2d at = local(x);
    Vector2d sum = gradient_of_quadratic(at) * weights_.tail(kQuadratic);
    for (int j = 0; j < n; ++j) {
        const HeightSample& from = samples_[static_cast<std::size_t>(j)];
        sum += weights_[j] * gradient_of_phi(at - from.at) -
               weights_[n + j] * (hessian_of_phi(at - from.at) * from.direction);
    }
    return sum;
}

}  // namespace suture::concentric
