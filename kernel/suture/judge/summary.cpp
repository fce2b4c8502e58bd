#include "suture/judge/summary.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace suture {

bool is_near_miss(const EdgeContinuity& edge, const Profile& profile) {
    return edge.max_gap > profile.tolerance.linear ||
           (edge.edge_class != EdgeClass::Sharp && edge.max_angle > profile.tolerance.angular);
}

bool is_near_miss(const KnotLine& line, const Profile& profile) {
    return line.max_gap > profile.tolerance.linear ||
           (line.max_angle > profile.tolerance.angular && line.max_angle <= profile.sharp);
}

double severity(const EdgeContinuity& edge, const Profile& profile) {
    const double angle = edge.edge_class == EdgeClass::Sharp ? 0.0 : edge.max_angle;
    return std::max(edge.max_gap / profile.tolerance.linear, angle / profile.tolerance.angular);
}

std::vector<EdgeContinuity> worst_first(std::vector<EdgeContinuity> edges, const Profile& profile) {
    const auto rank = [&](const EdgeContinuity& edge) {
        const int group = edge.samples == 0                     ? 0
                          : is_near_miss(edge, profile)         ? 1
                          : edge.edge_class == EdgeClass::Sharp ? 3
                                                                : 2;
        return std::tuple(group, -severity(edge, profile), -edge.max_angle);
    };
    std::ranges::stable_sort(edges, std::less(), rank);
    return edges;
}

std::string fault_of(const EdgeContinuity& edge, const Profile& profile) {
    std::vector<std::string> parts;
    if (edge.samples == 0) {
        parts.emplace_back("could not be measured");
    }
    const Tolerance& limit = profile.tolerance;
    if (edge.max_gap > limit.linear) {
        parts.push_back(
            fmt::format("gap {:.4g} mm, allowed are {:.4g}", edge.max_gap, limit.linear));
    }
    if (edge.edge_class != EdgeClass::Sharp && edge.max_angle > limit.angular) {
        parts.push_back(fmt::format("angle {:.4g} deg, neither tangent ({:.4g}) nor sharp ({:.4g})",
                                    degrees(edge.max_angle), degrees(limit.angular),
                                    degrees(profile.sharp)));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

CheckSummary summarise(const ContinuityReport& report, const std::vector<KnotLine>& knots,
                       const Profile& profile) {
    CheckSummary summary;
    for (const EdgeContinuity& edge : report.edges) {
        ++summary.edges;
        const std::array<int*, 5> counters{&summary.sharp, &summary.g0, &summary.g1, &summary.g2,
                                           &summary.g3};
        ++*counters.at(static_cast<std::size_t>(edge.edge_class));
        summary.near_misses += is_near_miss(edge, profile) ? 1 : 0;
        summary.unmeasured += edge.samples > 0 ? 0 : 1;
        summary.max_gap = std::max(summary.max_gap, edge.max_gap);
        if (edge.edge_class != EdgeClass::Sharp) {
            summary.max_angle = std::max(summary.max_angle, edge.max_angle);
        }
    }
    for (const KnotLine& line : knots) {
        ++summary.knot_lines;
        summary.knot_near_misses += is_near_miss(line, profile) ? 1 : 0;
    }
    return summary;
}

}  // namespace suture
