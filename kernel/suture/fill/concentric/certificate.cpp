#include "suture/fill/concentric/certificate.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::Matrix2Xd;
using Eigen::VectorXd;

/// Halvings of an interval before what is left undecided counts as folded.
constexpr int kHalvings = 12;

/// Rounding, as a share of the largest product that occurs.
constexpr double kRounding = 1e-13;

/// An overlap shorter than this share of the period is none.
constexpr double kNothing = 1e-14;

double binomial(int n, int k) {
    double value = 1.0;
    for (int i = 1; i <= k; ++i) {
        value *= static_cast<double>(n - k + i) / i;
    }
    return value;
}

/// Bernstein coefficients of the cross product of two planar polynomials.
VectorXd cross(const Matrix2Xd& a, const Matrix2Xd& b) {
    const auto m = static_cast<int>(a.cols()) - 1;
    const auto n = static_cast<int>(b.cols()) - 1;
    VectorXd product = VectorXd::Zero(m + n + 1);
    for (int i = 0; i <= m; ++i) {
        for (int k = 0; k <= n; ++k) {
            const double value = a(0, i) * b(1, k) - a(1, i) * b(0, k);
            product[i + k] += binomial(m, i) * binomial(n, k) / binomial(m + n, i + k) * value;
        }
    }
    return product;
}

Matrix2Xd derivative(const BezierPiece& piece) {
    const int p = piece.degree();
    return p / (piece.to - piece.from) * (piece.poles.rightCols(p) - piece.poles.leftCols(p));
}

Matrix2Xd elevated(const Matrix2Xd& poles, int degree) {
    Matrix2Xd result = poles;
    while (result.cols() < degree + 1) {
        const auto p = static_cast<int>(result.cols()) - 1;
        Matrix2Xd next(2, p + 2);
        next.col(0) = result.col(0);
        next.col(p + 1) = result.col(p);
        for (int i = 1; i <= p; ++i) {
            const double f = static_cast<double>(i) / (p + 1);
            next.col(i) = f * result.col(i - 1) + (1.0 - f) * result.col(i);
        }
        result = next;
    }
    return result;
}

/// The halves of a polynomial by its Bernstein coefficients.
std::pair<VectorXd, VectorXd> halves(VectorXd b) {
    const auto n = static_cast<int>(b.size()) - 1;
    VectorXd left(n + 1), right(n + 1);
    for (int r = 0; r <= n; ++r) {
        left[r] = b[0];
        right[n - r] = b[n - r];
        for (int i = 0; i + r < n; ++i) {
            b[i] = 0.5 * (b[i] + b[i + 1]);
        }
    }
    return {left, right};
}

bool nonnegative(const VectorXd& b, double slack, int halvings) {
    if (b.minCoeff() >= -slack) {
        return true;
    }
    if (b[0] < -slack || b[b.size() - 1] < -slack || halvings == 0) {
        return false;
    }
    const auto [left, right] = halves(b);
    return nonnegative(left, slack, halvings - 1) && nonnegative(right, slack, halvings - 1);
}

}  // namespace

JacobianFactors jacobian_factors(const BezierPiece& gamma, const BezierPiece& c) {
    const int degree = std::max(gamma.degree(), c.degree());
    const Matrix2Xd spoke = elevated(c.poles, degree) - elevated(gamma.poles, degree);
    return {cross(derivative(gamma), spoke), cross(derivative(c), spoke)};
}

Certificate certify(const BezierPiece& gamma, const BezierPiece& c, double slack) {
    const JacobianFactors factors = jacobian_factors(gamma, c);
    const bool positive = nonnegative(factors.boundary, slack, kHalvings) &&
                          nonnegative(factors.axis, slack, kHalvings);
    return positive ? Certificate::Positive : Certificate::Folded;
}

BoundaryPieces::BoundaryPieces(const ClosedSpline& curve)
    : pieces_(bezier_pieces(clamped(curve))), period_(curve.period()) {
    const double size =
        (curve.poles.rowwise().maxCoeff() - curve.poles.rowwise().minCoeff()).norm();
    slack_ = kRounding * size * size / period_;
}

std::vector<BezierPiece> BoundaryPieces::between(double from, double to) const {
    const double begin = pieces_.front().from;
    const double turns = period_ * std::floor((from - begin) / period_);
    const double nothing = kNothing * period_;
    std::vector<BezierPiece> parts;
    const auto n = pieces_.size();
    // The piece that holds `from`, on its own turn.
    const auto after =
        std::upper_bound(pieces_.begin(), pieces_.end(), from - turns,
                         [](double value, const BezierPiece& piece) { return value < piece.from; });
    auto k = static_cast<std::size_t>(after - pieces_.begin()) - 1;
    for (double shift = turns;; ++k) {
        if (k == n) {
            k = 0;
            shift += period_;
        }
        const BezierPiece& piece = pieces_[k];
        const double a = std::max(from - shift, piece.from);
        const double b = std::min(to - shift, piece.to);
        if (b - a > nothing) {
            parts.push_back(part_of(piece, a, b));
            parts.back().from += shift;
            parts.back().to += shift;
        }
        if (to - shift <= piece.to + nothing) {
            return parts;
        }
    }
}

Eigen::Vector2d BoundaryPieces::at(double s) const {
    const double begin = pieces_.front().from;
    const double on_turn = s - period_ * std::floor((s - begin) / period_);
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), on_turn,
                         [](double value, const BezierPiece& piece) { return value < piece.from; });
    return part_of(*(after - 1), on_turn, on_turn).poles.col(0);
}

Certificate certify(const BoundaryPieces& boundary, const ConcentricCurve& curve,
                    const Course& course) {
    const Eigen::Vector2d a = curve.nodes[static_cast<std::size_t>(course.start)];
    const Eigen::Vector2d b = curve.nodes[static_cast<std::size_t>(course.end)];
    BezierPiece whole{course.from, course.to, Eigen::MatrixXd(2, 2)};
    whole.poles << a, b;
    for (const BezierPiece& gamma : boundary.between(course.from, course.to)) {
        const BezierPiece c = part_of(whole, gamma.from, gamma.to);
        if (certify(gamma, c, boundary.slack()) == Certificate::Folded) {
            return Certificate::Folded;
        }
    }
    return Certificate::Positive;
}

std::vector<int> folded_courses(const BoundaryPieces& boundary, const ConcentricCurve& curve) {
    std::vector<int> folded;
    const std::vector<Course> all = courses(curve);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (certify(boundary, curve, all[k]) == Certificate::Folded) {
            folded.push_back(static_cast<int>(k));
        }
    }
    return folded;
}

}  // namespace suture::concentric
