#include "suture/fill/concentric/simplify.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;

double distance_to_segment(const Vector2d& x, const Vector2d& a, const Vector2d& b) {
    const Vector2d d = b - a;
    const double length2 = d.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((x - a).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (x - a - s * d).norm();
}

/// As a share of the period: a stop so near to a parameter to be kept is at it.
constexpr double kAt = 1e-7;

class Thinning {
  public:
    Thinning(const ConcentricCurve& curve, const BoundaryPieces& boundary,
             const std::vector<double>& keep, double distance)
        : curve_(curve), boundary_(boundary), keep_(keep), distance_(distance) {}

    [[nodiscard]] ConcentricCurve thinned() {
        while (pass()) {
        }
        return curve_;
    }

  private:
    ConcentricCurve curve_;
    const BoundaryPieces& boundary_;
    const std::vector<double>& keep_;
    double distance_;
    /// dropped_[n]: the nodes that went where the edge from n to its next one now leads.
    std::map<std::pair<int, int>, std::vector<Vector2d>> dropped_;

    [[nodiscard]] bool kept(const Stop& stop) const {
        return std::any_of(keep_.begin(), keep_.end(), [&](double s) {
            const double turns = std::round((stop.from - s) / curve_.period);
            return std::abs(stop.from - s - turns * curve_.period) < kAt * curve_.period;
        });
    }

    [[nodiscard]] const std::vector<Vector2d>& between(int a, int b) {
        return dropped_[{std::min(a, b), std::max(a, b)}];
    }

    [[nodiscard]] bool near_enough(int a, int x, int b) {
        std::vector<Vector2d> all = between(a, x);
        const std::vector<Vector2d>& more = between(x, b);
        all.insert(all.end(), more.begin(), more.end());
        all.push_back(curve_.nodes[static_cast<std::size_t>(x)]);
        const Vector2d& from = curve_.nodes[static_cast<std::size_t>(a)];
        const Vector2d& to = curve_.nodes[static_cast<std::size_t>(b)];
        return std::all_of(all.begin(), all.end(), [&](const Vector2d& p) {
            return distance_to_segment(p, from, to) <= distance_;
        });
    }

    [[nodiscard]] bool positive(const Stop& a, const Stop& b) const {
        return certify(boundary_, curve_, {a.to, b.from, a.node, b.node}) == Certificate::Positive;
    }

    /// Goes once around; whether any node went.
    bool pass() {
        const int n = curve_.count();
        std::vector<std::vector<int>> at(curve_.nodes.size());
        for (int k = 0; k < n; ++k) {
            at[static_cast<std::size_t>(curve_.stops[static_cast<std::size_t>(k)].node)].push_back(
                k);
        }
        std::vector<char> gone(static_cast<std::size_t>(n), 0);
        std::vector<char> touched(static_cast<std::size_t>(n), 0);
        bool any = false;
        for (std::size_t x = 0; x < at.size(); ++x) {
            if (at[x].size() != 2) {
                continue;
            }
            const int k = at[x][0];
            const int m = at[x][1];
            const auto flag = [&](int i) -> char& {
                return touched[static_cast<std::size_t>((i + n) % n)];
            };
            if (flag(k - 1) || flag(k) || flag(k + 1) || flag(m - 1) || flag(m) || flag(m + 1) ||
                !may_go(k, m)) {
                continue;
            }
            for (const int i : {k - 1, k, k + 1, m - 1, m, m + 1}) {
                flag(i) = 1;
            }
            gone[static_cast<std::size_t>(k)] = gone[static_cast<std::size_t>(m)] = 1;
            any = true;
            remember(k);
        }
        std::vector<Stop> left;
        for (int k = 0; k < n; ++k) {
            if (!gone[static_cast<std::size_t>(k)]) {
                left.push_back(curve_.stops[static_cast<std::size_t>(k)]);
            }
        }
        curve_.stops = std::move(left);
        return any;
    }

    [[nodiscard]] bool may_go(int k, int m) {
        const int n = curve_.count();
        const Stop a = curve_.stop(k + n - 1);
        const Stop x = curve_.stop(k + n);
        const Stop b = curve_.stop(k + n + 1);
        const Stop c = curve_.stop(m + n - 1);
        const Stop y = curve_.stop(m + n);
        const Stop d = curve_.stop(m + n + 1);
        return n > 4 && x.from == x.to && y.from == y.to && a.node == d.node && b.node == c.node &&
               a.node != b.node && !kept(x) && !kept(y) && near_enough(a.node, x.node, b.node) &&
               positive(a, b) && positive(c, d);
    }

    void remember(int k) {
        const int n = curve_.count();
        const int a = curve_.stop(k + n - 1).node;
        const int x = curve_.stop(k + n).node;
        const int b = curve_.stop(k + n + 1).node;
        std::vector<Vector2d> all = between(a, x);
        const std::vector<Vector2d>& more = between(x, b);
        all.insert(all.end(), more.begin(), more.end());
        all.push_back(curve_.nodes[static_cast<std::size_t>(x)]);
        dropped_[{std::min(a, b), std::max(a, b)}] = std::move(all);
    }
};

}  // namespace

ConcentricCurve simplified(const ConcentricCurve& curve, const BoundaryPieces& boundary,
                           const std::vector<double>& keep, double distance) {
    return Thinning(curve, boundary, keep, distance).thinned();
}

}  // namespace suture::concentric
