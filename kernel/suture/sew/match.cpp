#include "suture/sew/match.h"

#include "suture/detect/seams.h"
#include "suture/detect/use_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace suture {

namespace {

/// Where the nearest point is not near the one of the same share of the parameters.
constexpr int kGuesses = 16;

/// Edges shorter than this many tolerances can lose their two ends to one place.
constexpr double kShort = 4.0;

/// Both pcurves of a slit lie on each other, to this share of the edge's extent in parameters;
/// those of a surface that closes on itself lie a period apart.
constexpr double kSlit = 1e-3;

}  // namespace

struct SewMatcher::Candidate {
    int a = 0;
    int b = 0;
    bool same_way = false;
    double gap = 0.0;
    double limit = 0.0;
    int rank = 0;  ///< 0: of one shell, 1: of one compound, 2: neither
    double cosine = 0.0;
};

SewMatcher::SewMatcher(const ShellGraph& graph, const std::vector<FreeEdge>& edges, Places& places)
    : graph_(graph),
      edges_(edges),
      places_(places),
      cuts_(edges.size()),
      matched_(edges.size(), false) {}

std::vector<int> SewMatcher::unmatched_uses() const {
    std::vector<int> uses;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (!matched_[e]) {
            uses.push_back(edges_[e].use);
        }
    }
    return uses;
}

double SewMatcher::limit_of(int a, int b, const SewLimits& limits) const {
    if (!by_accuracy_) {
        return limits.tolerance;
    }
    const double accuracy = kAccuracy * (edges_[a].accuracy + edges_[b].accuracy);
    const double narrow = kSeamShare * std::min(edges_[a].length, edges_[b].length);
    return std::max(limits.tolerance, std::min(accuracy, narrow));
}

double SewMatcher::fraction(const FreeEdge& edge, double parameter) const {
    const double t = (parameter - edge.first()) / (edge.last() - edge.first());
    return graph_.uses[edge.use].edge.Orientation() == TopAbs_REVERSED ? 1.0 - t : t;
}

bool SewMatcher::leave_to_one_side(int a, double at_a, int b, double at_b, double* cosine) const {
    const double value = onward(graph_, edges_[a].use, fraction(edges_[a], at_a))
                             .dot(onward(graph_, edges_[b].use, fraction(edges_[b], at_b)));
    if (cosine != nullptr) {
        *cosine = value;
    }
    return value > kSameSide;
}

double SewMatcher::gap_between(const SewPiece& a, const SewPiece& b, bool same_way,
                               double limit) const {
    double largest = 0.0;
    for (int i = 0; i < kSewProbes; ++i) {
        const double t = (i + 0.5) / kSewProbes;
        const Eigen::Vector3d p = edges_[a.edge].point(a.first + t * (a.last - a.first));
        const BRepAdaptor_Curve& curve = edges_[b.edge].curve;
        const double s = same_way ? t : 1.0 - t;
        FootPoint foot = foot_point(curve, b.first, b.last, p, b.first + s * (b.last - b.first));
        for (int g = 0; g < kGuesses && foot.distance > limit; ++g) {
            const double guess = b.first + (g + 0.5) / kGuesses * (b.last - b.first);
            const FootPoint other = foot_point(curve, b.first, b.last, p, guess);
            foot = other.distance < foot.distance ? other : foot;
        }
        largest = std::max(largest, foot.distance);
        if (largest > limit) {
            break;
        }
    }
    return largest;
}

bool SewMatcher::is_slit(const SewPiece& a, const SewPiece& b, bool same_way) const {
    const auto geometry = [&](const SewPiece& piece) {
        const Coedge& use = graph_.uses[edges_[piece.edge].use];
        return UseGeometry(use.edge, graph_.faces[use.face]);
    };
    const auto uv = [&](const SewPiece& piece, double t) {
        return geometry(piece).uv(
            fraction(edges_[piece.edge], piece.first + t * (piece.last - piece.first)));
    };
    constexpr double kAt = 0.4;
    const double extent = (uv(a, 1.0) - uv(a, 0.0)).norm() + (uv(a, kAt) - uv(a, 0.0)).norm();
    return (uv(a, kAt) - uv(b, same_way ? kAt : 1.0 - kAt)).norm() <= kSlit * extent;
}

bool SewMatcher::bound_two_solids(const FreeEdge& a, const FreeEdge& b) const {
    const int one = graph_.solid[a.face];
    const int other = graph_.solid[b.face];
    return one >= 0 && other >= 0 && one != other;
}

std::vector<std::pair<int, int>> SewMatcher::short_edges(double limit) const {
    std::vector<std::pair<int, int>> ends;
    for (const FreeEdge& edge : edges_) {
        if (edge.ends[0] != edge.ends[1] &&
            edge.length <= kShort * places_.reach(edge.ends[0], edge.ends[1], limit)) {
            ends.emplace_back(edge.ends[0], edge.ends[1]);
        }
    }
    return ends;
}

std::vector<SewPiece> SewMatcher::pieces() const {
    std::vector<SewPiece> result;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
        const FreeEdge& edge = edges_[e];
        if (matched_[e]) {
            continue;
        }
        SewPiece piece{e, edge.first(), edge.first(), edge.ends[0], edge.ends[0]};
        for (const Cut& cut : cuts_[e]) {
            if (places_.of(cut.point) == places_.of(piece.start) ||
                places_.of(cut.point) == places_.of(edge.ends[1])) {
                continue;
            }
            piece.last = cut.parameter;
            piece.end = cut.point;
            result.push_back(piece);
            piece.first = piece.last;
            piece.start = piece.end;
        }
        piece.last = edge.last();
        piece.end = edge.ends[1];
        result.push_back(piece);
    }
    return result;
}

void SewMatcher::match(const std::vector<SewPiece>& pieces, const SewLimits& limits) {
    std::map<std::pair<int, int>, std::vector<int>> together;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        const auto ends = std::minmax({places_.of(pieces[i].start), places_.of(pieces[i].end)});
        together[ends].push_back(i);
    }
    std::vector<bool> taken(pieces.size(), false);
    for (const auto& [ends, members] : together) {
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t k = i + 1; k < members.size(); ++k) {
                Candidate next{members[i], members[k]};
                const SewPiece& a = pieces[next.a];
                const SewPiece& b = pieces[next.b];
                if (a.edge == b.edge) {
                    continue;
                }
                next.same_way = places_.of(a.start) == places_.of(b.start);
                next.limit = limit_of(a.edge, b.edge, limits);
                next.gap = gap_between(a, b, next.same_way, next.limit);
                if (ends.first == ends.second) {
                    const double back = gap_between(a, b, false, next.limit);
                    const double on = gap_between(a, b, true, next.limit);
                    const Eigen::Vector3d pa =
                        edges_[a.edge].point(a.first + 0.25 * (a.last - a.first));
                    const auto at_b = [&](double t) {
                        return edges_[b.edge].point(b.first + t * (b.last - b.first));
                    };
                    next.same_way = (pa - at_b(0.25)).norm() < (pa - at_b(0.75)).norm();
                    next.gap = std::min(back, on);
                }
                if (next.gap > next.limit) {
                    continue;
                }
                const FreeEdge& one = edges_[a.edge];
                const FreeEdge& other = edges_[b.edge];
                if (bound_two_solids(one, other) ||
                    (one.face == other.face && is_slit(a, b, next.same_way))) {
                    continue;
                }
                next.rank = graph_.component[one.face] == graph_.component[other.face] ? 0
                            : one.group == other.group                                 ? 1
                                                                                       : 2;
                candidates.push_back(next);
            }
        }
        for (Candidate& next : candidates) {
            const SewPiece& a = pieces[next.a];
            const SewPiece& b = pieces[next.b];
            if (candidates.size() > 1 || next.gap > limits.wall) {
                const bool folded = leave_to_one_side(a.edge, 0.5 * (a.first + a.last), b.edge,
                                                      0.5 * (b.first + b.last), &next.cosine);
                if (folded && next.gap > limits.wall) {
                    next.gap = std::numeric_limits<double>::max();
                }
            }
        }
        std::sort(candidates.begin(), candidates.end(),
                  [&](const Candidate& a, const Candidate& b) {
                      const auto key = [&](const Candidate& c) {
                          return std::make_tuple(c.rank, c.gap > limits.wall, c.cosine, c.gap);
                      };
                      return key(a) < key(b);
                  });
        for (const Candidate& next : candidates) {
            if (next.gap > next.limit || taken[next.a] || taken[next.b]) {
                continue;
            }
            taken[next.a] = taken[next.b] = true;
            pairs_.push_back({pieces[next.a], pieces[next.b], next.same_way, next.gap});
        }
    }
    std::vector<bool> open(edges_.size(), false);
    std::vector<bool> seen(edges_.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        seen[pieces[i].edge] = true;
        open[pieces[i].edge] = open[pieces[i].edge] || !taken[i];
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        matched_[e] = matched_[e] || (seen[e] && !open[e]);
    }
}

void SewMatcher::match_whole(const SewLimits& limits) {
    places_.unite(places_.near(limits.tolerance), short_edges(limits.tolerance));
    match(pieces(), limits);
}

}  // namespace suture
