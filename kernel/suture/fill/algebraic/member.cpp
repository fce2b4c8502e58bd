#include "suture/fill/algebraic/member.h"

#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/least_distance.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace suture::algebraic {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Member::Member(const Space& space, const std::vector<GuideSample>& guide,
               const GuideWeights& weights)
    : space_(space) {
    const int block = monomial_count(space.degree);
    const Index cells = space.basis.rows() / block;
    // Normal equations cell by cell; they are as well conditioned as the orthonormal basis.
    std::vector<MatrixXd> H(static_cast<std::size_t>(cells), MatrixXd::Zero(block, block));
    std::vector<VectorXd> r(static_cast<std::size_t>(cells), VectorXd::Zero(block));
    // |Hess|^2 has every mixed derivative twice.
    Eigen::Matrix<double, 6, 1> bending;
    bending << 1.0, 1.0, 1.0, 2.0, 2.0, 2.0;
    bending *= weights.bending;
    for (const GuideSample& sample : guide) {
        const auto cell = static_cast<std::size_t>(sample.cell);
        const MonomialJets jets = monomial_jets(space.degree, sample.point);
        H[cell] += jets.value.transpose() * jets.value +
                   weights.normals * jets.first.transpose() * jets.first +
                   jets.second.transpose() * bending.asDiagonal() * jets.second;
        r[cell] += weights.normals * jets.first.transpose() * sample.normal;
    }
    const Index n = space.basis.cols();
    MatrixXd normal = MatrixXd::Zero(n, n);
    VectorXd right = VectorXd::Zero(n);
    for (Index c = 0; c < cells; ++c) {
        const MatrixXd B = space.basis.middleRows(c * block, block);
        normal += B.transpose() * H[static_cast<std::size_t>(c)] * B;
        right += B.transpose() * r[static_cast<std::size_t>(c)];
    }
    if (space.misses.size() > 0) {
        normal.diagonal() +=
            static_cast<double>(guide.size()) * (space.misses / weights.miss).cwiseAbs2();
    }
    const Eigen::LLT<MatrixXd> cholesky(normal);
    factor_ = cholesky.matrixL();
    best_ = cholesky.solve(right);
}

std::optional<VectorXd> Member::best_under(const std::vector<SheetCondition>& conditions,
                                           double sign, double margin,
                                           const Progress& progress) const {
    const int d = space_.degree;
    const int layer = layer_size(d);
    const int block = monomial_count(d);
    const Index each = static_cast<Index>(d) * layer;
    MatrixXd K(each * static_cast<Index>(conditions.size()), space_.basis.cols());
    Index row = 0;
    for (const SheetCondition& condition : conditions) {
        const MatrixXd map =
            bernstein_map(condition.frustum, d) *
            space_.basis.middleRows(static_cast<Index>(condition.cell) * block, block);
        for (int m = 0; m <= d; ++m) {
            if (m != condition.split) {
                const double side = m < condition.split ? -sign : sign;
                K.middleRows(row, layer) =
                    side * map.middleRows(static_cast<Index>(m) * layer, layer);
                row += layer;
            }
        }
    }
    const VectorXd missing = VectorXd::Constant(K.rows(), margin) - K * best_;
    if (missing.maxCoeff() <= 0.0) {
        return best_;
    }
    // x = best + L^-T y makes the objective |y|^2.
    const auto L = factor_.triangularView<Eigen::Lower>();
    const MatrixXd G = L.solve(K.transpose()).transpose();
    const auto y = least_distance(G, missing, progress);
    if (!y) {
        return std::nullopt;
    }
    return VectorXd(best_ + L.transpose().solve(*y));
}

}  // namespace suture::algebraic
