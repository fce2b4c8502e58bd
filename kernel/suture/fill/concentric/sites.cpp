#include "suture/fill/concentric/sites.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;
using Int = std::int64_t;
using Vertex = Sites::Vertex;

/// The grid: coordinates below 2^28, so that every cross product is exact in 64 bits, and a power
/// of two to one unit, so that dyadic coordinates stay what they are.
constexpr int kGridBits = 28;

/// A vertex this many grid cells from the line through its neighbours is on it: that much the
/// rounding to the grid can make up.
constexpr double kStraight = 2.0;

/// Twice the area of the triangle: positive where c lies to the left of a to b. Exact.
Int turn(const Vertex& a, const Vertex& b, const Vertex& c) {
    return (Int{b.x} - a.x) * (Int{c.y} - a.y) - (Int{b.y} - a.y) * (Int{c.x} - a.x);
}

Int dot(const Vertex& a, const Vertex& b, const Vertex& c) {
    return (Int{b.x} - a.x) * (Int{c.x} - b.x) + (Int{b.y} - a.y) * (Int{c.y} - b.y);
}

double length(const Vertex& a, const Vertex& b) {
    return std::hypot(static_cast<double>(Int{b.x} - a.x), static_cast<double>(Int{b.y} - a.y));
}

bool same(const Vertex& a, const Vertex& b) {
    return a.x == b.x && a.y == b.y;
}

/// Neighbouring vertices that fall together become one with a range of parameters.
std::vector<Vertex> without_repeats(const std::vector<Vertex>& all, double period) {
    std::vector<Vertex> distinct;
    for (const Vertex& v : all) {
        if (!distinct.empty() && same(distinct.back(), v)) {
            distinct.back().after = v.after;
        } else {
            distinct.push_back(v);
        }
    }
    if (distinct.size() > 1 && same(distinct.front(), distinct.back())) {
        distinct.front().before = distinct.back().before - period;
        distinct.pop_back();
    }
    return distinct;
}

/// Whether b may go: it lies on the straight way from a to c.
bool on_the_way(const Vertex& a, const Vertex& b, const Vertex& c) {
    return std::abs(static_cast<double>(turn(a, b, c))) <= kStraight * length(a, c) &&
           dot(a, b, c) > 0;
}

/// The vertices that are corners of the polygon, as indices. A vertex goes only while all between
/// its neighbours left lie on their line: else a round curve would go vertex by vertex.
std::vector<int> kept(const std::vector<Vertex>& v) {
    const auto n = static_cast<int>(v.size());
    const auto at = [&](int i) -> const Vertex& { return v[static_cast<std::size_t>(i % n)]; };
    // Start at the vertex that turns most: it surely stays.
    int start = 0;
    double sharpest = -1.0;
    for (int i = 0; i < n; ++i) {
        const double sine = std::abs(static_cast<double>(turn(at(i + n - 1), at(i), at(i + 1)))) /
                            (length(at(i + n - 1), at(i)) * length(at(i), at(i + 1)));
        if (sine > sharpest) {
            sharpest = sine;
            start = i;
        }
    }
    std::vector<int> result = {start};
    int last = start;
    for (int i = start + 1; i < start + n; ++i) {
        bool goes = true;
        for (int k = last + 1; goes && k <= i; ++k) {
            goes = on_the_way(at(last), at(k), at(i + 1));
        }
        if (!goes) {
            result.push_back(i % n);
            last = i;
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// Whether segments ab and cd share a point.
bool meet(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    const auto sign = [](Int x) { return (x > 0) - (x < 0); };
    const auto between = [](const Vertex& p, const Vertex& q, const Vertex& x) {
        return std::min(p.x, q.x) <= x.x && x.x <= std::max(p.x, q.x) &&
               std::min(p.y, q.y) <= x.y && x.y <= std::max(p.y, q.y);
    };
    const int abc = sign(turn(a, b, c));
    const int abd = sign(turn(a, b, d));
    const int cda = sign(turn(c, d, a));
    const int cdb = sign(turn(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) {
        return true;
    }
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

/// Two sides that meet where they should not, or a spike; -1 where there are none. A sweep over x.
std::pair<int, int> crossing(const std::vector<Vertex>& v) {
    const auto n = static_cast<int>(v.size());
    const auto at = [&](int i) -> const Vertex& { return v[static_cast<std::size_t>(i % n)]; };
    for (int i = 0; i < n; ++i) {
        if (turn(at(i), at(i + 1), at(i + 2)) == 0 && dot(at(i), at(i + 1), at(i + 2)) < 0) {
            return {i, (i + 1) % n};
        }
    }
    const auto low = [&](int i) { return std::min(at(i).x, at(i + 1).x); };
    const auto high = [&](int i) { return std::max(at(i).x, at(i + 1).x); };
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int k) { return low(i) < low(k); });
    std::vector<int> active;
    for (const int i : order) {
        std::erase_if(active, [&](int k) { return high(k) < low(i); });
        for (const int k : active) {
            const bool neighbours = (i + 1) % n == k || (k + 1) % n == i;
            if (!neighbours && meet(at(i), at(i + 1), at(k), at(k + 1))) {
                return {std::min(i, k), std::max(i, k)};
            }
        }
        active.push_back(i);
    }
    return {-1, -1};
}

/// Lets the kept vertices' sides know the parameters of those that went.
void thin_out(Sites& sites, const std::vector<Vertex>& all) {
    const std::vector<int> keep = kept(all);
    const auto n = static_cast<int>(all.size());
    for (std::size_t k = 0; k < keep.size(); ++k) {
        const int from = keep[k];
        const int to = k + 1 < keep.size() ? keep[k + 1] : keep.front() + n;
        const auto at = [&](int i) -> const Vertex& {
            return all[static_cast<std::size_t>(i % n)];
        };
        const auto turned = [&](int i) { return i >= n ? sites.period : 0.0; };
        const double whole = length(at(from), at(to));
        auto& edge = sites.edges.emplace_back();
        edge.emplace_back(0.0, at(from).after);
        for (int i = from + 1; i < to; ++i) {
            const double fraction = length(at(from), at(i)) / whole;
            edge.emplace_back(fraction, at(i).before + turned(i));
            edge.emplace_back(fraction, at(i).after + turned(i));
        }
        edge.emplace_back(1.0, at(to).before + turned(to));
        sites.vertices.push_back(at(from));
    }
}

}  // namespace

double double_area(const Eigen::Matrix2Xd& polygon) {
    double area = 0.0;
    const Eigen::Index n = polygon.cols();
    for (Eigen::Index i = 0; i < n; ++i) {
        const Vector2d a = polygon.col(i) - polygon.col(0);
        const Vector2d b = polygon.col((i + 1) % n) - polygon.col(0);
        area += a.x() * b.y() - a.y() * b.x();
    }
    return area;
}

double Sites::parameter(int edge, double fraction) const {
    const auto& table = edges[static_cast<std::size_t>(edge)];
    std::size_t k = 1;
    while (k + 1 < table.size() && table[k].x() < fraction) {
        ++k;
    }
    const Vector2d& a = table[k - 1];
    const Vector2d& b = table[k];
    return b.x() > a.x() ? a.y() + (b.y() - a.y()) * (fraction - a.x()) / (b.x() - a.x())
                         : 0.5 * (a.y() + b.y());
}

Result<Sites> make_sites(const Eigen::Matrix2Xd& polygon, const std::vector<double>& parameters,
                         double period) {
    Sites sites;
    sites.period = period;
    const Vector2d low = polygon.rowwise().minCoeff();
    const Vector2d high = polygon.rowwise().maxCoeff();
    const double size = (high - low).maxCoeff();
    if (!(size > 0.0) || !std::isfinite(size)) {
        return fail(ErrorCode::Refused, "the boundary has no extent");
    }
    sites.scale = std::exp2(kGridBits - 1 - std::ceil(std::log2(size)));
    // On the grid as well, so that equal input has equal differences.
    sites.centre = ((0.5 * (low + high) * sites.scale).array().round() / sites.scale).matrix();
    std::vector<Vertex> all;
    for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
        const Vector2d grid = (polygon.col(i) - sites.centre) * sites.scale;
        const double s = parameters[static_cast<std::size_t>(i)];
        all.push_back({static_cast<std::int32_t>(std::lround(grid.x())),
                       static_cast<std::int32_t>(std::lround(grid.y())), s, s});
    }
    all = without_repeats(all, period);
    if (all.size() >= 3) {
        thin_out(sites, all);
    }
    if (sites.count() < 3) {
        return fail(ErrorCode::Refused, "the boundary encloses no area");
    }
    if (const auto [i, k] = crossing(sites.vertices); i >= 0) {
        const auto middle = [&](int e) { return sites.parameter(e, 0.5); };
        const Vector2d where = sites.point(sites.grid(i));
        return fail(ErrorCode::Refused,
                    "the control polygon meets itself: its sides at s = {:.6g} and {:.6g}, near "
                    "({:.6g}, {:.6g})",
                    middle(i), middle(k), where.x(), where.y());
    }
    const int n = sites.count();
    for (int i = 0; i < n; ++i) {
        const auto at = [&](int k) -> Vertex& {
            return sites.vertices[static_cast<std::size_t>(k % n)];
        };
        at(i).reflex = turn(at(i + n - 1), at(i), at(i + 1)) < 0;
    }
    return sites;
}

}  // namespace suture::concentric
