#include "suture/fill/manifold/border_fit.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/border_samples.h"
#include "suture/fill/manifold/border_system.h"
#include "suture/fill/manifold/convex_map.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace suture::manifold {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// An angle of 1 counts as much as a distance of this share of the diameter.
constexpr double kAngleWeight = 0.05;
/// A relative error of the curvature of 1 counts as much as an angle of this.
constexpr double kCurvatureWeight = 0.1;
/// Where the surface folds, the cross derivative is held near that of a surface that does not,
/// weakly against the angle.
constexpr double kSenseWeights[] = {0.0, 1e-3, 1e-2, 1e-1, 0.3};
/// Places on the guide count this much against the border, which has the last word by the method of
/// multipliers; and the energy, which only settles what neither of them determines, this much.
constexpr double kGuideWeight = 1e-4;
constexpr double kGuidedEnergy = 1e-4;

/// A cross derivative that falls below this share of its median is mended like a fold.
constexpr double kEven = 0.1;

/// Adds what one sample asks for. before: the points of the step before, for G2.
void add_sample(BorderSystem& system, const Sample& sample, double slope_weight,
                const Matrix3Xd* before) {
    const RibbonPoint& w = sample.wanted;
    system.add_point(sample.row, w.point, sample.weight);
    if (sample.ribbon->continuity < Continuity::G1) {
        return;
    }
    system.add(sample.row, w.normal * sample.row.weights.row(1), 0.0,
               sample.weight * slope_weight * slope_weight);
    if (sample.ribbon->continuity < Continuity::G2 || before == nullptr) {
        return;
    }
    // n . S_xx - II(S_x, S_x), about the step before.
    const Vector3d x = derivatives(sample, *before).col(1);
    const Vector3d slope = 2.0 * w.curvature * x;
    const double bend = kCurvatureWeight * slope_weight;
    system.add(sample.row, w.normal * sample.row.weights.row(3) - slope * sample.row.weights.row(1),
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
        BorderSystem system(model_.points);
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const Sample& sample = samples_[i];
            add_sample(system, sample, slope_weight_, before);
            for (int c = 0; sense > 0.0 && c < 3; ++c) {
                const double weight = sense * slope_weight_;
                system.add(sample.row, Vector3d::Unit(c) * sample.row.weights.row(1),
                           across_(c, static_cast<Eigen::Index>(i)),
                           sample.weight * weight * weight, BorderSystem::Kind::Wish);
            }
        }
        for (std::size_t i = 0; i < inner_.size(); ++i) {
            system.add_point(inner_[i], aims_[i], kGuideWeight / static_cast<double>(inner_.size()),
                             BorderSystem::Kind::Wish);
        }
        auto points = inner_.empty() ? system.solve(model_.energy)
                                     : system.solve(kGuidedEnergy * model_.energy);
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
        for (std::size_t i = 0; i < inner_.size(); ++i) {
            fit.from_guide =
                std::max(fit.from_guide, (point_of(inner_[i], fit.points) - aims_[i]).norm());
        }
        return fit;
    }

    /// Wishes each place to be where the guide has it from now on.
    [[nodiscard]] Result<void> follow(const GuideSurface& guide) {
        // Over a regular polygon: convex, so that neither map folds.
        BorderSystem system(model_.points);
        for (const Sample& sample : samples_) {
            Vector3d at = Vector3d::Zero();
            at.head<2>() = on_polygon(sample.side, sample.share);
            system.add_point(sample.row, at, sample.weight);
        }
        const auto flat = system.solve(model_.membrane);
        const auto region = region_of(guide);
        if (!flat || !region) {
            return tl::unexpected(flat ? region.error() : flat.error());
        }
        for (BorderRow& row : model_.inner()) {
            const auto at = region->inverse(point_of(row, *flat).head<2>());
            if (at) {
                inner_.push_back(std::move(row));
                aims_.push_back(evaluate(guide.surface, at->x(), at->y()).point);
            }
        }
        return {};
    }

    /// Wishes nothing any more.
    void leave_guide() {
        inner_.clear();
        aims_.clear();
    }

  private:
    const BorderModel& model_;
    const Hole& hole_;
    const Sides& sides_;
    double slope_weight_;
    std::vector<Sample> samples_;
    std::vector<Sample> measured_;
    Matrix3Xd across_;              ///< S_x at each sample as it should be, about
    std::vector<BorderRow> inner_;  ///< places inside, with a guide
    std::vector<Vector3d> aims_;    ///< where they should be

    /// A place on the border of the regular polygon of as many sides.
    [[nodiscard]] Eigen::Vector2d on_polygon(std::size_t side, double share) const {
        const auto count = static_cast<double>(sides_.sides.size());
        const auto corner = [&](double number) {
            const double angle = 2.0 * kPi * number / count;
            return Eigen::Vector2d(std::cos(angle), std::sin(angle));
        };
        const auto m = static_cast<double>(side);
        return (1.0 - share) * corner(m) + share * corner(m + 1.0);
    }

    /// From the guide's domain to the polygon.
    [[nodiscard]] Result<ConvexMap> region_of(const GuideSurface& guide) const {
        std::vector<Eigen::Vector2d> boundary;
        std::vector<Eigen::Vector2d> images;
        // Enough that those at the border are shorter than the knots' intervals.
        constexpr int kAround = 768;
        std::size_t pieces = 0;
        for (const Side& side : sides_.sides) {
            pieces += side.pieces.size();
        }
        const int segments = std::max(24, kAround / static_cast<int>(pieces));
        for (std::size_t m = 0; m < sides_.sides.size(); ++m) {
            for (const Piece& piece : sides_.sides[m].pieces) {
                for (int k = 0; k < segments; ++k) {
                    // Closer towards the ends, where corners may be.
                    const double s = 0.5 * (1.0 - std::cos(kPi * k / segments));
                    boundary.push_back(guide.trims[static_cast<std::size_t>(piece.ribbon)](s));
                    images.push_back(
                        on_polygon(m, piece.from + (piece.to - piece.from) * piece.along(s)));
                }
            }
        }
        return ConvexMap::make(boundary, images);
    }

    [[nodiscard]] static Vector3d point_of(const BorderRow& row, const Matrix3Xd& points) {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t k = 0; k < row.points.size(); ++k) {
            sum += row.weights(0, static_cast<Eigen::Index>(k)) * points.col(row.points[k]);
        }
        return sum;
    }

    /// The cross derivatives of the membrane through the border, in the tangent planes; where it
    /// stands upright on these, and without a membrane, of even layers.
    void find_across() {
        across_.resize(3, static_cast<Eigen::Index>(samples_.size()));
        Result<Matrix3Xd> points = Matrix3Xd();
        if (model_.membrane.size() > 0) {
            BorderSystem system(model_.points);
            for (const Sample& sample : samples_) {
                system.add_point(sample.row, sample.wanted.point, sample.weight);
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
                             const Tolerance& limits, const GuideSurface* guide) {
    Fitter fitter(model, hole, sides);
    Result<BorderFit> fit;
    double sense = 0.0;
    std::string left_guide;
    if (guide != nullptr) {
        const auto follows = fitter.follow(*guide);
        fit = follows ? fitter.fit(sense, nullptr) : tl::unexpected(follows.error());
        left_guide = fit ? "" : fit.error().message;
    }
    if (!fit || fit->from_guide < 0.0) {
        fitter.leave_guide();
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
    }
    if (fit) {
        fit->left_guide = left_guide;
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
        fit->left_guide = left_guide;
    }
    return fit;
}

}  // namespace suture::manifold
