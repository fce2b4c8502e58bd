#include "suture/fill/manifold/border_fit.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
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
/// Where the surface folds, the cross derivative is held near that of a surface that does not,
/// weakly against the angle.
constexpr double kSenseWeights[] = {0.0, 1e-3, 1e-2, 1e-1, 0.3};
/// Of the energy against the mean square of a border residual.
constexpr double kEnergyWeight = 1e-9;
/// Solutions by the method of multipliers.
constexpr int kMultiplierSteps = 8;
/// A cross derivative that falls below this share of its median is mended like a fold.
constexpr double kEven = 0.1;
/// Samples of the border a knot interval.
constexpr int kSamples = 4;

/// A sample of a ribbon and where it lies on the border.
struct Sample {
    const Ribbon* ribbon = nullptr;
    RibbonPoint wanted;
    BorderRow row;
    double weight = 0.0;
};

Matrix3Xd derivatives(const Sample& sample, const Matrix3Xd& points) {
    Matrix3Xd own(3, static_cast<Eigen::Index>(sample.row.points.size()));
    for (std::size_t k = 0; k < sample.row.points.size(); ++k) {
        own.col(static_cast<Eigen::Index>(k)) = points.col(sample.row.points[k]);
    }
    return own * sample.row.weights.transpose();
}

/// The parameter s at which a piece has come to a share of its length.
double at_share(const Piece& piece, double share) {
    double low = 0.0;
    double high = 1.0;
    constexpr int kHalvings = 50;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        (piece.along(middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The knots of a side within a piece, as shares of the piece's length from 0 to 1.
std::vector<double> knots_on(const BorderModel& model, int side, const Piece& piece) {
    const auto m = static_cast<std::size_t>(side);
    const double from = model.y_at(side, piece.from);
    const double to = model.y_at(side, piece.to);
    std::vector<double> shares = {0.0};
    for (const double y : model.knots[m]) {
        const double share = (y - from) / (to - from);
        constexpr double kSame = 1e-6;
        if (share > shares.back() + kSame && share < 1.0 - kSame) {
            shares.push_back(share);
        }
    }
    shares.push_back(1.0);
    return shares;
}

/// Samples in every knot interval, `offset` of their distance from its start; all count the same,
/// so that short intervals next to corners are fitted as well as long ones.
std::vector<Sample> samples_of(const BorderModel& model, const Hole& hole, const Sides& sides,
                               double offset) {
    std::vector<Sample> samples;
    for (std::size_t m = 0; m < sides.sides.size(); ++m) {
        const auto side = static_cast<int>(m);
        for (const Piece& piece : sides.sides[m].pieces) {
            const Ribbon& ribbon =
                hole.loops.front().ribbons[static_cast<std::size_t>(piece.ribbon)];
            const std::vector<double> shares = knots_on(model, side, piece);
            for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
                const int last = i + 2 < shares.size() ? kSamples - 1 : kSamples;
                for (int q = 0; q <= last; ++q) {
                    const double within = std::min(1.0, (q + offset) / kSamples);
                    const double share = shares[i] + within * (shares[i + 1] - shares[i]);
                    const double s = at_share(piece, share);
                    Sample sample;
                    sample.row = model.row(side, model.y_of(side, piece, s));
                    sample.ribbon = &ribbon;
                    sample.wanted = ribbon.at(s);
                    sample.wanted.point = piece.meeting_point(sample.wanted.point, s);
                    samples.push_back(std::move(sample));
                }
            }
        }
    }
    for (Sample& sample : samples) {
        sample.weight = 1.0 / static_cast<double>(samples.size());
    }
    return samples;
}

/// Least squares in the three coordinates of all points together.
class System {
  public:
    explicit System(int count) : unknowns_(3 * count) {}

    /// What is only wished for is weighed against the energy; all else comes before it.
    enum class Kind { Demand, Wish };

    /// Adds the residual sum_k gradient_k . P_k - value.
    void add(const Sample& sample, const MatrixXd& gradient, double value, double weight,
             Kind kind = Kind::Demand) {
        const double root = std::sqrt(weight);
        const auto row = static_cast<int>(values_.size());
        for (std::size_t a = 0; a < sample.row.points.size(); ++a) {
            for (int c = 0; c < 3; ++c) {
                const double x = root * gradient(c, static_cast<Eigen::Index>(a));
                if (x != 0.0) {
                    entries_.emplace_back(row, 3 * sample.row.points[a] + c, x);
                }
            }
        }
        values_.push_back(root * value);
        demanded_.push_back(kind == Kind::Demand ? 1.0 : 0.0);
    }

    /// The least energy and the most wishes among the best approximations, by the method of
    /// multipliers: what is left of the residuals is added to the values and the same matrix
    /// solved again.
    [[nodiscard]] Result<Matrix3Xd> solve(const Eigen::SparseMatrix<double>& energy,
                                          int steps = kMultiplierSteps) const {
        const auto rows = static_cast<Eigen::Index>(values_.size());
        Eigen::SparseMatrix<double> a(rows, unknowns_);
        a.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SparseMatrix<double> transposed = a.transpose();
        const Eigen::SparseMatrix<double> matrix =
            Eigen::SparseMatrix<double>(transposed * a) + in_space(energy);
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
        if (solver.info() != Eigen::Success) {
            return fail(ErrorCode::Refused,
                        "the least squares of the border have no unique solution");
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

  private:
    Eigen::Index unknowns_;
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> values_;
    std::vector<double> demanded_;  ///< 1 or 0

    [[nodiscard]] Eigen::SparseMatrix<double> in_space(
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
};

/// Adds what one sample asks for. before: the points of the step before, for G2.
void add_sample(System& system, const Sample& sample, double slope_weight,
                const Matrix3Xd* before) {
    const RibbonPoint& w = sample.wanted;
    for (int c = 0; c < 3; ++c) {
        system.add(sample, Vector3d::Unit(c) * sample.row.weights.row(0), w.point[c],
                   sample.weight);
    }
    if (sample.ribbon->continuity < Continuity::G1) {
        return;
    }
    system.add(sample, w.normal * sample.row.weights.row(1), 0.0,
               sample.weight * slope_weight * slope_weight);
    if (sample.ribbon->continuity < Continuity::G2 || before == nullptr) {
        return;
    }
    // n . S_xx - II(S_x, S_x), about the step before.
    const Vector3d x = derivatives(sample, *before).col(1);
    const Vector3d slope = 2.0 * w.curvature * x;
    const double bend = kCurvatureWeight * slope_weight;
    system.add(sample, w.normal * sample.row.weights.row(3) - slope * sample.row.weights.row(1),
               -x.dot(w.curvature * x), sample.weight * bend * bend);
}

/// The least of some values, as a share of their median.
double evenness_of(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *std::min_element(values.begin(), values.end()) / *middle;
}

/// Where the border faces the neighbours' way all along, the largest gap and angle.
Result<void> measure(BorderFit& fit, const std::vector<Sample>& samples) {
    std::map<const Ribbon*, std::vector<double>> outward;
    for (const Sample& sample : samples) {
        const Matrix3Xd d = derivatives(sample, fit.points);
        fit.gap = std::max(fit.gap, (d.col(0) - sample.wanted.point).norm());
        outward[sample.ribbon].push_back(-sample.wanted.inward.dot(d.col(1)));
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
    for (auto& [unused, values] : outward) {
        fit.evenness = std::min(fit.evenness, evenness_of(values));
    }
    return {};
}

}  // namespace

double BorderModel::y_at(int side, double share) const {
    const auto m = static_cast<std::size_t>(side);
    const double c = centres.empty() ? 0.0 : centres[m];
    const double t = 2.0 * share - 1.0;
    const double moved = t - c * (1.0 - t * t) / (1.0 - c * c);
    return knots[m].front() + (knots[m].back() - knots[m].front()) * 0.5 * (1.0 + moved);
}

double BorderModel::y_of(int side, const Piece& piece, double s) const {
    return y_at(side, piece.from + (piece.to - piece.from) * piece.along(s));
}

namespace {

/// One border's fit, over and over with more asked of it.
class Fitter {
  public:
    Fitter(const BorderModel& model, const Hole& hole, const Sides& sides)
        : model_(model),
          hole_(hole),
          sides_(sides),
          slope_weight_(kAngleWeight * hole.diameter / model.depth),
          samples_(samples_of(model, hole, sides, 0.0)) {
        // Ends included: next to corners the angle is largest.
        for (const double offset : {0.0, 0.1, 0.37}) {
            std::vector<Sample> more = samples_of(model, hole, sides, offset);
            std::move(more.begin(), more.end(), std::back_inserter(measured_));
        }
    }

    /// Whether any sample asks for G2 and the model can have it.
    [[nodiscard]] bool curved() const {
        return model_.k >= 2 &&
               std::any_of(samples_.begin(), samples_.end(), [](const Sample& sample) {
                   return sample.ribbon->continuity == Continuity::G2;
               });
    }

    /// before: the points of the step before, for G2.
    [[nodiscard]] Result<BorderFit> fit(double sense, const Matrix3Xd* before) {
        if (sense > 0.0 && across_.cols() == 0) {
            find_across();
        }
        System system(model_.points);
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const Sample& sample = samples_[i];
            add_sample(system, sample, slope_weight_, before);
            for (int c = 0; sense > 0.0 && c < 3; ++c) {
                const double weight = sense * slope_weight_;
                system.add(sample, Vector3d::Unit(c) * sample.row.weights.row(1),
                           across_(c, static_cast<Eigen::Index>(i)),
                           sample.weight * weight * weight, System::Kind::Wish);
            }
        }
        auto points = system.solve(model_.energy);
        if (!points) {
            return tl::unexpected(points.error());
        }
        BorderFit fit;
        fit.points = std::move(*points);
        if (auto measured = measure(fit, measured_); !measured) {
            return tl::unexpected(measured.error());
        }
        if (const auto fold = model_.fold(fit.points)) {
            const int nearest =
                sides_.sides[static_cast<std::size_t>(fold->side)].pieces.front().ribbon;
            return fail(
                ErrorCode::Refused,
                "the surface folds at ({:.6g}, {:.6g}, {:.6g}), on the side of {}: its normal "
                "turns by {:.0f} deg from one sample to the next",
                fold->at.x(), fold->at.y(), fold->at.z(),
                name_of(hole_.loops.front().ribbons[static_cast<std::size_t>(nearest)]),
                degrees(fold->angle));
        }
        return fit;
    }

  private:
    const BorderModel& model_;
    const Hole& hole_;
    const Sides& sides_;
    double slope_weight_;
    std::vector<Sample> samples_;
    std::vector<Sample> measured_;
    Matrix3Xd across_;  ///< S_x at each sample as it should be, about

    /// The cross derivatives of the membrane through the border, in the tangent planes; where it
    /// stands upright on these, and without a membrane, of even layers.
    void find_across() {
        across_.resize(3, static_cast<Eigen::Index>(samples_.size()));
        Result<Matrix3Xd> points = Matrix3Xd();
        if (model_.membrane.size() > 0) {
            System system(model_.points);
            for (const Sample& sample : samples_) {
                for (int c = 0; c < 3; ++c) {
                    system.add(sample, Vector3d::Unit(c) * sample.row.weights.row(0),
                               sample.wanted.point[c], sample.weight);
                }
            }
            points = system.solve(model_.membrane, 1);
        }
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const RibbonPoint& w = samples_[i].wanted;
            const Vector3d outward = -w.inward;
            Vector3d x = model_.depth * outward;
            if (points && points->cols() > 0) {
                const Vector3d free = derivatives(samples_[i], *points).col(1);
                const Vector3d flat = free - w.normal * w.normal.dot(free);
                // As long as the free one: a dome's is bent down, not shortened.
                constexpr double kLeast = 0.2;
                const double along = flat.dot(outward);
                x = along > kLeast * free.norm() ? Vector3d(flat * (free.norm() / flat.norm()))
                                                 : Vector3d(free.norm() * outward);
            }
            across_.col(static_cast<Eigen::Index>(i)) = x;
        }
        lengthen();
    }

    /// None of them shorter than a share of the median on its ribbon.
    void lengthen() {
        std::map<const Ribbon*, std::vector<double>> lengths;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            lengths[samples_[i].ribbon].push_back(across_.col(static_cast<Eigen::Index>(i)).norm());
        }
        for (auto& [unused, own] : lengths) {
            std::sort(own.begin(), own.end());
        }
        constexpr double kLeast = 0.4;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const std::vector<double>& own = lengths[samples_[i].ribbon];
            auto x = across_.col(static_cast<Eigen::Index>(i));
            x *= std::max(1.0, kLeast * own[own.size() / 2] / x.norm());
        }
    }
};

}  // namespace

Result<BorderFit> fit_border(const BorderModel& model, const Hole& hole, const Sides& sides,
                             const Tolerance& limits) {
    Fitter fitter(model, hole, sides);
    Result<BorderFit> fit;
    double sense = 0.0;
    for (const double weight : kSenseWeights) {
        auto next = fitter.fit(weight, nullptr);
        if (!fit || (next && next->evenness > fit->evenness) || fit->points.size() == 0) {
            fit = std::move(next);
            sense = weight;
        }
        if (fit && fit->evenness >= kEven) {
            break;
        }
    }
    if (!fit || !fitter.curved() || fit->gap > limits.linear || fit->angle > limits.angular) {
        return fit;
    }
    constexpr int kSteps = 3;
    for (int step = 0; step < kSteps; ++step) {
        auto next = fitter.fit(sense, &fit->points);
        if (!next) {
            return next;
        }
        fit = std::move(next);
    }
    return fit;
}

}  // namespace suture::manifold
