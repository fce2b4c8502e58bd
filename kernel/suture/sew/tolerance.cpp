#include "suture/sew/tolerance.h"

#include <algorithm>
#include <limits>

namespace suture {

namespace {

/// Sewing stays this many times below the smallest feature: the shortest edge, the narrowest slot,
/// the thinnest wall.
constexpr double kBelowFeatures = 4.0;

/// Above the widest gap that is to be closed, since gaps are measured at some points of an edge.
constexpr double kAboveGaps = 1.25;

}  // namespace

double choose_tolerance(const std::vector<EdgePartner>& partners, double floor) {
    double feature = std::numeric_limits<double>::max();
    const auto consider = [&](double size) {
        feature = size > floor ? std::min(feature, size) : feature;
    };
    for (const EdgePartner& edge : partners) {
        consider(edge.length);
        if (!is_fold(edge)) {
            consider(edge.own_gap);
        }
        if (edge.folded && !is_seam(edge)) {
            consider(edge.gap);
        }
    }
    const double most = feature / kBelowFeatures;
    double widest = 0.0;
    for (const EdgePartner& edge : partners) {
        if (is_seam(edge) && kAboveGaps * edge.gap <= most) {
            widest = std::max(widest, edge.gap);
        }
    }
    return std::max(floor, std::min(most, kAboveGaps * widest));
}

}  // namespace suture
