#include "suture/fill/algebraic/jet_space.h"

#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/system.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>

namespace suture::algebraic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;

/// The columns of A's null space, orthonormal.
MatrixXd null_space(const MatrixXd& A) {
    constexpr double kExact = 1e-11;
    Eigen::ColPivHouseholderQR<MatrixXd> qr(A.transpose());
    qr.setThreshold(kExact);
    const Index dimension = A.cols() - qr.rank();
    MatrixXd null = MatrixXd::Zero(A.cols(), dimension);
    null.bottomRows(dimension).setIdentity();
    null.applyOnTheLeft(qr.householderQ());
    return null;
}

/// Orthonormal columns that span those of A.
MatrixXd orthonormal(const MatrixXd& A) {
    const Eigen::HouseholderQR<MatrixXd> qr(A);
    MatrixXd Q = MatrixXd::Identity(A.rows(), A.cols());
    Q.applyOnTheLeft(qr.householderQ());
    return Q;
}

/// m pi^(k+1) for all monomials m that keep the degree, one column each.
MatrixXd multiples(const Polynomial<double>& plane, int k, int degree) {
    const Polynomial<double> by = power(plane, k + 1);
    const auto factors = monomials(degree - by.degree);
    MatrixXd columns = MatrixXd::Zero(monomial_count(degree), static_cast<Index>(factors.size()));
    for (std::size_t n = 0; n < factors.size(); ++n) {
        auto monomial = Polynomial<double>::zero(factors[n].degree());
        monomial[factors[n]] = 1.0;
        const Polynomial<double> product = monomial * by;
        columns.col(static_cast<Index>(n)).head(static_cast<Index>(product.coefficients.size())) =
            coefficients(product);
    }
    return columns;
}

/// All cells that join: (1), with (2) around each closed cycle, which by Theorem 2.4 is all that
/// an umbrella needs.
MatrixXd joined_cells(const Partition& partition, const std::vector<Polynomial<double>>& planes,
                      int interface_k, int degree) {
    const Index block = monomial_count(degree);
    const Index alphas = monomial_count(degree - interface_k - 1);
    const Index columns = block + alphas * static_cast<Index>(planes.size());
    const Paths paths = paths_of(partition);
    MatrixXd image = MatrixXd::Zero(block * partition.cells, columns);
    std::vector<MatrixXd> steps;
    steps.reserve(planes.size());
    for (const Polynomial<double>& plane : planes) {
        steps.push_back(multiples(plane, interface_k, degree));
    }
    for (Index cell = 0; cell < partition.cells; ++cell) {
        image.block(cell * block, 0, block, block).setIdentity();
        for (const Paths::Step& step : paths.to[static_cast<std::size_t>(cell)]) {
            image.block(cell * block, block + alphas * step.interface, block, alphas) +=
                step.sign * steps[static_cast<std::size_t>(step.interface)];
        }
    }
    MatrixXd conditions = MatrixXd::Zero(block * static_cast<Index>(paths.closing.size()), columns);
    for (std::size_t c = 0; c < paths.closing.size(); ++c) {
        const int j = paths.closing[c];
        const Interface& closing = partition.interfaces[static_cast<std::size_t>(j)];
        auto rows = conditions.middleRows(static_cast<Index>(c) * block, block);
        rows =
            image.middleRows(closing.a * block, block) - image.middleRows(closing.b * block, block);
        rows.middleCols(block + alphas * j, alphas) += steps[static_cast<std::size_t>(j)];
    }
    return orthonormal(image * null_space(conditions));
}

/// inward^T Hess inward of all monomials.
RowVectorXd second_along(const MonomialJets& jets, const Vector3d& a) {
    Eigen::Matrix<double, 1, 6> weights;
    weights << a.x() * a.x(), a.y() * a.y(), a.z() * a.z(), 2.0 * a.x() * a.y(),
        2.0 * a.x() * a.z(), 2.0 * a.y() * a.z();
    return weights * jets.second;
}

/// What has to vanish at a point of a side, one row each: g = alpha f + beta h^(k+1), Theorem 2.2,
/// seen from the neighbour's derivatives up to order k, for any transversal h; what Definition 2.1
/// calls rescaling continuity.
MatrixXd conditions_at(const SideJet& at, int k, int degree) {
    const MonomialJets jets = monomial_jets(degree, at.point);
    MatrixXd rows(k + 1, monomial_count(degree));
    rows.row(0) = jets.value;
    if (k >= 1) {
        rows.row(1) = at.inward.transpose() * jets.first;
    }
    if (k >= 2) {
        rows.row(2) = second_along(jets, at.inward) + at.inward.dot(at.curvature * at.inward) *
                                                          (at.normal.transpose() * jets.first);
    }
    return rows;
}

}  // namespace

JetSpace::JetSpace(const Partition& partition, const std::vector<SideJets>& sides,
                   const std::vector<Polynomial<double>>& planes, int interface_k, int degree)
    : degree_(degree), joined_(joined_cells(partition, planes, interface_k, degree)) {
    const Index block = monomial_count(degree);
    Index rows = 0;
    for (const SideJets& side : sides) {
        rows += static_cast<Index>(side.jets.size()) * (side.k + 1);
    }
    MatrixXd at_sides(rows, joined_.cols());
    Index row = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        for (const SideJet& jet : sides[i].jets) {
            at_sides.middleRows(row, sides[i].k + 1) =
                conditions_at(jet, sides[i].k, degree) *
                joined_.middleRows(static_cast<Index>(i) * block, block);
            row += sides[i].k + 1;
        }
    }
    const Eigen::BDCSVD<MatrixXd> svd(at_sides / std::sqrt(static_cast<double>(rows)),
                                      Eigen::ComputeThinV);
    directions_ = svd.matrixV();
    misses_ = svd.singularValues();
    rows_ = static_cast<int>(rows);
}

Space JetSpace::within(double most) const {
    Space space;
    space.degree = degree_;
    space.dimension = static_cast<int>((misses_.array() <= most).count());
    space.rank = static_cast<int>(misses_.size()) - space.dimension;
    space.basis = joined_ * directions_.rightCols(space.dimension);
    space.misses = misses_.tail(space.dimension);
    return space;
}

}  // namespace suture::algebraic
