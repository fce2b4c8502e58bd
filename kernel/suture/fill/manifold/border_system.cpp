#include "suture/fill/manifold/border_system.h"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the energy against the mean square of a border residual.
constexpr double kEnergyWeight = 1e-9;

}  // namespace

void BorderSystem::add(const BorderRow& at, const MatrixXd& gradient, double value, double weight,
                       Kind kind) {
    const double root = std::sqrt(weight);
    const auto row = static_cast<int>(values_.size());
    for (std::size_t a = 0; a < at.points.size(); ++a) {
        for (int c = 0; c < 3; ++c) {
            const double x = root * gradient(c, static_cast<Eigen::Index>(a));
            if (x != 0.0) {
                entries_.emplace_back(row, 3 * at.points[a] + c, x);
            }
        }
    }
    values_.push_back(root * value);
    demanded_.push_back(kind == Kind::Demand ? 1.0 : 0.0);
}

void BorderSystem::add_point(const BorderRow& at, const Eigen::Vector3d& point, double weight,
                             Kind kind) {
    for (int c = 0; c < 3; ++c) {
        add(at, Eigen::Vector3d::Unit(c) * at.weights.row(0), point[c], weight, kind);
    }
}

Result<Matrix3Xd> BorderSystem::solve(const Eigen::SparseMatrix<double>& energy, int steps) const {
    const auto rows = static_cast<Eigen::Index>(values_.size());
    Eigen::SparseMatrix<double> a(rows, unknowns_);
    a.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SparseMatrix<double> transposed = a.transpose();
    const Eigen::SparseMatrix<double> matrix =
        Eigen::SparseMatrix<double>(transposed * a) + in_space(energy);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) {
        return fail(ErrorCode::Refused, "the least squares of the border have no unique solution");
    }
    const VectorXd wanted = VectorXd::Map(values_.data(), rows);
    const VectorXd demanded = VectorXd::Map(demanded_.data(), rows);
    VectorXd raised = wanted;
    VectorXd solution;
    for (int step = 0; step < steps; ++step) {
        solution = solver.solve(transposed * raised);
        raised += demanded.cwiseProduct(wanted - a * solution);
    }
    return Matrix3Xd(solution.reshaped(3, solution.size() / 3));
}

Eigen::SparseMatrix<double> BorderSystem::in_space(
    const Eigen::SparseMatrix<double>& energy) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < energy.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(energy, column); it; ++it) {
            for (int c = 0; c < 3; ++c) {
                entries.emplace_back(3 * static_cast<int>(it.row()) + c,
                                     3 * static_cast<int>(it.col()) + c,
                                     kEnergyWeight * it.value());
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace suture::manifold
