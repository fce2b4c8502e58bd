#include "suture/fill/manifold/centre.h"

#include "suture/fill/manifold/hermite_net.h"
#include "suture/spline/knots.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Taylor series up to this order hold d^4 / du^2 dv^2.
constexpr int kOrder = 4;

/// How far beside a knot, in a unit square, its two sides are told apart.
constexpr double kBeside = 1e-7;

/// Breaks closer than this, in a unit interval, are one.
constexpr double kSame = 1e-9;

/// Where any side has a knot, and in between so often that no span is longer than 1 / spans.
std::vector<double> first_breaks(const Star& star, double reach, int spans) {
    std::vector<double> knots = {0.0, 1.0};
    for (int m = 0; m < star.n(); ++m) {
        for (const double y : star.knots_y(m)) {
            const double t = std::abs(y) / reach;
            if (t < 1.0 - kSame && t > kSame) {
                knots.push_back(t);
            }
        }
    }
    std::sort(knots.begin(), knots.end());
    std::vector<double> breaks = {0.0};
    for (const double knot : knots) {
        const double from = breaks.back();
        if (knot - from < kSame) {
            continue;
        }
        const int pieces = static_cast<int>(std::ceil((knot - from) * spans - kSame));
        for (int p = 1; p <= pieces; ++p) {
            breaks.push_back(p == pieces ? knot : from + (knot - from) * p / pieces);
        }
    }
    return breaks;
}

/// More breaks where the error asks for them: it falls like a span's power k + 1.
///
/// Input    errors: of each span, the largest in its row and its column of the square.
std::vector<double> finer(const std::vector<double>& breaks, const std::vector<double>& errors,
                          double tolerance, int k, int most_spans) {
    constexpr double kGoal = 0.7;  // of the tolerance: errors fall less evenly than that
    constexpr double kMostPieces = 3.0;
    std::vector<double> wanted;
    for (const double error : errors) {
        const double excess = error / (kGoal * tolerance);
        wanted.push_back(excess > 1.0 ? std::min(std::pow(excess, 1.0 / (k + 1)), kMostPieces)
                                      : 1.0);
    }
    // All of them together may be too many: then all get less.
    double share = 1.0;
    const auto pieces_of = [&](double pieces) {
        return std::max(1, static_cast<int>(std::ceil(share * pieces - kSame)));
    };
    const auto spans = [&] {
        int sum = 0;
        for (const double pieces : wanted) {
            sum += pieces_of(pieces);
        }
        return sum;
    };
    constexpr double kLess = 0.95;
    while (share * kMostPieces > 1.0 && spans() > most_spans) {
        share *= kLess;
    }
    std::vector<double> result = {0.0};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const int pieces = pieces_of(wanted[i]);
        for (int p = 1; p <= pieces; ++p) {
            result.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * p / pieces);
        }
        result.back() = breaks[i + 1];
    }
    return result;
}

/// A spline curve of degree 4 with simple knots on [0,1]: three times differentiable, so that a
/// quadratic times its derivative fits a biquintic net of second derivatives.
class SpokeCurve {
  public:
    /// ends: point and two derivatives at 0, point and derivative at 1, all of them met; samples
    /// at the given parameters are approximated.
    SpokeCurve(const std::vector<double>& breaks, const Matrix3Xd& ends,
               const std::vector<double>& where, const Matrix3Xd& samples) {
        knots_.assign(kDegree, 0.0);
        knots_.insert(knots_.end(), breaks.begin(), breaks.end());
        knots_.insert(knots_.end(), kDegree, 1.0);
        const auto count = static_cast<Eigen::Index>(breaks.size()) + kDegree - 1;
        poles_ = Matrix3Xd::Zero(3, count);
        const MatrixXd first = derivatives(0.0, 2).leftCols(3);
        poles_.leftCols(3) = ends.leftCols(3) * first.inverse().transpose();
        const MatrixXd last = derivatives(1.0, 1).rightCols(2);
        poles_.rightCols(2) = ends.rightCols(2) * last.inverse().transpose();
        const Eigen::Index free = count - 5;
        if (free == 0) {
            return;
        }
        MatrixXd rows = MatrixXd::Zero(samples.cols(), count);
        for (Eigen::Index k = 0; k < samples.cols(); ++k) {
            const double t = where[static_cast<std::size_t>(k)];
            rows.block(k, find_span(knots_, kDegree, t) - kDegree, 1, kDegree + 1) =
                derivatives(t, 0);
        }
        const MatrixXd open = rows.middleCols(3, free);
        const MatrixXd rest = samples.transpose() - rows * poles_.transpose();
        poles_.middleCols(3, free) =
            (open.transpose() * open).ldlt().solve(open.transpose() * rest).transpose();
    }

    /// Point and derivatives up to the third, one a column.
    [[nodiscard]] Matrix3Xd at(double t) const {
        const int span = find_span(knots_, kDegree, t);
        return poles_.middleCols(span - kDegree, kDegree + 1) * derivatives(t, 3).transpose();
    }

  private:
    static constexpr int kDegree = 4;
    std::vector<double> knots_;
    Matrix3Xd poles_;

    [[nodiscard]] MatrixXd derivatives(double t, int orders) const {
        return basis_derivatives(knots_, kDegree, find_span(knots_, kDegree, t), t, orders);
    }
};

class CentreFit {
  public:
    CentreFit(const StarSurface& surface, std::vector<double> breaks)
        : surface_(surface), star_(surface.star()), map_(star_), breaks_(std::move(breaks)) {
        for (int m = 0; m < star_.n(); ++m) {
            Series<3> one = surface_.expand(variable(0.0, 0, kOrder), variable(0.0, 1, kOrder),
                                            map_.at(m, {kBeside, kBeside}));
            middle_ += (1.0 / star_.n()) * one;
        }
        // Beyond C2 the net goes no further; C0 and C1 surfaces have kinks of their own.
        const int smoothness = std::min(star_.k(), 2);
        nets_.assign(static_cast<std::size_t>(star_.n()), HermiteNet(breaks_, smoothness));
        sample(smoothness);
        for (int m = 0; m < star_.n(); ++m) {
            join_along(m);
        }
    }

    [[nodiscard]] Centre take() const {
        Centre centre;
        centre.spans = static_cast<int>(breaks_.size()) - 1;
        for (const HermiteNet& net : nets_) {
            centre.quads.push_back(net.spline());
        }
        return centre;
    }

    /// Of each span, the largest error in its row and its column of any square.
    [[nodiscard]] std::vector<double> measure_errors(
        const std::vector<SplineSurface>& quads) const {
        std::vector<double> errors(breaks_.size() - 1, 0.0);
        constexpr double kPlaces[] = {0.3, 0.7};
        const auto between = [&](std::size_t i, double t) {
            return breaks_[i] + t * (breaks_[i + 1] - breaks_[i]);
        };
        for (std::size_t j = 0; j < errors.size(); ++j) {
            for (std::size_t i = 0; i < errors.size(); ++i) {
                for (const double a : kPlaces) {
                    for (const double b : kPlaces) {
                        const double error = error_at({between(i, a), between(j, b)}, quads);
                        errors[i] = std::max(errors[i], error);
                        errors[j] = std::max(errors[j], error);
                    }
                }
            }
        }
        return errors;
    }

  private:
    const StarSurface& surface_;
    const Star& star_;
    QuadMap map_;
    std::vector<double> breaks_;
    std::vector<HermiteNet> nets_;
    /// S about O by x and y. Below C2 the quads see different second derivatives there; their mean
    /// is one that all twists agree with.
    Series<3> middle_{kOrder};

    [[nodiscard]] int last() const { return static_cast<int>(breaks_.size()) - 1; }

    /// A point of the square in X, between the spokes 0 and 1, and a point on the side of it that
    /// counts for knots.
    struct Place {
        PlaneSeries series;
        Vector2d near;
        bool middle = false;
    };

    [[nodiscard]] Place place(const Vector2d& at, const Vector2d& towards) const {
        // At the border zone the strip's own series counts: charts of other sides may begin there.
        Vector2d side = towards;
        if (at.x() == 1.0) {
            side.x() = 1.0;
        } else if (at.y() == 1.0) {
            side.y() = 1.0;
        }
        return {map_.expand(0, at, towards, kOrder), map_.at(0, at + kBeside * side), at.isZero()};
    }

    [[nodiscard]] Series<3> expand(int m, const Place& place) const {
        const Vector2d x = star_.from_side(m, Vector2d::UnitX());
        const Vector2d y = star_.from_side(m, Vector2d::UnitY());
        const PlaneSeries& p = place.series;
        const Series<1> in_x = x.x() * p[0] + y.x() * p[1];
        const Series<1> in_y = x.y() * p[0] + y.y() * p[1];
        return place.middle ? compose(middle_, in_x, in_y)
                            : surface_.expand(in_x, in_y, star_.from_side(m, place.near));
    }
    [[nodiscard]] Series<3> expand(int m, const Vector2d& at, const Vector2d& towards) const {
        return expand(m, place(at, towards));
    }

    static NodeJet jet_of(const Series<3>& series) {
        NodeJet jet;
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                jet[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] =
                    series.derivative(a, b);
            }
        }
        return jet;
    }

    /// The derivatives of the surface at all nodes.
    void sample(int smoothness) {
        for (int j = 0; j <= last(); ++j) {
            for (int i = 0; i <= last(); ++i) {
                for (const int side_u : {-1, 1}) {
                    for (const int side_v : {-1, 1}) {
                        sample(i, j, side_u, side_v, smoothness);
                    }
                }
            }
        }
    }

    void sample(int i, int j, int side_u, int side_v, int smoothness) {
        const bool first = side_u < 0 && side_v < 0;
        if (smoothness == 2 && !first) {
            for (HermiteNet& net : nets_) {
                net.jet(i, j, side_u, side_v) = net.jet(i, j, -1, -1);
            }
            return;
        }
        // Inside of the square, where a node lies on its border.
        const Vector2d towards(i == 0 ? 1 : (i == last() ? -1 : side_u),
                               j == 0 ? 1 : (j == last() ? -1 : side_v));
        const Vector2d at(breaks_[static_cast<std::size_t>(i)],
                          breaks_[static_cast<std::size_t>(j)]);
        const Place here = place(at, towards);
        for (int m = 0; m < star_.n(); ++m) {
            NodeJet& jet = nets_[static_cast<std::size_t>(m)].jet(i, j, side_u, side_v);
            jet = jet_of(expand(m, here));
            if (i == last() && j == last()) {
                // Along v = 1 it is the other strip's.
                Place other = here;
                other.near = map_.at(0, at + kBeside * Vector2d(-1.0, 1.0));
                const NodeJet along = jet_of(expand(m, other));
                jet[2][0] = along[2][0];
                jet[2][1] = along[2][1];
            }
        }
    }

    [[nodiscard]] SpokeCurve fit_spoke(int m) const {
        Matrix3Xd ends(3, 5);
        const Series<3> start = expand(m, {0.0, 0.0}, {1.0, 1.0});
        const Series<3> end = expand(m, {1.0, 0.0}, {-1.0, 1.0});
        ends << start.derivative(0, 0), start.derivative(1, 0), start.derivative(2, 0),
            end.derivative(0, 0), end.derivative(1, 0);
        std::vector<double> where;
        constexpr int kSamples = 5;
        for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
            for (int a = 0; a < kSamples; ++a) {
                where.push_back(breaks_[i] + (breaks_[i + 1] - breaks_[i]) * (a + 0.5) / kSamples);
            }
        }
        Matrix3Xd samples(3, static_cast<Eigen::Index>(where.size()));
        for (std::size_t k = 0; k < where.size(); ++k) {
            samples.col(static_cast<Eigen::Index>(k)) = surface_.at(map_.at(m, {where[k], 0.0}));
        }
        return {breaks_, ends, where, samples};
    }

    /// Gives the quads on both sides of spoke m the same curve and matching cross derivatives.
    void join_along(int m) {
        const SpokeCurve curve = fit_spoke(m);
        HermiteNet& above = nets_[static_cast<std::size_t>(m)];
        HermiteNet& below = nets_[static_cast<std::size_t>((m + star_.n() - 1) % star_.n())];
        for (int i = 0; i <= last(); ++i) {
            const double u = above.at(i);
            const Matrix3Xd c = curve.at(u);
            const std::array<Vector3d, 3> along = blended(u, c.rightCols(3));
            for (const int side : {-1, 1}) {
                const int towards = i == 0 ? 1 : (i == last() ? -1 : side);
                const std::array<Vector3d, 3> across = across_spoke(m, u, towards);
                for (std::size_t a = 0; a < 3; ++a) {
                    for (const int other : {-1, 1}) {
                        NodeJet& up = above.jet(i, 0, side, other);
                        NodeJet& down = below.jet(0, i, other, side);
                        up[a][0] = down[0][a] = c.col(static_cast<Eigen::Index>(a));
                        up[a][1] = along[a] + across[a];
                        down[1][a] = along[a] - across[a];
                    }
                }
            }
        }
    }

    /// b C' and its derivatives up to the second, from C', C'', C'''.
    [[nodiscard]] std::array<Vector3d, 3> blended(double u, const Matrix3Xd& d) const {
        const Eigen::VectorXd& b = map_.blend();
        const double b0 = b[0] + u * (b[1] + u * b[2]);
        const double b1 = b[1] + 2.0 * u * b[2];
        const double b2 = 2.0 * b[2];
        return {b0 * d.col(0), b1 * d.col(0) + b0 * d.col(1),
                b2 * d.col(0) + 2.0 * b1 * d.col(1) + b0 * d.col(2)};
    }

    /// The part c of the surface's own cross derivative, and its derivatives along the spoke.
    [[nodiscard]] std::array<Vector3d, 3> across_spoke(int m, double u, int towards) const {
        const Series<3> s = expand(m, {u, 0.0}, {static_cast<double>(towards), 1.0});
        Matrix3Xd own(3, 3);
        own << s.derivative(1, 0), s.derivative(2, 0), s.derivative(3, 0);
        const std::array<Vector3d, 3> along = blended(u, own);
        return {s.derivative(0, 1) - along[0], s.derivative(1, 1) - along[1],
                s.derivative(2, 1) - along[2]};
    }

    [[nodiscard]] double error_at(const Vector2d& at,
                                  const std::vector<SplineSurface>& quads) const {
        const Vector2d in_x = map_.at(0, at);
        double error = 0.0;
        for (int m = 0; m < star_.n(); ++m) {
            const Vector3d p = evaluate(quads[static_cast<std::size_t>(m)], at.x(), at.y()).point;
            error = std::max(error, (p - surface_.at(star_.from_side(m, in_x))).norm());
        }
        return error;
    }
};

}  // namespace

Centre fit_centre(const StarSurface& surface, double tolerance, int most_spans) {
    constexpr int kFirst = 8;
    const Star& star = surface.star();
    std::vector<double> breaks =
        first_breaks(star, QuadMap(star).reach(), std::min(kFirst, most_spans));
    for (;;) {
        const CentreFit fit(surface, breaks);
        Centre centre = fit.take();
        const std::vector<double> errors = fit.measure_errors(centre.quads);
        centre.error = *std::max_element(errors.begin(), errors.end());
        std::vector<double> more = centre.error <= tolerance
                                       ? breaks
                                       : finer(breaks, errors, tolerance, star.k(), most_spans);
        if (more.size() == breaks.size()) {
            return centre;
        }
        breaks = std::move(more);
    }
}

}  // namespace suture::manifold
