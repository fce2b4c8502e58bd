#include "suture/fill/mvs/samples.h"

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

}  // namespace

std::vector<BoundarySample> sample_boundary(const RibbonLoop& loop, const Layout& layout,
                                            const Scale& scale, double spacing, int least,
                                            bool ends) {
    std::vector<BoundarySample> samples;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        const Ribbon& ribbon = loop.ribbons[i];
        const DomainCurve& curve = layout.curves[i];
        const double length = layout.lengths[i] / scale.length;
        const int pieces = std::max(least, static_cast<int>(std::ceil(length / spacing)));
        const std::vector<double> steps = equal_lengths(curve, ends ? pieces : 2 * pieces);
        const std::size_t stride = ends ? 1 : 2;
        for (std::size_t k = stride - 1; k < steps.size(); k += stride) {
            const double s = steps[k];
            const RibbonPoint p = ribbon.at(s);
            const bool corner = ends && (k == 0 || k + 1 == steps.size());
            const Eigen::Vector2d along = curve.derivative(s).normalized();
            BoundarySample sample;
            sample.ribbon = static_cast<int>(i);
            sample.s = s;
            sample.length = length / pieces * (corner ? 0.5 : 1.0);
            sample.uv = curve.at(s) / scale.length;
            sample.across = Eigen::Vector2d(-along.y(), along.x());
            sample.point = (p.point - scale.centre) / scale.length;
            sample.normal = p.normal;
            sample.inward = p.inward;
            sample.curvature = p.curvature * scale.length;
            sample.continuity = ribbon.continuity;
            samples.push_back(sample);
        }
    }
    return samples;
}

}  // namespace suture::mvs
