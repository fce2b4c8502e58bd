#include "suture/fill/mvs/samples.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::mvs {
namespace {

// Steps of the table from which parameters at equal arc lengths are read.
constexpr int kTable = 64;

// Parameters on a domain curve, which has the ribbon's own speed, at count + 1 equal arc lengths.
std::vector<double> equal_lengths(const DomainCurve& curve, int pieces) {
    std::vector<double> walked(kTable + 1, 0.0);
    for (int k = 0; k < kTable; ++k) {
        const double middle = (k + 0.5) / kTable;
        walked[static_cast<std::size_t>(k) + 1] =
            walked[static_cast<std::size_t>(k)] + curve.derivative(middle).norm();
    }
    std::vector<double> parameters;
    std::size_t k = 0;
    for (int i = 0; i <= pieces; ++i) {
        const double target = walked.back() * i / pieces;
        while (k + 2 < walked.size() && walked[k + 1] < target) {
            ++k;
        }
        const double t = (target - walked[k]) / (walked[k + 1] - walked[k]);
        parameters.push_back(std::clamp((static_cast<double>(k) + t) / kTable, 0.0, 1.0));
    }
    return parameters;
}

// The part of a side over which it bends towards a corner at which it does not end.
constexpr double kBend = 0.5;
// The part of the shorter side over which disagreeing normals at a corner are felt.
constexpr double kReach = 0.05;
// Share of the boundary's length that an inner point stands for.
constexpr double kInnerShare = 0.02;

// Falls from 1 at 0 to 0 at 1, with two derivatives zero at both ends.
double fade(double t) {
    return t >= 1.0 ? 0.0 : 1.0 - t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

// One side with what its corners do to it.
struct Side {
    const Ribbon& ribbon;
    Eigen::Vector3d at_start, at_end;     // shifts towards the corners
    double mismatch_start, mismatch_end;  // of normals, in radians
    double reach_start, reach_end;        // arc length over which that is felt
    double length;

    [[nodiscard]] Eigen::Vector3d shift(double s) const {
        return fade(s / kBend) * at_start + fade((1.0 - s) / kBend) * at_end;
    }
    // walked: arc length from the start.
    [[nodiscard]] double unmet(double walked) const {
        const double from_start = std::max(0.0, 1.0 - walked / reach_start);
        const double from_end = std::max(0.0, 1.0 - (length - walked) / reach_end);
        return 0.5 * std::max(from_start * mismatch_start, from_end * mismatch_end);
    }
};

void sample_side(const Side& side, const DomainCurve& curve, const Scale& scale, int pieces,
                 bool ends, BoundarySample sample, std::vector<BoundarySample>& samples) {
    const std::vector<double> steps = equal_lengths(curve, ends ? pieces : 2 * pieces);
    const std::size_t stride = ends ? 1 : 2;
    for (std::size_t k = stride - 1; k < steps.size(); k += stride) {
        const double s = steps[k];
        const RibbonPoint p = side.ribbon.at(s);
        const bool corner = ends && (k == 0 || k + 1 == steps.size());
        const Eigen::Vector2d along = curve.derivative(s).normalized();
        sample.s = s;
        sample.length = side.length / scale.length / pieces * (corner ? 0.5 : 1.0);
        sample.uv = curve.at(s) / scale.length;
        sample.across = Eigen::Vector2d(-along.y(), along.x());
        sample.point = (p.point + side.shift(s) - scale.centre) / scale.length;
        sample.normal = p.normal;
        sample.inward = p.inward;
        sample.curvature = p.curvature * scale.length;
        sample.continuity = side.ribbon.continuity;
        const double walked =
            side.length * static_cast<double>(k) / static_cast<double>(steps.size() - 1);
        sample.unmet_angle = sample.continuity >= Continuity::G1 ? side.unmet(walked) : 0.0;
        samples.push_back(sample);
    }
}

}  // namespace

std::vector<Corner> corners_of(const RibbonLoop& loop) {
    const std::size_t n = loop.ribbons.size();
    std::vector<Corner> corners(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Ribbon& ribbon = loop.ribbons[i];
        const Ribbon& previous = loop.ribbons[(i + n - 1) % n];
        const RibbonPoint before = previous.at(1.0);
        const RibbonPoint after = ribbon.at(0.0);
        corners[i].point = 0.5 * (before.point + after.point);
        if (std::min(previous.continuity, ribbon.continuity) >= Continuity::G1) {
            corners[i].mismatch = std::atan2(before.normal.cross(after.normal).norm(),
                                             before.normal.dot(after.normal));
        }
    }
    return corners;
}

std::vector<BoundarySample> sample_boundary(const Hole& hole, const Domain& domain,
                                            const Scale& scale, double spacing, int least,
                                            bool ends) {
    std::vector<BoundarySample> samples;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        const RibbonLoop& loop = hole.loops[l];
        const DomainLoop& laid = domain.loops[l];
        const std::vector<Corner> corners = corners_of(loop);
        const std::size_t n = loop.ribbons.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Ribbon& ribbon = loop.ribbons[i];
            const std::size_t next = (i + 1) % n;
            const double length = laid.lengths[i];
            const Side side{ribbon,
                            corners[i].point - ribbon.at(0.0).point,
                            corners[next].point - ribbon.at(1.0).point,
                            corners[i].mismatch,
                            corners[next].mismatch,
                            kReach * std::min(length, laid.lengths[(i + n - 1) % n]),
                            kReach * std::min(length, laid.lengths[next]),
                            length};
            BoundarySample sample;
            sample.loop = static_cast<int>(l);
            sample.ribbon = static_cast<int>(i);
            const int pieces =
                std::max(least, static_cast<int>(std::ceil(length / scale.length / spacing)));
            sample_side(side, laid.curves[i], scale, pieces, ends, sample, samples);
        }
    }
    for (std::size_t k = 0; k < hole.through.size(); ++k) {
        BoundarySample sample;
        sample.loop = -1;
        sample.length = kInnerShare;
        sample.uv = domain.through[k] / scale.length;
        sample.across.setZero();
        sample.point = (hole.through[k] - scale.centre) / scale.length;
        sample.normal.setZero();
        sample.inward.setZero();
        sample.curvature.setZero();
        sample.continuity = Continuity::G0;
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace suture::mvs
