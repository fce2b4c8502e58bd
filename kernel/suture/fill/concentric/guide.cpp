#include "suture/fill/concentric/guide.h"

#include "suture/fill/concentric/fit.h"
#include "suture/fill/mvs.h"

namespace suture::concentric {
namespace {

constexpr int kDegree = 3;

/// The loop that the axis is of need not be the sides' own to the last digit: as a share of its
/// size.
constexpr double kAccuracy = 1e-5;

ClosedSpline loop_of(const std::vector<TrimCurve>& sides) {
    Eigen::Vector2d low = sides.front()(0.0);
    Eigen::Vector2d high = low;
    for (const TrimCurve& side : sides) {
        for (const double s : {0.0, 0.25, 0.5, 0.75}) {
            low = low.cwiseMin(side(s));
            high = high.cwiseMax(side(s));
        }
    }
    std::vector<SplineCurve> curves;
    for (const TrimCurve& side : sides) {
        const auto i = static_cast<double>(curves.size());
        const auto at = [&](double s) -> Eigen::VectorXd { return side(s - i); };
        curves.push_back(
            fit_curve(at, {{i}, {i + 1.0}}, kDegree, kAccuracy * (high - low).norm()).curve);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Eigen::MatrixXd& poles = curves[i].poles;
        poles.col(poles.cols() - 1) = curves[(i + 1) % curves.size()].poles.col(0);
    }
    return closed_from(curves);
}

}  // namespace

Result<Guide> guide_of(const Hole& hole, const FillOptions& options) {
    FillOptions plain = options;
    plain.own.clear();
    auto fill = fill_mvs(hole, plain);
    if (!fill) {
        return tl::unexpected(fill.error());
    }
    const Patch& patch = fill->patches.front();
    Guide guide;
    guide.surface = std::get<SplineSurface>(patch.surface);
    for (const EdgeUse& use : patch.wires.front()) {
        guide.sides.push_back(use.at);
    }
    guide.loop = loop_of(guide.sides);
    guide.notes = std::move(fill->notes);
    return guide;
}

}  // namespace suture::concentric
