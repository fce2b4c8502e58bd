#include "suture/detect/seams.h"

#include "suture/detect/edge_field.h"
#include "suture/detect/use_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace suture {

namespace {

/// Inner points of an edge at which its distance to others is taken; odd, so that one is the
/// middle.
constexpr int kProbes = 9;

/// The middle probe.
constexpr double kMiddle = 0.5;

constexpr double kFar = std::numeric_limits<double>::max();

/// The largest distance of an edge from one other edge.
double whole_distance(const EdgeField& field, int edge, int other) {
    double largest = 0.0;
    for (int i = 0; i < kProbes; ++i) {
        const NearPoint near = field.nearest(
            field.point(edge, (i + 0.5) / kProbes), [other](int e) { return e == other; }, kFar);
        largest = std::max(largest, near.distance);
    }
    return largest;
}

/// t in [0,1] along the use, of the point of the use nearest to p.
double nearest_fraction(const ShellGraph& graph, int use, const Eigen::Vector3d& p) {
    const UseGeometry geometry(graph.uses[use].edge, graph.faces[graph.uses[use].face]);
    double best = 0.0;
    double distance = kFar;
    for (int i = 0; i <= kChords; ++i) {
        const double t = static_cast<double>(i) / kChords;
        const double here = (geometry.at(t).point - p).norm();
        if (here < distance) {
            distance = here;
            best = t;
        }
    }
    return best;
}

}  // namespace

Eigen::Vector3d onward(const ShellGraph& graph, int use, double t) {
    const UseGeometry geometry(graph.uses[use].edge, graph.faces[graph.uses[use].face]);
    constexpr double kStep = 0.5 / kChords;
    const Eigen::Vector3d chord =
        geometry.at(std::min(1.0, t + kStep)).point - geometry.at(std::max(0.0, t - kStep)).point;
    return chord.cross(geometry.at(t).normal).normalized();
}

std::vector<EdgePartner> find_partners(const ShellGraph& graph, const std::vector<int>& uses) {
    std::vector<TopoDS_Edge> edges;
    edges.reserve(uses.size());
    for (const int use : uses) {
        edges.push_back(graph.uses[use].edge);
    }
    const EdgeField field(edges);
    const auto face = [&](int e) { return graph.uses[uses[e]].face; };
    std::vector<EdgePartner> result(uses.size());
    for (int e = 0; e < static_cast<int>(uses.size()); ++e) {
        EdgePartner& partner = result[e];
        partner.length = field.length(e);
        for (int i = 0; i < kProbes; ++i) {
            const NearPoint near = field.nearest(
                field.point(e, (i + 0.5) / kProbes),
                [&](int other) { return face(other) != face(e); }, kFar);
            partner.gap = std::max(partner.gap, near.distance);
            if (i == kProbes / 2 && near.edge >= 0) {
                partner.partner = uses[near.edge];
            }
        }
        const NearPoint own = field.nearest(
            field.point(e, kMiddle),
            [&](int other) { return other != e && face(other) == face(e); }, kFar);
        partner.own_gap = own.edge < 0 ? kFar : whole_distance(field, e, own.edge);
        if (partner.partner >= 0 && partner.gap <= kSeamShare * partner.length) {
            const Eigen::Vector3d middle = field.point(e, kMiddle);
            const double there = nearest_fraction(graph, partner.partner, middle);
            partner.folded =
                onward(graph, uses[e], kMiddle).dot(onward(graph, partner.partner, there)) >
                kSameSide;
        }
    }
    return result;
}

}  // namespace suture
