#include "suture/fill/tube/curvature.h"

#include "suture/base/contract.h"

#include <Eigen/SparseLU>

#include <cmath>

namespace suture::tube {
namespace {

using Eigen::Vector3d;
using RealVector3 = Eigen::Matrix<Real, 3, 1>;
using Sparse = RealSparse;
using Entries = std::vector<Eigen::Triplet<Real>>;

constexpr int kMostSteps = 60;
/// Conditions are met up to rounding: relative to the largest |D|^2 kappa or <r_uu, N>.
constexpr double kAccuracy = 1e-13;
/// Newton's step is halved at most so often.
constexpr int kMostHalvings = 20;

/// One condition: kappa |T p|^2 - l.p = 0, with T p = D and l.p = <r_uu, N> linear in the points.
struct Condition {
    Real kappa = 0.0;
    Sparse tangent;  ///< 3 x unknowns
    RealVector3 tangent_fixed;
    Eigen::SparseVector<Real> bend;  ///< unknowns
    Real bend_fixed = 0.0;

    // NOLINTNEXTLINE(readability-identifier-naming): the paper's letter
    [[nodiscard]] RealVector3 D(const RealVector& x) const { return tangent * x + tangent_fixed; }
    [[nodiscard]] Real bending(const RealVector& x) const { return bend.dot(x) + bend_fixed; }
    [[nodiscard]] Real value(const RealVector& x) const {
        return kappa * D(x).squaredNorm() - bending(x);
    }
};

/// <r_uu, N> of the clamped cubic at its end is a combination of rows 0, 1 and 2.
Vector3d second_derivative(const Net& net) {
    const double h0 = net.first_step();
    const double h01 = net.knots_u[kDegreeU + 2] - net.knots_u[kDegreeU];
    const double outer = 6.0 / (h0 * h01);
    const double inner = -6.0 / (h0 * h0) - outer;
    return {6.0 / (h0 * h0), inner, outer};
}

std::vector<Condition> conditions_of(const Net& net, const FairingTask& task,
                                     const Unknowns& unknowns) {
    const Vector3d second = second_derivative(net);
    const Eigen::SparseMatrix<Real, Eigen::RowMajor> map = unknowns.map.cast<Real>();
    std::vector<Condition> conditions;
    for (int k = 0; k < net.columns(); ++k) {
        const double g = net.ring.interval(k);
        if (g == 0.0) {
            continue;
        }
        const Ring::Local local = net.ring.on(k, net.ring.start(k) + 0.5 * g, 0);
        Condition condition;
        const std::size_t which = task.curvatures.size() == 1 ? 0 : conditions.size();
        SUTURE_EXPECTS(which < task.curvatures.size());
        condition.kappa = task.curvatures[which];
        condition.tangent.resize(3, unknowns.count());
        condition.tangent_fixed.setZero();
        condition.bend.resize(unknowns.count());
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                const int point = 3 * net.index(i, local.first + j);
                const Real share = local.basis(0, j);
                const Real slope = i == 2 ? 0.0 : (i == 0 ? -3.0 : 3.0) / net.first_step();
                for (int c = 0; c < 3; ++c) {
                    const Eigen::SparseVector<Real> row = map.row(point + c).transpose();
                    for (Eigen::SparseVector<Real>::InnerIterator it(row); it; ++it) {
                        condition.tangent.coeffRef(c, it.index()) += share * slope * it.value();
                    }
                    condition.tangent_fixed[c] += share * slope * unknowns.fixed[point + c];
                    const Real normal = share * second[i] * task.closing.normal[c];
                    condition.bend += normal * row;
                    condition.bend_fixed += normal * unknowns.fixed[point + c];
                }
            }
        }
        conditions.push_back(std::move(condition));
    }
    return conditions;
}

/// The conditions' values, and how far they are from being met.
struct State {
    RealVector values;
    Real defect = 0.0;    ///< in curvature
    Real relative = 0.0;  ///< to the conditions' terms at the start
};

/// The size of the conditions' terms.
Real size_at(const std::vector<Condition>& conditions, const RealVector& x) {
    Real size = 0.0;
    for (const Condition& condition : conditions) {
        size = std::max({size, std::abs(condition.bending(x)),
                         std::abs(condition.kappa) * condition.D(x).squaredNorm()});
    }
    return size;
}

State state_at(const std::vector<Condition>& conditions, const RealVector& x, Real size) {
    State state;
    state.values.resize(static_cast<Eigen::Index>(conditions.size()));
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const Real value = conditions[k].value(x);
        state.values[static_cast<Eigen::Index>(k)] = value;
        state.defect = std::max(state.defect, std::abs(value) / conditions[k].D(x).squaredNorm());
    }
    state.relative = size > 0.0 ? state.values.cwiseAbs().maxCoeff() / size : 0.0;
    return state;
}

/// The matrix of Newton's method for the Lagrangian, and the gradient of each condition.
struct Kkt {
    Sparse matrix;
    Sparse gradients;  ///< conditions x unknowns
};

Kkt kkt_at(const std::vector<Condition>& conditions, const Quadratic& objective,
           const RealVector& x, const RealVector& multipliers) {
    const int n = static_cast<int>(x.size());
    const int m = static_cast<int>(conditions.size());
    Entries upper;
    Entries gradients;
    for (int j = 0; j < objective.hessian.outerSize(); ++j) {
        for (Sparse::InnerIterator it(objective.hessian, j); it; ++it) {
            upper.emplace_back(static_cast<int>(it.row()), static_cast<int>(it.col()), it.value());
        }
    }
    for (int k = 0; k < m; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const Sparse curved = condition.tangent.transpose() * condition.tangent;
        const Real factor = Real(2) * condition.kappa * multipliers[k];
        for (int j = 0; j < curved.outerSize(); ++j) {
            for (Sparse::InnerIterator it(curved, j); it; ++it) {
                upper.emplace_back(static_cast<int>(it.row()), static_cast<int>(it.col()),
                                   factor * it.value());
            }
        }
        const RealVector slope =
            Real(2) * condition.kappa * (condition.tangent.transpose() * condition.D(x)) -
            RealVector(condition.bend);
        for (int i = 0; i < n; ++i) {
            if (slope[i] != 0.0) {
                gradients.emplace_back(k, i, slope[i]);
                upper.emplace_back(n + k, i, slope[i]);
                upper.emplace_back(i, n + k, slope[i]);
            }
        }
    }
    Kkt kkt;
    kkt.gradients.resize(m, n);
    kkt.gradients.setFromTriplets(gradients.begin(), gradients.end());
    kkt.matrix.resize(n + m, n + m);
    kkt.matrix.setFromTriplets(upper.begin(), upper.end());
    return kkt;
}

}  // namespace

Result<Bent> bend(const Net& net, const FairingTask& task, const Unknowns& unknowns,
                  const Quadratic& objective, const RealVector& start) {
    const std::vector<Condition> conditions = conditions_of(net, task, unknowns);
    const auto m = static_cast<Eigen::Index>(conditions.size());
    Bent bent{start, 0, 0.0};
    RealVector multipliers = RealVector::Zero(m);
    const Real size = size_at(conditions, start);
    Real last_step = INFINITY;
    for (; bent.steps < kMostSteps; ++bent.steps) {
        const State state = state_at(conditions, bent.x, size);
        bent.defect = static_cast<double>(state.defect);
        if (state.relative < kAccuracy && last_step < std::sqrt(kAccuracy)) {
            return bent;
        }
        const Kkt kkt = kkt_at(conditions, objective, bent.x, multipliers);
        const RealVector slope = objective.hessian * bent.x + objective.gradient;
        RealVector right(bent.x.size() + m);
        right << -slope, -state.values;
        Eigen::SparseLU<Sparse> factor(kkt.matrix);
        if (factor.info() != Eigen::Success) {
            break;
        }
        const RealVector step = factor.solve(right);
        const RealVector move = step.head(bent.x.size());
        if (!move.allFinite()) {
            break;
        }
        // A step may make the conditions worse, but not much worse.
        const Real most = std::max(Real(2) * state.relative, Real(1));
        Real length = 1.0;
        for (int k = 0; k < kMostHalvings; ++k, length /= 2) {
            if (state_at(conditions, bent.x + length * move, size).relative < most) {
                break;
            }
        }
        bent.x += length * move;
        multipliers += length * (step.tail(m) - multipliers);
        last_step = move.norm() / bent.x.norm();
    }
    return fail(ErrorCode::Refused,
                "the curvatures asked for at the closing point are not reached: off by {:.3g} "
                "after {} steps",
                bent.defect, bent.steps);
}

double pole_curvature(const Net& net, const Vector3d& normal, int interval, double v) {
    const SurfaceJet jet = evaluate(net, 0.0, interval, v);
    return jet.uu.dot(normal) / jet.u.squaredNorm();
}

}  // namespace suture::tube
