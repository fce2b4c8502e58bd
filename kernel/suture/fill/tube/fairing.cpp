#include "suture/fill/tube/fairing.h"

#include "suture/base/contract.h"
#include "suture/fill/tube/curvature.h"
#include "suture/fill/tube/unknowns.h"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace suture::tube {
namespace {

using Sparse = RealSparse;

/// The same form for x, y and z of each point.
Sparse for_all_coordinates(const Sparse& matrix) {
    std::vector<Eigen::Triplet<Real>> entries;
    entries.reserve(3 * static_cast<std::size_t>(matrix.nonZeros()));
    for (int j = 0; j < matrix.outerSize(); ++j) {
        for (Sparse::InnerIterator it(matrix, j); it; ++it) {
            for (int c = 0; c < 3; ++c) {
                entries.emplace_back(3 * static_cast<int>(it.row()) + c,
                                     3 * static_cast<int>(it.col()) + c, it.value());
            }
        }
    }
    Sparse result(3 * matrix.rows(), 3 * matrix.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// The functional's stiffness against moving the pole while all else follows, as a Schur
/// complement; the mean over the three directions.
double pole_stiffness(const Sparse& hessian, int pole) {
    const Sparse others = hessian.topLeftCorner(pole, pole);
    const RealMatrix coupling = hessian.topRightCorner(pole, 3);
    RealMatrix schur = Sparse(hessian.bottomRightCorner(3, 3));
    if (pole > 0) {
        const Eigen::SimplicialLDLT<Sparse> factor(others);
        SUTURE_EXPECTS(factor.info() == Eigen::Success);
        schur -= coupling.transpose() * factor.solve(coupling);
    }
    return static_cast<double>(schur.trace() / 3.0L);
}

}  // namespace

Result<Fairing> close(const Net& net, const FairingTask& task) {
    const Unknowns unknowns(net, task);
    SUTURE_EXPECTS(task.chart || task.functional != Functional::Plate);
    const Sparse matrix = task.functional == Functional::Plate
                              ? plate_matrix(net, *task.chart)
                              : energy_matrix(net, task.functional);
    const Sparse all = for_all_coordinates(matrix);
    const Sparse map = unknowns.map.cast<Real>();
    Quadratic objective;
    objective.hessian = Sparse(map.transpose()) * all * map;
    objective.gradient = map.transpose() * (all * unknowns.fixed.cast<Real>());
    if (task.moving) {
        double weight = task.moving->weight;
        if (task.moving->relative) {
            weight *= pole_stiffness(objective.hessian, unknowns.pole);
        }
        for (int c = 0; c < 3; ++c) {
            objective.hessian.coeffRef(unknowns.pole + c, unknowns.pole + c) += weight;
            objective.gradient[unknowns.pole + c] -= weight * task.closing.pole[c];
        }
    }
    RealVector x(unknowns.count());
    if (unknowns.count() > 0) {
        const Eigen::SimplicialLDLT<Sparse> factor(objective.hessian);
        if (factor.info() == Eigen::Success) {
            x = factor.solve(-objective.gradient);
        }
        if (factor.info() != Eigen::Success || !x.allFinite()) {
            return fail(ErrorCode::Refused,
                        "the rays from the closing point to the border turn back: no fairest "
                        "surface over them is found");
        }
    }
    Fairing result{net, {}, task.closing.pole, 0.0, 0, 0.0};
    if (!task.curvatures.empty()) {
        const auto bent = bend(net, task, unknowns, objective, x);
        if (!bent) {
            return tl::unexpected(bent.error());
        }
        x = bent->x;
        result.steps = bent->steps;
        result.defect = bent->defect;
    }
    result.net.points = unknowns.points(x.cast<double>());
    if (task.moving) {
        result.pole = x.tail<3>().cast<double>();
    }
    // Row 0 is one point to the last bit, so that the pole is a point in every file.
    for (int j = 0; j < net.columns(); ++j) {
        result.net.point(0, j) = result.pole;
    }
    result.magnitudes.resize(net.columns());
    for (int j = 0; j < net.columns(); ++j) {
        result.magnitudes[j] =
            end_tangent(result.net, j).dot(task.closing.directions[static_cast<std::size_t>(j)]);
    }
    result.value = energy(result.net, matrix);
    return result;
}

}  // namespace suture::tube
