#include "suture/fill/concentric/retraction.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;

/// The share of the free parameters beside a reflex vertex that its own cell gets at first, and
/// what is left of it after so many halvings.
constexpr double kFirstShare = 0.4;
constexpr double kLeastShare = kFirstShare / 1024.0;

/// A branch may be cut where its root sees all its sides from inside, by this share of the root's
/// radius.
constexpr double kClearance = 1e-3;

/// Stops stand this share of a mean side apart, so that c walks every edge in some time; where the
/// map folds for that, they stand nearer.
constexpr double kLeastTimes[] = {0.02, 1e-3, 1e-5};

/// As a share of the period: a corner so near to a cut branch's part of the boundary is in it.
constexpr double kAtEnd = 1e-9;

/// Rounds of moving parameters before a place counts as folded.
constexpr int kRounds = 24;

/// A stay at a node: the visits first..last of the walk, with all between them cut off.
struct Stay {
    int node = 0;
    int first = 0;
    int last = 0;
    bool loose = false;  ///< c rests for all of it
};

/// Cuts the branches of the walk's tree.
class Pruning {
  public:
    Pruning(const MedialAxis& axis, const Sites& sites, double salience)
        : axis_(axis), sites_(sites), count_(static_cast<int>(axis.walk.size())) {
        const auto widest = std::max_element(
            axis.nodes.begin(), axis.nodes.end(),
            [](const MedialNode& a, const MedialNode& b) { return a.radius < b.radius; });
        limit_ = salience * widest->radius;
        const auto root = static_cast<int>(widest - axis.nodes.begin());
        start_ = 0;
        while (visit(start_).node != root || visit(start_ + count_ - 1).node == root) {
            ++start_;
        }
        for (int k = start_; k < start_ + count_; ++k) {
            if (!stays_.empty() && stays_.back().node == visit(k).node) {
                stays_.back().last = k;
            } else {
                stays_.push_back({visit(k).node, k, k});
            }
        }
        // The walk ends where it began.
        stays_.push_back(stays_.front());
        stays_.back().first += count_;
        stays_.back().last += count_;
        next_.assign(stays_.size(), -1);
        std::vector<int> seen(axis.nodes.size(), -1);
        for (int k = static_cast<int>(stays_.size()) - 1; k >= 0; --k) {
            int& later = seen[static_cast<std::size_t>(stay(k).node)];
            next_[static_cast<std::size_t>(k)] = later;
            later = k;
        }
    }

    [[nodiscard]] std::vector<Stay> stays() {
        walk(0, static_cast<int>(stays_.size()) - 1);
        // The first and the last are the same stay: the visits that end it come before.
        if (kept_.size() > 1) {
            kept_.front().first = kept_.back().first - count_;
            kept_.pop_back();
        }
        return kept_;
    }

  private:
    const MedialAxis& axis_;
    const Sites& sites_;
    int count_;
    double limit_ = 0.0;
    int start_ = 0;
    std::vector<Stay> stays_;
    std::vector<int> next_;  ///< the next stay at the same node
    std::vector<Stay> kept_;

    [[nodiscard]] const Visit& visit(int k) const {
        return axis_.walk[static_cast<std::size_t>(k % count_)];
    }
    [[nodiscard]] const Stay& stay(int k) const { return stays_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const MedialNode& node(int n) const {
        return axis_.nodes[static_cast<std::size_t>(n)];
    }

    /// Keeps what is not cut of the part of the walk between two stays at one node.
    void walk(int low, int high) {
        Stay now = stay(low);
        for (int k = low; k != high;) {
            const int m = next_[static_cast<std::size_t>(k)];
            if (may_go(k, m)) {
                now.last = stay(m).last;
            } else {
                kept_.push_back(now);
                walk(k + 1, m - 1);
                now = stay(m);
            }
            k = m;
        }
        kept_.push_back(now);
    }

    /// Whether the branch between stays k and m at its root may be cut. The boundary's points
    /// farthest from the root are corners, where the seams begin.
    [[nodiscard]] bool may_go(int k, int m) const {
        if (m == k + 2) {
            return true;  // a seam before its first node
        }
        const MedialNode& root = node(stay(k).node);
        for (int v = stay(k).last; v <= stay(m).first; ++v) {
            const MedialNode& there = node(visit(v).node);
            if ((there.point - root.point).norm() - there.radius - root.radius > limit_) {
                return false;
            }
        }
        for (int v = stay(k).last; v <= stay(m).first; ++v) {
            if (!sees(root, visit(v))) {
                return false;
            }
        }
        return limit_ > 0.0;
    }

    /// Whether a node lies well inside of the sides that a visit belongs to.
    [[nodiscard]] bool sees(const MedialNode& from, const Visit& visit) const {
        const int n = sites_.count();
        const int first = visit.at_vertex ? visit.site + n - 1 : visit.site;
        for (int side = first; side <= visit.site + (visit.at_vertex ? n : 0); ++side) {
            const Vector2d a = sites_.point(sites_.grid(side));
            const Vector2d along = sites_.point(sites_.grid(side + 1)) - a;
            const Vector2d d = from.point - a;
            const double height = (along.x() * d.y() - along.y() * d.x()) / along.norm();
            if (height < kClearance * from.radius) {
                return false;
            }
        }
        return true;
    }
};

/// Finds parameters for the stays at which the map does not fold.
class Timing {
  public:
    Timing(const MedialAxis& axis, const Sites& sites, const BoundaryPieces& boundary,
           const std::vector<double>& corners, std::vector<Stay> stays, double least_time,
           bool rest_at_tips)
        : axis_(axis),
          sites_(sites),
          boundary_(boundary),
          corners_(corners),
          stays_(std::move(stays)),
          least_(least_time * sites.period / sites.count()),
          count_(static_cast<int>(axis.walk.size())),
          shares_(sites.vertices.size(), kFirstShare),
          ends_(sites.vertices.size()) {
        const std::size_t count = stays_.size();
        for (std::size_t k = 0; rest_at_tips && k < count; ++k) {
            stays_[k].loose = stays_[(k + 1) % count].node == stays_[(k + count - 1) % count].node;
        }
        for (int i = 0; i < sites.count(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double middle = sites.parameter(i, 0.5);
            ends_[k] = {middle, middle};
            used_.emplace_back(false);
        }
        for (const Visit& visit : axis.walk) {
            if (!visit.at_vertex) {
                const auto k = static_cast<std::size_t>(visit.site);
                ends_[k] = used_[k] ? Ends{std::min(ends_[k].first, visit.place),
                                           std::max(ends_[k].last, visit.place)}
                                    : Ends{visit.place, visit.place};
                used_[k] = true;
            }
        }
    }

    [[nodiscard]] tl::expected<ConcentricCurve, Folds> find() {
        for (int round = 0;; ++round) {
            ConcentricCurve curve = timed();
            if (!in_order(curve)) {
                const double begin = curve.stops.front().from;
                return tl::unexpected(Folds{{{begin, begin + curve.period, 0, 0}}});
            }
            const std::vector<Course> all = courses(curve);
            std::vector<Course> folded;
            for (const int k : folded_courses(boundary_, curve)) {
                folded.push_back(all[static_cast<std::size_t>(k)]);
            }
            if (folded.empty()) {
                return curve;
            }
            if (round == kRounds || !adapt(curve, folded)) {
                return tl::unexpected(Folds{folded});
            }
        }
    }

  private:
    struct Ends {
        double first = 0.0;
        double last = 0.0;
    };
    const MedialAxis& axis_;
    const Sites& sites_;
    const BoundaryPieces& boundary_;
    const std::vector<double>& corners_;
    std::vector<Stay> stays_;
    double least_;
    int count_;
    std::vector<double> shares_;  ///< of each reflex vertex
    std::vector<Ends> ends_;      ///< of the feet on each side
    std::vector<char> used_;

    [[nodiscard]] const Visit& visit(int k) const {
        return axis_.walk[static_cast<std::size_t>(((k % count_) + count_) % count_)];
    }

    [[nodiscard]] double parameter(int k) const {
        const double turns = sites_.period * std::floor(static_cast<double>(k) / count_);
        const Visit& v = visit(k);
        if (!v.at_vertex) {
            return turns + v.place;
        }
        const auto n = sites_.vertices.size();
        const auto i = static_cast<std::size_t>(v.site);
        const Sites::Vertex& vertex = sites_.vertices[i];
        const double last_turn = i == 0 ? sites_.period : 0.0;
        const double free_before = vertex.before - (ends_[(i + n - 1) % n].last - last_turn);
        const double free_after = ends_[i].first - vertex.after;
        const double low = vertex.before - shares_[i] * free_before;
        const double high = vertex.after + shares_[i] * free_after;
        const double middle = 0.5 * (vertex.before + vertex.after);
        return turns + (v.place < 0.5 ? low + (middle - low) * 2.0 * v.place
                                      : middle + (high - middle) * (2.0 * v.place - 1.0));
    }

    /// The corners in a range, on any turn: the first and the last.
    [[nodiscard]] std::vector<double> corners_in(double first, double last) const {
        const double slack = kAtEnd * sites_.period;
        std::vector<double> found;
        if (corners_.empty()) {
            return found;
        }
        const double begin = corners_.front();
        double turns = std::floor((first - slack - begin) / sites_.period) * sites_.period;
        auto corner = std::lower_bound(corners_.begin(), corners_.end(), first - slack - turns);
        for (;; ++corner) {
            if (corner == corners_.end()) {
                corner = corners_.begin();
                turns += sites_.period;
            }
            if (*corner + turns > last + slack) {
                return found;
            }
            found.push_back(std::clamp(*corner + turns, first, last));
        }
    }

    /// The middle between the first and the last corner of the control polygon whose seam ends at a
    /// stay.
    [[nodiscard]] double tip(const Stay& stay) const {
        double first = INFINITY;
        double last = -INFINITY;
        for (int k = stay.first; k <= stay.last; ++k) {
            if (axis_.nodes[static_cast<std::size_t>(visit(k).node)].radius <= 0.0) {
                first = std::min(first, parameter(k));
                last = std::max(last, parameter(k));
            }
        }
        return first <= last ? 0.5 * (first + last)
                             : 0.5 * (parameter(stay.first) + parameter(stay.last));
    }

    [[nodiscard]] Stop stop_of(const Stay& stay) const {
        const double first = parameter(stay.first);
        const double last = parameter(stay.last);
        if (stay.loose) {
            return {stay.node, first, last};
        }
        const std::vector<double> corners = corners_in(first, last);
        if (!corners.empty()) {
            return {stay.node, corners.front(), corners.back()};
        }
        const double at = std::clamp(tip(stay), first, last);
        return {stay.node, at, at};
    }

    [[nodiscard]] ConcentricCurve timed() const {
        ConcentricCurve curve;
        curve.period = sites_.period;
        for (const MedialNode& node : axis_.nodes) {
            curve.nodes.push_back(node.point);
        }
        for (const Stay& stay : stays_) {
            curve.stops.push_back(stop_of(stay));
        }
        keep_apart(curve);
        return curve;
    }

    /// What lies between one stop and the one before it, cyclic.
    static double room(const ConcentricCurve& curve, int k) {
        const int n = curve.count();
        return curve.stop(k + n).from - curve.stop(k + n - 1).to;
    }

    /// Pushes stops on until all are some time apart, from where there is most room.
    void keep_apart(ConcentricCurve& curve) const {
        const int n = curve.count();
        int first = 0;
        for (int k = 1; k < n; ++k) {
            first = room(curve, k) > room(curve, first) ? k : first;
        }
        for (int k = first + 1; k < first + n; ++k) {
            Stop& stop = curve.stops[static_cast<std::size_t>(k % n)];
            const double push = std::max(0.0, least_ - room(curve, k % n));
            stop.from += push;
            stop.to = std::max(stop.to, stop.from);
        }
    }

    /// Whether the stops stand in their order all the way around.
    static bool in_order(const ConcentricCurve& curve) {
        for (int k = 0; curve.count() > 1 && k < curve.count(); ++k) {
            if (!(room(curve, k) > 0.0)) {
                return false;
            }
        }
        return true;
    }

    /// Moves the parameters beside the folds; false where nothing is left to move.
    bool adapt(const ConcentricCurve& curve, const std::vector<Course>& folded) {
        std::set<int> touched;
        for (const Course& course : folded) {
            const auto after =
                std::upper_bound(curve.stops.begin(), curve.stops.end(), course.from,
                                 [](double value, const Stop& stop) { return value < stop.from; });
            const auto k = static_cast<int>(after - curve.stops.begin()) - 1;
            touched.insert({k, (k + 1) % curve.count()});
        }
        bool changed = false;
        std::set<int> vertices;
        for (const int k : touched) {
            Stay& stay = stays_[static_cast<std::size_t>(k)];
            if (!stay.loose && stay.first != stay.last) {
                stay.loose = true;
                changed = true;
                continue;
            }
            for (const int v : {stay.first, stay.last}) {
                if (visit(v).at_vertex) {
                    vertices.insert(visit(v).site);
                }
            }
        }
        for (const int v : vertices) {
            double& share = shares_[static_cast<std::size_t>(v)];
            if (share > kLeastShare) {
                share *= 0.5;
                changed = true;
            }
        }
        return changed;
    }
};

}  // namespace

tl::expected<ConcentricCurve, Folds> retract(const MedialAxis& axis, const Sites& sites,
                                             const BoundaryPieces& boundary,
                                             const std::vector<double>& corners,
                                             const RetractionOptions& options) {
    const std::vector<Stay> stays = Pruning(axis, sites, options.salience).stays();
    tl::expected<ConcentricCurve, Folds> found;
    for (const bool rest : {true, false}) {
        for (const double least_time : kLeastTimes) {
            if (rest && !options.rest_at_tips) {
                continue;
            }
            found = Timing(axis, sites, boundary, corners, stays, least_time, rest).find();
            if (found) {
                return found;
            }
        }
    }
    return found;
}

}  // namespace suture::concentric
