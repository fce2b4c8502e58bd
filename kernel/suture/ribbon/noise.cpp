#include "suture/ribbon/noise.h"

#include "suture/occ/convert.h"
#include "suture/occ/handle.h"

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include <algorithm>

namespace suture {
namespace {

constexpr int kSamples = 24;

double noise_along(const BoundaryEdge& edge, const Ribbon& ribbon) {
    double first = 0.0;
    double last = 0.0;
    const occ::Handle<Geom_Curve> curve = BRep_Tool::Curve(edge.edge, first, last);
    double noise = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
        const double s = static_cast<double>(k) / kSamples;
        const double t = ribbon.first + s * (ribbon.last - ribbon.first);
        noise = std::max(noise, (occ::from_occ(curve->Value(t)) - ribbon.at(s).point).norm());
    }
    return noise;
}

}  // namespace

std::vector<double> noise_of_sides(const std::vector<BoundaryLoop>& loops, const Hole& hole) {
    std::vector<double> noise;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].edges.size(); ++i) {
            noise.push_back(noise_along(loops[l].edges[i], hole.loops[l].ribbons[i]));
        }
    }
    return noise;
}

double measure_noise(const std::vector<BoundaryLoop>& loops, const Hole& hole) {
    const std::vector<double> noise = noise_of_sides(loops, hole);
    return noise.empty() ? 0.0 : std::ranges::max(noise);
}

}  // namespace suture
