#include "suture/fill/manifold/border_fit.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suture::manifold {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// An angle of 1 counts as much as a distance of this share of the diameter.
constexpr double kAngleWeight = 0.05;
/// A relative error of the curvature of 1 counts as much as an angle of this.
constexpr double kCurvatureWeight = 0.1;
/// Where the border folds, the cross derivative is held near the inward direction, weakly against
/// the angle.
constexpr double kSenseWeights[] = {0.0, 1e-3, 1e-2};
/// Of the energy against the mean square of a border residual.
constexpr double kEnergyWeight = 1e-9;
/// Samples of the border a knot interval.
constexpr int kSamples = 4;

/// A sample of a ribbon and where it lies on the border.
struct Sample {
    const Ribbon* ribbon = nullptr;
    RibbonPoint wanted;
    BorderRow row;
    double weight = 0.0;  ///< share of the border's length
};

Matrix3Xd derivatives(const Sample& sample, const Matrix3Xd& points) {
    Matrix3Xd own(3, static_cast<Eigen::Index>(sample.row.points.size()));
    for (std::size_t k = 0; k < sample.row.points.size(); ++k) {
        own.col(static_cast<Eigen::Index>(k)) = points.col(sample.row.points[k]);
    }
    return own * sample.row.weights.transpose();
}

/// Samples per interval, `offset` of an interval from its start.
std::vector<Sample> samples_of(const BorderModel& model, const Hole& hole, const Sides& sides,
                               double offset) {
    std::vector<Sample> samples;
    double total = 0.0;
    for (const Side& side : sides.sides) {
        total += side.length;
    }
    for (std::size_t m = 0; m < sides.sides.size(); ++m) {
        const Side& side = sides.sides[m];
        for (const Piece& piece : side.pieces) {
            const double share = piece.to - piece.from;
            const int count =
                std::max(4, static_cast<int>(std::ceil(share * model.intervals[m] * kSamples)));
            for (int q = 0; q <= count; ++q) {
                const double s = std::min(1.0, (q + offset) / count);
                Sample sample;
                sample.row =
                    model.row(static_cast<int>(m), model.y_of(static_cast<int>(m), piece, s));
                sample.ribbon = &hole.loops.front().ribbons[static_cast<std::size_t>(piece.ribbon)];
                sample.wanted = sample.ribbon->at(s);
                sample.weight = share * side.length / total / (count + 1);
                samples.push_back(std::move(sample));
            }
        }
    }
    return samples;
}

/// The normal equations of all residuals, for the three coordinates of all points together.
class Normal {
  public:
    explicit Normal(int count) : right_(VectorXd::Zero(3 * count)) {}

    /// Adds the residual sum_k direction . P_k row_k - value.
    void add(const Sample& sample, const MatrixXd& gradient, double value, double weight) {
        for (std::size_t a = 0; a < sample.row.points.size(); ++a) {
            for (int c = 0; c < 3; ++c) {
                const double x = weight * gradient(c, static_cast<Eigen::Index>(a));
                if (x == 0.0) {
                    continue;
                }
                right_[3 * sample.row.points[a] + c] += x * value;
                for (std::size_t b = 0; b < sample.row.points.size(); ++b) {
                    for (int d = 0; d < 3; ++d) {
                        const double y = gradient(d, static_cast<Eigen::Index>(b));
                        if (y != 0.0) {
                            entries_.emplace_back(3 * sample.row.points[a] + c,
                                                  3 * sample.row.points[b] + d, x * y);
                        }
                    }
                }
            }
        }
    }

    void add(const Eigen::SparseMatrix<double>& energy, double weight) {
        for (int column = 0; column < energy.outerSize(); ++column) {
            for (Eigen::SparseMatrix<double>::InnerIterator it(energy, column); it; ++it) {
                for (int c = 0; c < 3; ++c) {
                    entries_.emplace_back(3 * static_cast<int>(it.row()) + c,
                                          3 * static_cast<int>(it.col()) + c, weight * it.value());
                }
            }
        }
    }

    [[nodiscard]] Result<Matrix3Xd> solve() const {
        Eigen::SparseMatrix<double> matrix(right_.size(), right_.size());
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
        if (solver.info() != Eigen::Success) {
            return fail(ErrorCode::Refused,
                        "the least squares of the border have no unique solution");
        }
        VectorXd solution = solver.solve(right_);
        // One step of iterative refinement: the energy's weight makes the matrix stiff.
        solution += solver.solve(right_ - matrix * solution);
        return Matrix3Xd(solution.reshaped(3, solution.size() / 3));
    }

  private:
    std::vector<Eigen::Triplet<double>> entries_;
    VectorXd right_;
};

/// Adds what one sample asks for. before: the points of the step before, for G2.
void add_sample(Normal& normal, const Sample& sample, double slope_weight,
                const Matrix3Xd* before) {
    const RibbonPoint& w = sample.wanted;
    for (int c = 0; c < 3; ++c) {
        normal.add(sample, Vector3d::Unit(c) * sample.row.weights.row(0), w.point[c],
                   sample.weight);
    }
    if (sample.ribbon->continuity < Continuity::G1) {
        return;
    }
    normal.add(sample, w.normal * sample.row.weights.row(1), 0.0,
               sample.weight * slope_weight * slope_weight);
    if (sample.ribbon->continuity < Continuity::G2 || before == nullptr) {
        return;
    }
    // n . S_xx - II(S_x, S_x), about the step before.
    const Vector3d x = derivatives(sample, *before).col(1);
    const Vector3d slope = 2.0 * w.curvature * x;
    const double bend = kCurvatureWeight * slope_weight;
    normal.add(sample, w.normal * sample.row.weights.row(3) - slope * sample.row.weights.row(1),
               -x.dot(w.curvature * x), sample.weight * bend * bend);
}

/// Where the border faces the neighbours' way all along, the largest gap and angle.
Result<void> measure(BorderFit& fit, const std::vector<Sample>& samples) {
    for (const Sample& sample : samples) {
        const Matrix3Xd d = derivatives(sample, fit.points);
        fit.gap = std::max(fit.gap, (d.col(0) - sample.wanted.point).norm());
        if (sample.ribbon->continuity < Continuity::G1) {
            continue;
        }
        const Vector3d normal = Vector3d(d.col(1)).cross(Vector3d(d.col(2))).normalized();
        const double angle =
            std::atan2(normal.cross(sample.wanted.normal).norm(), normal.dot(sample.wanted.normal));
        if (angle > kPi / 2.0) {
            return fail(ErrorCode::Refused,
                        "the border folds at {}: its normal is {:.1f} deg off the neighbour's",
                        name_of(*sample.ribbon), degrees(angle));
        }
        fit.angle = std::max(fit.angle, angle);
    }
    return {};
}

}  // namespace

double BorderModel::y_of(int side, const Piece& piece, double s) const {
    const auto m = static_cast<std::size_t>(side);
    return low[m] + (high[m] - low[m]) * (piece.from + (piece.to - piece.from) * piece.along(s));
}

namespace {

Result<BorderFit> fit_once(const BorderModel& model, const Hole& hole, const Sides& sides,
                           double sense) {
    const std::vector<Sample> samples = samples_of(model, hole, sides, 0.0);
    const double slope_weight = kAngleWeight * hole.diameter / model.depth;
    const bool curvature =
        model.k >= 2 && std::any_of(samples.begin(), samples.end(), [](const Sample& sample) {
            return sample.ribbon->continuity == Continuity::G2;
        });
    BorderFit fit;
    constexpr int kSteps = 4;
    for (int step = 0; step < (curvature ? kSteps : 1); ++step) {
        Normal normal(model.points);
        for (const Sample& sample : samples) {
            add_sample(normal, sample, slope_weight, step > 0 ? &fit.points : nullptr);
            for (int c = 0; sense > 0.0 && c < 3; ++c) {
                const double weight = sense * slope_weight;
                normal.add(sample, Vector3d::Unit(c) * sample.row.weights.row(1),
                           -model.depth * sample.wanted.inward[c], sample.weight * weight * weight);
            }
        }
        normal.add(model.energy, kEnergyWeight);
        auto points = normal.solve();
        if (!points) {
            return tl::unexpected(points.error());
        }
        fit.points = std::move(*points);
    }
    constexpr double kBetween = 0.37;
    const auto measured = measure(fit, samples_of(model, hole, sides, kBetween));
    return measured ? Result<BorderFit>(fit) : tl::unexpected(measured.error());
}

}  // namespace

Result<BorderFit> fit_border(const BorderModel& model, const Hole& hole, const Sides& sides) {
    Result<BorderFit> fit;
    for (const double sense : kSenseWeights) {
        fit = fit_once(model, hole, sides, sense);
        if (fit) {
            break;
        }
    }
    return fit;
}

}  // namespace suture::manifold
