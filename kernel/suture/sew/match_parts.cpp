#include "suture/detect/edge_field.h"
#include "suture/detect/seams.h"
#include "suture/sew/match.h"

#include <algorithm>
#include <map>
#include <utility>

namespace suture {

namespace {

/// Vertices may lie farther apart than edges: at the corner of three gaps by the square root of 3.
constexpr double kCorners = 2.0;

/// Edges that leave a place together and are looked at.
constexpr int kMostTogether = 4;

}  // namespace

void SewMatcher::find_cuts(const SewLimits& limits, std::vector<Places::Link>& links) {
    std::vector<int> rest;
    std::vector<TopoDS_Edge> shapes;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
        if (!matched_[e]) {
            rest.push_back(e);
            shapes.push_back(graph_.uses[edges_[e].use].edge);
        }
    }
    if (rest.empty()) {
        return;
    }
    const EdgeField field(shapes);
    const double limit = kCorners * limits.tolerance;
    int coarsest = rest.front();
    for (const int e : rest) {
        coarsest = edges_[e].accuracy > edges_[coarsest].accuracy ? e : coarsest;
    }
    for (int i = 0; i < static_cast<int>(rest.size()); ++i) {
        const FreeEdge& edge = edges_[rest[i]];
        const double widest = std::max(
            limits.tolerance, std::min(kAccuracy * (edge.accuracy + edges_[coarsest].accuracy),
                                       kSeamShare * edge.length));
        for (const int end : {0, 1}) {
            const double t = end == 0 ? 0.5 / kSewProbes : 1.0 - 0.5 / kSewProbes;
            const double probe = edge.first() + t * (edge.last() - edge.first());
            const Eigen::Vector3d here = edge.point(probe);
            const int point = edge.ends[end];
            const Eigen::Vector3d corner = places_.point(point);
            std::vector<int> seen{i};
            for (int n = 0; n < kMostTogether; ++n) {
                const NearPoint beside = field.nearest(
                    here,
                    [&](int f) { return std::find(seen.begin(), seen.end(), f) == seen.end(); },
                    widest);
                if (beside.edge < 0) {
                    break;
                }
                const int f = beside.edge;
                seen.push_back(f);
                if (beside.distance > limit_of(rest[i], rest[f], limits)) {
                    continue;
                }
                const FreeEdge& other = edges_[rest[f]];
                const NearPoint foot = field.nearest(
                    corner, [&](int e) { return e == f; }, places_.reach(point, point, limit));
                if (foot.edge < 0 ||
                    (beside.distance > limits.wall &&
                     leave_to_one_side(rest[i], probe, rest[f], beside.parameter, nullptr))) {
                    continue;
                }
                const double to_start = (places_.point(other.ends[0]) - corner).norm();
                const double to_end = (places_.point(other.ends[1]) - corner).norm();
                const int there = other.ends[to_start <= to_end ? 0 : 1];
                if (std::min(to_start, to_end) <= places_.reach(point, there, limit)) {
                    links.push_back({point, there, std::min(to_start, to_end)});
                } else {
                    const int cut = places_.add(other.point(foot.parameter), {}, 0.0);
                    cuts_[rest[f]].push_back({foot.parameter, cut});
                    links.push_back({point, cut, foot.distance});
                }
            }
        }
    }
    for (std::vector<Cut>& cuts : cuts_) {
        std::sort(cuts.begin(), cuts.end(),
                  [](const Cut& a, const Cut& b) { return a.parameter < b.parameter; });
        for (std::size_t k = 1; k < cuts.size(); ++k) {
            const double apart =
                (places_.point(cuts[k].point) - places_.point(cuts[k - 1].point)).norm();
            if (apart <= limit) {
                links.push_back({cuts[k - 1].point, cuts[k].point, apart});
            }
        }
    }
}

void SewMatcher::collapse(int edge) {
    places_.unite(edges_[edge].ends[0], edges_[edge].ends[1]);
    collapsed_.push_back(edge);
    matched_[edge] = true;
}

bool SewMatcher::collapse_short(const SewLimits& limits) {
    const std::vector<SewPiece> open = pieces();
    std::map<int, std::vector<const SewPiece*>> at_place;
    Places trial = places_;  // as if all edges that are short enough were points
    std::vector<int> candidates;
    for (const SewPiece& piece : open) {
        at_place[places_.of(piece.start)].push_back(&piece);
        at_place[places_.of(piece.end)].push_back(&piece);
    }
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
        const auto& ends = edges_[e].ends;
        if (!matched_[e] && places_.of(ends[0]) != places_.of(ends[1]) &&
            edges_[e].length <= places_.reach(ends[0], ends[1], limits.tolerance)) {
            candidates.push_back(e);
            trial.unite(ends[0], ends[1]);
        }
    }
    const auto meet = [&](const SewPiece& p, int at_p, const SewPiece& q, int at_q) {
        const bool from_start = places_.of(p.start) == at_p;
        const bool q_from_start = places_.of(q.start) == at_q;
        return trial.of(from_start ? p.end : p.start) == trial.of(q_from_start ? q.end : q.start) &&
               gap_between(p, q, from_start == q_from_start, limit_of(p.edge, q.edge, limits)) <=
                   limit_of(p.edge, q.edge, limits);
    };
    bool any = false;
    for (const int e : candidates) {
        const int a = places_.of(edges_[e].ends[0]);
        const int b = places_.of(edges_[e].ends[1]);
        bool helps = false;
        for (const SewPiece* p : at_place[a]) {
            for (const SewPiece* q : at_place[b]) {
                helps = helps ||
                        (p->edge != q->edge && p->edge != e && q->edge != e && meet(*p, a, *q, b));
            }
        }
        if (helps && a != b) {
            collapse(e);
            any = true;
        }
    }
    return any;
}

void SewMatcher::collapse_specks(const SewLimits& limits) {
    // edges without a partner that hang together
    Places chains = places_;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (!matched_[e]) {
            chains.unite(edges_[e].ends[0], edges_[e].ends[1]);
        }
    }
    std::map<int, std::vector<int>> hang_together;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
        if (!matched_[e]) {
            hang_together[chains.of(edges_[e].ends[0])].push_back(e);
        }
    }
    for (const auto& [place, edges] : hang_together) {
        const bool speck =
            edges.size() > 1 && std::all_of(edges.begin(), edges.end(), [&](int e) {
                const auto& ends = edges_[e].ends;
                return ends[0] != ends[1] &&
                       edges_[e].length <= places_.reach(ends[0], ends[1], limits.tolerance);
            });
        if (speck) {
            std::for_each(edges.begin(), edges.end(), [this](int e) { collapse(e); });
        }
    }
}

void SewMatcher::match_parts(const SewLimits& limits) {
    by_accuracy_ = true;
    std::vector<Places::Link> links;
    find_cuts(limits, links);
    places_.unite(std::move(links), short_edges(limits.tolerance));
    const std::size_t before = pairs_.size();
    match(pieces(), limits);
    collapse_specks(limits);
    if (collapse_short(limits)) {
        // pieces of edges that are matched in part are matched anew, with the others
        std::vector<SewPair> kept;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (i < before || (matched_[pairs_[i].kept.edge] && matched_[pairs_[i].gone.edge])) {
                kept.push_back(pairs_[i]);
            }
        }
        pairs_ = std::move(kept);
        match(pieces(), limits);
    }
}

}  // namespace suture
