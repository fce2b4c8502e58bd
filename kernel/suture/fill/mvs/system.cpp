#include "suture/fill/mvs/system.h"

#include "suture/base/contract.h"
#include "suture/fill/mvs/blas.h"
#include "suture/fill/mvs/polygon.h"
#include "suture/fill/mvs/variation.h"

#include <Eigen/Geometry>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture::mvs {
namespace {

// Gauss points a span and direction. The basis is C4, so that neighbouring spans share most of
// their freedom and few points a span determine it: see docs/methods/mvs.md, "quadrature".
constexpr int kQuadrature = 3;
// Beside a line that freedom is a span's own.
constexpr int kQuadratureBesideLine = 6;
// And there, where the whole span is inside the domain, so that no point is missing.
constexpr int kQuadratureInside = 4;
// The start: how much the speed across the boundary counts against position, and the flat energy.
constexpr double kStartAcross = 1e-3;
constexpr double kStartBending = 1e-6;
constexpr double kStartEnergy = 1e-8;

}  // namespace

System::System(Axis u, Axis v, const std::vector<Eigen::Matrix2Xd>& polygons,
               std::vector<BoundarySample> samples, const std::vector<KnotLine>& lines,
               const Weights& weights)
    : u_(std::move(u)),
      v_(std::move(v)),
      samples_(std::move(samples)),
      weights_(weights),
      lines_(lines),
      flat_(flat({0.0, 0.0, weights.parametrisation, weights.extension}, weights.jump)),
      damping_(flat({0.0, 0.0, 1.0, 0.0}, 0.0)) {
    place_quadrature(polygons);
    place_samples();
}

System::Nodes System::nodes_of(const Axis& axis) {
    Nodes nodes;
    const auto place = [&](int span, int points) {
        const std::size_t first = nodes.at.size();
        const GaussRule& rule = gauss_rule(points);
        const double width = axis.upper(span) - axis.lower(span);
        for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
            nodes.at.push_back(axis.lower(span) + rule.nodes[q] * width);
            nodes.weights.push_back(rule.weights[q] * width);
            nodes.rows.push_back(basis_row(axis, nodes.at.back()));
        }
        return Range{first, nodes.at.size()};
    };
    for (int k = 0; k < axis.spans(); ++k) {
        if (axis.empty(k)) {
            nodes.cut.push_back({});
            nodes.whole.push_back({});
        } else if (axis.beside_line(k)) {
            nodes.cut.push_back(place(k, kQuadratureBesideLine));
            nodes.whole.push_back(place(k, kQuadratureInside));
        } else {
            nodes.cut.push_back(place(k, kQuadrature));
            nodes.whole.push_back(nodes.cut.back());
        }
    }
    return nodes;
}

void System::place_point(Span& span, std::size_t u_row, std::size_t v_row) const {
    span.points.push_back({u_row, v_row, u_nodes_.weights[u_row] * v_nodes_.weights[v_row]});
}

void System::place_in_whole(Span& span) const {
    const Range columns = u_nodes_.whole[static_cast<std::size_t>(span.u)];
    const Range rows = v_nodes_.whole[static_cast<std::size_t>(span.v)];
    span.points.clear();
    for (std::size_t q = rows.first; q < rows.end; ++q) {
        for (std::size_t p = columns.first; p < columns.end; ++p) {
            place_point(span, p, q);
        }
    }
}

void System::place_quadrature(const std::vector<Eigen::Matrix2Xd>& polygons) {
    u_nodes_ = nodes_of(u_);
    v_nodes_ = nodes_of(v_);
    const auto width = static_cast<std::size_t>(u_.spans());
    for (int j = 0; j < v_.spans(); ++j) {
        for (int i = 0; i < u_.spans(); ++i) {
            spans_.push_back({i, j, {}, {}});
        }
    }
    for (std::size_t j = 0; j < v_nodes_.cut.size(); ++j) {
        const Range rows = v_nodes_.cut[j];
        for (std::size_t q = rows.first; q < rows.end; ++q) {
            const std::vector<double> cut = crossings(polygons, v_nodes_.at[q]);
            for (std::size_t i = 0; i < width; ++i) {
                for (std::size_t p = u_nodes_.cut[i].first; p < u_nodes_.cut[i].end; ++p) {
                    const auto before =
                        std::lower_bound(cut.begin(), cut.end(), u_nodes_.at[p]) - cut.begin();
                    if (before % 2 == 1) {
                        place_point(spans_[i + width * j], p, q);
                    }
                }
            }
        }
        for (std::size_t i = 0; i < width; ++i) {
            Span& span = spans_[i + width * j];
            const Range columns = u_nodes_.cut[i];
            if (span.points.size() == columns.count() * rows.count()) {
                place_in_whole(span);
            }
            point_count_ += span.points.size();
        }
    }
}

void System::place_samples() {
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        const BoundarySample& sample = samples_[k];
        const BasisRow u = basis_row(u_, sample.uv.x());
        const BasisRow v = basis_row(v_, sample.uv.y());
        const LocalBasis basis = local_basis(u, v);
        const Eigen::Vector2d& a = sample.across;
        sample_bases_.push_back(
            {local_values(u, v), basis.leftCols<2>() * a,
             basis.middleCols<3>(2) *
                 Eigen::Vector3d(a.x() * a.x(), 2.0 * a.x() * a.y(), a.y() * a.y())});
        spans_[static_cast<std::size_t>(u.first + u_.spans() * v.first)].samples.push_back(k);
    }
}

namespace {

// result += the product of two symmetric bands, given by their upper diagonals, one a column.
void add_product(const Eigen::MatrixXd& in_v, const Eigen::MatrixXd& in_u, double factor,
                 BlockBand& result) {
    const auto nu = static_cast<int>(in_u.rows());
    const auto nv = static_cast<int>(in_v.rows());
    for (int j = 0; j < nv; ++j) {
        for (int dj = 0; dj <= std::min(kDegree, nv - 1 - j); ++dj) {
            const double outer = factor * in_v(j, dj);
            if (outer == 0.0) {
                continue;
            }
            for (int i = 0; i < nu; ++i) {
                for (int di = 0; di <= std::min(kDegree, nu - 1 - i); ++di) {
                    const double value = outer * in_u(i, di);
                    result.column(j)(nu * dj + i + di, i) += value;
                    if (di > 0) {
                        result.column(j)(nu * dj + i, i + di) += value;
                    }
                }
            }
        }
    }
}

// Along a line: integrals of the products of its functions, weighted.
Eigen::MatrixXd weighted_gram(const Axis& axis, const KnotLine& line) {
    const GaussRule& rule = gauss_rule(kOrder);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(axis.count(), kOrder);
    for (int k = 0; k < axis.spans(); ++k) {
        if (axis.empty(k)) {
            continue;
        }
        const double h = axis.upper(k) - axis.lower(k);
        for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
            const double t = axis.lower(k) + h * rule.nodes[q];
            const BasisRow row = basis_row(axis, t);
            const double weight = h * rule.weights[q] * line.weight(t);
            for (int a = 0; a < kOrder; ++a) {
                for (int b = a; b < kOrder; ++b) {
                    gram(k + a, b - a) += weight * row.values(0, a) * row.values(0, b);
                }
            }
        }
    }
    return gram;
}

// Across it: products of the functions' jumps.
Eigen::MatrixXd jump_gram(const Axis& axis, double at) {
    const JumpRow jump = jump_row(axis, at);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(axis.count(), kOrder);
    for (int a = 0; a < kOrder; ++a) {
        for (int b = a; b < kOrder; ++b) {
            gram(jump.first + a, b - a) = jump.values.col(a).dot(jump.values.col(b));
        }
    }
    return gram;
}

}  // namespace

BlockBand System::flat(const std::array<double, 4>& orders, double jump) const {
    const std::vector<Eigen::MatrixXd> gu = gram_matrices(u_);
    const std::vector<Eigen::MatrixXd> gv = gram_matrices(v_);
    // |D^k X|^2 has the binomial coefficients as multiplicities of its components.
    constexpr std::array<std::array<double, 4>, 4> kBinomial = {
        {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
    BlockBand result(v_.count(), u_.count(), kDegree);
    for (std::size_t order = 0; order < 4; ++order) {
        for (std::size_t in_v = 0; in_v <= order; ++in_v) {
            add_product(gv[in_v], gu[order - in_v], orders[order] * kBinomial[order][in_v], result);
        }
    }
    for (const KnotLine& line : lines_) {
        const bool of_u = line.axis == 0;
        const Eigen::MatrixXd across = jump_gram(of_u ? u_ : v_, line.at);
        const Eigen::MatrixXd along = weighted_gram(of_u ? v_ : u_, line);
        add_product(of_u ? along : across, of_u ? across : along, jump, result);
    }
    return result;
}

LocalBasis System::basis_at(const QuadraturePoint& point) const {
    return local_basis(u_nodes_.rows[point.u_row], v_nodes_.rows[point.v_row]);
}

System::Residuals System::residuals(std::size_t sample, const LocalPoles& poles) const {
    const BoundarySample& s = samples_[sample];
    const SampleBasis& b = sample_bases_[sample];
    const Eigen::Vector3d across = poles * b.across;
    Residuals r;
    r.head<3>() = poles * b.value - s.point;
    r[3] = s.normal.dot(across);
    r[4] = s.normal.dot(poles * b.second) - across.dot(s.curvature * across);
    return r;
}

System::Residuals System::residual_weights(std::size_t sample) const {
    const BoundarySample& s = samples_[sample];
    Residuals w;
    w.head<3>().setConstant(s.length);
    w[3] = s.continuity >= Continuity::G1 ? s.length * weights_.angle : 0.0;
    w[4] =
        s.continuity >= Continuity::G2 ? s.length * s.curvature_weight * weights_.curvature : 0.0;
    return w;
}

Net System::start() const {
    BlockBand matrix(v_.count(), 3 * u_.count(), kDegree);
    // A little second-order energy: on a circle whose sides ask for position only, the third-order
    // energy leaves the paraboloid through it free.
    matrix.add_per_component(flat({0.0, 0.0, kStartBending, 1.0}, weights_.jump), kStartEnergy);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.rows());
    for (const Span& span : spans_) {
        if (span.samples.empty()) {
            continue;
        }
        LocalMatrix local = LocalMatrix::Zero();
        LocalVector local_right = LocalVector::Zero();
        for (const std::size_t k : span.samples) {
            const BoundarySample& s = samples_[k];
            const SampleBasis& b = sample_bases_[k];
            const double angle = s.continuity >= Continuity::G1 ? weights_.angle : 0.0;
            const bool leads_in = s.continuity >= Continuity::G1 && s.loop >= 0;
            const double across = leads_in ? kStartAcross : 0.0;
            const Eigen::Matrix3d block =
                angle * s.normal * s.normal.transpose() + across * Eigen::Matrix3d::Identity();
            for (int q = 0; q < kLocal; ++q) {
                local_right.segment<3>(3 * q) +=
                    s.length * (b.value[q] * s.point + across * b.across[q] * s.inward);
                for (int p = q; p < kLocal; ++p) {
                    local.block<3, 3>(3 * p, 3 * q) +=
                        s.length * (b.value[p] * b.value[q] * Eigen::Matrix3d::Identity() +
                                    b.across[p] * b.across[q] * block);
                }
            }
        }
        scatter(span, local, matrix);
        scatter(span, local_right, right);
    }
    const bool definite = matrix.factorise();
    SUTURE_EXPECTS(definite);
    const Eigen::VectorXd x = matrix.solve(right);
    return {u_, v_, Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3)};
}

// A span's residuals and their derivatives with respect to its poles.
class System::Rows {
  public:
    explicit Rows(std::size_t most)
        : derivatives_(3 * kLocal, static_cast<Eigen::Index>(most)),
          residuals_(static_cast<Eigen::Index>(most)) {}

    /// The place for the derivatives of one more residual.
    Eigen::Map<LocalPoles> next(double residual) {
        residuals_[count_] = residual;
        return Eigen::Map<LocalPoles>(derivatives_.col(count_++).data());
    }
    [[nodiscard]] auto derivatives() const { return derivatives_.leftCols(count_); }
    [[nodiscard]] auto residuals() const { return residuals_.head(count_); }

  private:
    Eigen::Matrix<double, 3 * kLocal, Eigen::Dynamic> derivatives_;
    Eigen::VectorXd residuals_;
    Eigen::Index count_ = 0;
};

void System::add_energy(const Span& span, const LocalPoles& poles, Rows& rows) const {
    for (const QuadraturePoint& point : span.points) {
        const LocalBasis basis = basis_at(point);
        const CurvatureVariation variation =
            linearised_curvature_variation(poles.lazyProduct(basis));
        const double scale = std::sqrt(weights_.energy * point.weight);
        for (int k = 0; k < 4; ++k) {
            const Eigen::Map<const Derivatives> chain(variation.jacobian.col(k).data());
            rows.next(scale * variation.residual[k]) =
                (scale * chain).lazyProduct(basis.transpose());
        }
    }
}

void System::add_conditions(const Span& span, const LocalPoles& poles, Rows& rows) const {
    for (const std::size_t k : span.samples) {
        const BoundarySample& s = samples_[k];
        const SampleBasis& b = sample_bases_[k];
        const Residuals w = residual_weights(k).cwiseSqrt();
        const Residuals r = w.cwiseProduct(residuals(k, poles));
        if (w[3] > 0.0) {
            rows.next(r[3]) = (w[3] * s.normal).lazyProduct(b.across.transpose());
        }
        if (w[4] > 0.0) {
            const Eigen::Vector3d pull = 2.0 * s.curvature * poles.lazyProduct(b.across);
            rows.next(r[4]) = w[4] * (s.normal.lazyProduct(b.second.transpose()) -
                                      pull.lazyProduct(b.across.transpose()));
        }
    }
}

// Position is alike in x, y and z: a matrix of a third of the size.
void System::add_positions(const Span& span, const LocalPoles& poles, Local& local) const {
    if (span.samples.empty()) {
        return;
    }
    Eigen::Matrix<double, kLocal, kLocal> gram = decltype(gram)::Zero();
    Eigen::Map<LocalPoles> gradient(local.gradient.data());
    for (const std::size_t k : span.samples) {
        const LocalValues& value = sample_bases_[k].value;
        const double weight = samples_[k].length;
        const Eigen::Vector3d miss = poles.lazyProduct(value) - samples_[k].point;
        gram.selfadjointView<Eigen::Lower>().rankUpdate(value, weight);
        gradient += (weight * miss).lazyProduct(value.transpose());
        local.objective += 0.5 * weight * miss.squaredNorm();
    }
    for (int q = 0; q < kLocal; ++q) {
        for (int p = q; p < kLocal; ++p) {
            for (int c = 0; c < 3; ++c) {
                local.matrix(3 * p + c, 3 * q + c) += gram(p, q);
            }
        }
    }
}

void System::scatter(const Span& span, const LocalMatrix& local, BlockBand& matrix) const {
    constexpr int kRow = 3 * kOrder;  // unknowns of one row of poles on a span
    const int size = matrix.size();
    for (int b = 0; b < kOrder; ++b) {
        for (int a = b; a < kOrder; ++a) {
            matrix.column(span.v + b).block<kRow, kRow>((a - b) * size + 3 * span.u, 3 * span.u) +=
                local.block<kRow, kRow>(kRow * a, kRow * b);
        }
    }
}

void System::scatter(const Span& span, const LocalVector& local, Eigen::VectorXd& vector) const {
    constexpr int kRow = 3 * kOrder;
    for (int b = 0; b < kOrder; ++b) {
        vector.segment<kRow>(3 * (span.u + u_.count() * (span.v + b))) +=
            local.segment<kRow>(kRow * b);
    }
}

System::Linearised System::linearise(const Net& net) const {
    Linearised result{BlockBand(v_.count(), 3 * u_.count(), kDegree),
                      Eigen::VectorXd::Zero(net.unknowns()), 0.0};
    // Row by row: the spans of a row side by side, then added in their own order, so that the sums
    // are the same on any number of threads.
    const auto width = static_cast<std::size_t>(u_.spans());
    std::vector<Local> row(width);
    for (std::size_t first = 0; first < spans_.size(); first += width) {
        tbb::parallel_for(std::size_t{0}, width, [&](std::size_t i) {
            const Span& span = spans_[first + i];
            Local& local = row[i];
            if (!span.empty()) {
                const LocalPoles poles = net.local_poles(span.u, span.v);
                Rows rows(4 * span.points.size() + 2 * span.samples.size());
                add_energy(span, poles, rows);
                add_conditions(span, poles, rows);
                local.matrix.setZero();
                add_gram(rows.derivatives(), local.matrix);
                local.gradient = rows.derivatives() * rows.residuals();
                local.objective = 0.5 * rows.residuals().squaredNorm();
                add_positions(span, poles, local);
            }
        });
        for (std::size_t i = 0; i < width; ++i) {
            const Span& span = spans_[first + i];
            if (!span.empty()) {
                scatter(span, row[i].matrix, result.matrix);
                scatter(span, row[i].gradient, result.gradient);
                result.objective += row[i].objective;
            }
        }
    }
    const Eigen::Matrix3Xd flat = weights_.energy * flat_.times(net.poles.transpose()).transpose();
    result.matrix.add_per_component(flat_, weights_.energy);
    result.gradient += flat.reshaped();
    result.objective += 0.5 * flat.cwiseProduct(net.poles).sum();
    return result;
}

double System::linearising_work() const {
    constexpr double kGram = 0.5 * 3 * kLocal * (3 * kLocal + 1);
    return kGram * (4.0 * static_cast<double>(point_count_) + static_cast<double>(samples_.size()));
}

double System::objective(const Net& net) const {
    std::vector<double> sums(spans_.size(), 0.0);
    tbb::parallel_for(std::size_t{0}, spans_.size(), [&](std::size_t i) {
        const Span& span = spans_[i];
        const LocalPoles poles = net.local_poles(span.u, span.v);
        for (const QuadraturePoint& point : span.points) {
            const Derivatives X = poles.lazyProduct(basis_at(point));
            sums[i] += weights_.energy * point.weight * curvature_variation(X).squaredNorm();
        }
        for (const std::size_t k : span.samples) {
            sums[i] += residual_weights(k).dot(residuals(k, poles).cwiseAbs2());
        }
    });
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    const Eigen::MatrixX3d x = net.poles.transpose();
    return 0.5 * (sum + weights_.energy * x.cwiseProduct(flat_.times(x)).sum());
}

double System::variation(const Net& net) const {
    std::vector<double> sums(spans_.size(), 0.0);
    tbb::parallel_for(std::size_t{0}, spans_.size(), [&](std::size_t i) {
        const Span& span = spans_[i];
        const LocalPoles poles = net.local_poles(span.u, span.v);
        for (const QuadraturePoint& point : span.points) {
            const Derivatives X = poles.lazyProduct(basis_at(point));
            sums[i] += point.weight * curvature_variation(X).squaredNorm();
        }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void System::set_weights(const Weights& weights) {
    weights_ = weights;
    flat_ = flat({0.0, 0.0, weights.parametrisation, weights.extension}, weights.jump);
}

double System::normal_move(const Net& net, const Net& moved) const {
    double largest = 0.0;
    for (const Span& span : spans_) {
        const LocalPoles poles = net.local_poles(span.u, span.v);
        const LocalPoles change = moved.local_poles(span.u, span.v) - poles;
        for (const QuadraturePoint& point : span.points) {
            const Derivatives X = poles.lazyProduct(basis_at(point));
            const Eigen::Vector3d n = X.col(0).cross(X.col(1)).normalized();
            const LocalValues values =
                local_values(u_nodes_.rows[point.u_row], v_nodes_.rows[point.v_row]);
            largest = std::max(largest, std::abs(n.dot(change * values)));
        }
    }
    return largest;
}

}  // namespace suture::mvs
