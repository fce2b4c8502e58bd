#pragma once

#include "suture/fill/mvs/block_cholesky.h"
#include "suture/fill/mvs/knot_lines.h"
#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace suture::mvs {

/// The weights of the terms in the objective. The solver's unit makes them numbers.
struct Weights {
    double energy = 1e-7;           ///< of the variation of curvature, against position = 1
    double parametrisation = 1e-6;  ///< of the flat second-order term, against energy
    double extension = 1e-8;        ///< of the flat third-order term over the box, against energy
    double angle = 0.03;            ///< of the squared angle to the neighbour, against position
    double curvature = 1e-3;        ///< of the squared curvature error, likewise
    double jump = 0.0;              ///< of the squared jumps across knot lines, against energy
};

/// What is minimised on one net: half the sum of
///   energy * (integral of |grad II|^2 over the domain + flat terms over the box
///             + jump * integrals along the knot lines of |[X_cc]|^2 + h^2 |[X_ccc]|^2)
///   + sum over the samples of length * (|X - c|^2 + angle (n . X_a)^2
///                                       + curvature (n . X_aa - II(X_a, X_a))^2),
/// a for the direction across the boundary, c, n and II for the neighbour's, [ ] for the jump in
/// the direction c across a line and h for the shorter span beside it.
class System {
  public:
    /// Input    the loops of the domain's boundary as closed polygons (2 x count).
    System(Axis u, Axis v, const std::vector<Eigen::Matrix2Xd>& polygons,
           std::vector<BoundarySample> samples, const std::vector<KnotLine>& lines,
           const Weights& weights);

    /// The minimiser of the flat third-order energy that meets position and tangency and leaves the
    /// boundary at about unit speed: a linear problem.
    [[nodiscard]] Net start() const;

    [[nodiscard]] double objective(const Net& net) const;

    /// The integral of |grad II|^2 over the domain.
    [[nodiscard]] double variation(const Net& net) const;

    struct Linearised {
        BlockBand matrix;
        Eigen::VectorXd gradient;
        double objective = 0.0;
    };
    [[nodiscard]] Linearised linearise(const Net& net) const;

    /// The flat second-order energy over the box, by which steps are damped: it keeps the
    /// parametrisation, which the energy leaves free, from wandering. Alike in x, y and z: one row
    /// a pole.
    [[nodiscard]] const BlockBand& damping() const { return damping_; }

    /// The largest move of the surface along its normal, between two nets.
    [[nodiscard]] double normal_move(const Net& net, const Net& moved) const;

    void set_weights(const Weights& weights);
    [[nodiscard]] const Weights& weights() const { return weights_; }

    [[nodiscard]] const Axis& u() const { return u_; }
    [[nodiscard]] const Axis& v() const { return v_; }
    [[nodiscard]] std::size_t quadrature_points() const { return point_count_; }

    /// The multiplications, about, that linearise() takes.
    [[nodiscard]] double linearising_work() const;

  private:
    static constexpr int kConditions = 5;  // position, angle, curvature
    using Residuals = Eigen::Matrix<double, kConditions, 1>;

    struct QuadraturePoint {
        std::size_t u_row, v_row;
        double weight;
    };
    struct SampleBasis {
        LocalValues value, across, second;
    };
    struct Span {
        int u = 0;
        int v = 0;
        std::vector<QuadraturePoint> points;
        std::vector<std::size_t> samples;
        [[nodiscard]] bool empty() const { return points.empty() && samples.empty(); }
    };
    using LocalMatrix = Eigen::Matrix<double, 3 * kLocal, 3 * kLocal>;
    using LocalVector = Eigen::Matrix<double, 3 * kLocal, 1>;
    using LocalPoles = Eigen::Matrix<double, 3, kLocal>;
    class Rows;
    /// What one span adds to the linearised system.
    struct Local {
        LocalMatrix matrix;
        LocalVector gradient;
        double objective = 0.0;
    };

    void place_quadrature(const std::vector<Eigen::Matrix2Xd>& polygons);
    void place_samples();
    struct Range {
        std::size_t first = 0;
        std::size_t end = 0;
        [[nodiscard]] std::size_t count() const { return end - first; }
    };
    /// The Gauss points in one direction, span by span: for spans that the boundary cuts, and for
    /// those wholly inside.
    struct Nodes {
        std::vector<BasisRow> rows;
        std::vector<double> at, weights;
        std::vector<Range> cut, whole;
    };
    [[nodiscard]] static Nodes nodes_of(const Axis& axis);
    void place_point(Span& span, std::size_t u_row, std::size_t v_row) const;
    void place_in_whole(Span& span) const;
    [[nodiscard]] BlockBand flat(const std::array<double, 4>& orders, double jump) const;
    [[nodiscard]] LocalBasis basis_at(const QuadraturePoint& point) const;
    [[nodiscard]] Residuals residuals(std::size_t sample, const LocalPoles& poles) const;
    [[nodiscard]] Residuals residual_weights(std::size_t sample) const;
    void add_energy(const Span& span, const LocalPoles& poles, Rows& rows) const;
    void add_conditions(const Span& span, const LocalPoles& poles, Rows& rows) const;
    void add_positions(const Span& span, const LocalPoles& poles, Local& local) const;
    void scatter(const Span& span, const LocalMatrix& local, BlockBand& matrix) const;
    void scatter(const Span& span, const LocalVector& local, Eigen::VectorXd& vector) const;

    Axis u_, v_;
    std::vector<BoundarySample> samples_;
    Weights weights_;
    std::vector<KnotLine> lines_;
    Nodes u_nodes_, v_nodes_;
    std::vector<Span> spans_;  // u fastest
    std::vector<SampleBasis> sample_bases_;
    std::size_t point_count_ = 0;
    BlockBand flat_;  // one row a pole, like damping_
    BlockBand damping_;
};

}  // namespace suture::mvs
