#include "files/mesh_repair.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

namespace suture::io {

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Triangles as they are changed, with those at each point.
class TriangleNet {
  public:
    explicit TriangleNet(Mesh& mesh) : mesh_(mesh), at_(mesh.points.size()) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (const std::uint32_t corner : mesh.triangles[t]) {
                at_[corner].push_back(t);
            }
        }
    }

    [[nodiscard]] double height(const Corners& c) const {
        const Eigen::Vector3d a = point(c[0]);
        const Eigen::Vector3d b = point(c[1]);
        const Eigen::Vector3d d = point(c[2]);
        const double longest = std::max({(b - a).norm(), (d - b).norm(), (a - d).norm()});
        return longest > 0.0 ? (b - a).cross(d - a).norm() / longest : 0.0;
    }
    [[nodiscard]] double height(std::uint32_t t) const { return height(mesh_.triangles[t]); }
    [[nodiscard]] bool is_gone(std::uint32_t t) const {
        return mesh_.triangles[t][0] == mesh_.triangles[t][1];
    }

    /// Draws the shortest edge together if it is that short. Whether it could be done.
    bool collapse(std::uint32_t t, double longest) {
        const Corners c = mesh_.triangles[t];
        std::size_t shortest = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            shortest = length(c, i) < length(c, shortest) ? i : shortest;
        }
        const std::uint32_t keep = c[shortest];
        const std::uint32_t drop = c[(shortest + 1) % 3];
        if (length(c, shortest) > longest || !is_link_simple(keep, drop)) {
            return false;
        }
        for (const std::uint32_t other : std::vector(at_[drop])) {
            Corners& corners = mesh_.triangles[other];
            if (std::ranges::find(corners, keep) != corners.end()) {
                remove(other);
                continue;
            }
            std::ranges::replace(corners, drop, keep);
            at_[keep].push_back(other);
        }
        at_[drop].clear();
        return true;
    }

    /// Turns the diagonal that is the triangle's longest edge. Whether that makes it better.
    bool flip(std::uint32_t t) {
        const Corners c = mesh_.triangles[t];
        std::size_t longest = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            longest = length(c, i) > length(c, longest) ? i : longest;
        }
        const std::uint32_t a = c[longest];
        const std::uint32_t b = c[(longest + 1) % 3];
        const std::uint32_t top = c[(longest + 2) % 3];
        const std::optional<std::uint32_t> other = triangle_at(b, a);
        if (!other || !triangle_at(a, b)) {
            return false;
        }
        const std::uint32_t below = opposite(*other, a, b);
        if (below == top || are_joined(top, below)) {
            return false;
        }
        const Corners one{top, a, below};
        const Corners two{below, b, top};
        if (std::min(height(one), height(two)) <= std::min(height(t), height(*other))) {
            return false;
        }
        mesh_.triangles[t] = one;
        mesh_.triangles[*other] = two;
        std::erase(at_[b], t);
        std::erase(at_[a], *other);
        at_[below].push_back(t);
        at_[top].push_back(*other);
        return true;
    }

  private:
    [[nodiscard]] Eigen::Vector3d point(std::uint32_t p) const {
        return Eigen::Map<const Eigen::Vector3d>(mesh_.points[p].data());
    }
    [[nodiscard]] double length(const Corners& c, std::size_t side) const {
        return (point(c[(side + 1) % 3]) - point(c[side])).norm();
    }
    /// The only triangle that walks from a to b.
    [[nodiscard]] std::optional<std::uint32_t> triangle_at(std::uint32_t a, std::uint32_t b) const {
        std::optional<std::uint32_t> found;
        for (const std::uint32_t t : at_[a]) {
            const Corners& c = mesh_.triangles[t];
            for (std::size_t i = 0; i < 3; ++i) {
                if (c[i] == a && c[(i + 1) % 3] == b) {
                    if (found) {
                        return std::nullopt;
                    }
                    found = t;
                }
            }
        }
        return found;
    }
    [[nodiscard]] std::uint32_t opposite(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
        const Corners& c = mesh_.triangles[t];
        return *std::ranges::find_if(c, [&](std::uint32_t p) { return p != a && p != b; });
    }
    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t p) const {
        std::vector<std::uint32_t> result;
        for (const std::uint32_t t : at_[p]) {
            std::ranges::copy_if(mesh_.triangles[t], std::back_inserter(result),
                                 [&](std::uint32_t q) { return q != p; });
        }
        std::ranges::sort(result);
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }
    [[nodiscard]] bool are_joined(std::uint32_t p, std::uint32_t q) const {
        return std::ranges::binary_search(neighbours(p), q);
    }
    /// The points next to both are those across the edge, so that nothing is pinched.
    [[nodiscard]] bool is_link_simple(std::uint32_t p, std::uint32_t q) const {
        std::vector<std::uint32_t> common;
        const auto one = neighbours(p);
        const auto two = neighbours(q);
        std::ranges::set_intersection(one, two, std::back_inserter(common));
        const auto triangles = std::ranges::count_if(at_[p], [&](std::uint32_t t) {
            return std::ranges::find(mesh_.triangles[t], q) != mesh_.triangles[t].end();
        });
        return triangles <= 2 && static_cast<std::ptrdiff_t>(common.size()) == triangles;
    }
    void remove(std::uint32_t t) {
        for (const std::uint32_t corner : mesh_.triangles[t]) {
            std::erase(at_[corner], t);
        }
        mesh_.triangles[t] = {};
    }

    Mesh& mesh_;
    std::vector<std::vector<std::uint32_t>> at_;
};

/// Leaves out triangles that are gone, and points of none.
void tidy(Mesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.triangles[t][0] != mesh.triangles[t][1]) {
            mesh.triangles[kept] = mesh.triangles[t];
            if (!mesh.faces.empty()) {
                mesh.faces[kept] = mesh.faces[t];
            }
            ++kept;
        }
    }
    mesh.triangles.resize(kept);
    mesh.faces.resize(mesh.faces.empty() ? 0 : kept);
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(mesh.points.size(), kUnused);
    std::vector<std::array<double, 3>> points;
    for (Corners& corners : mesh.triangles) {
        for (std::uint32_t& corner : corners) {
            if (number[corner] == kUnused) {
                number[corner] = static_cast<std::uint32_t>(points.size());
                points.push_back(mesh.points[corner]);
            }
            corner = number[corner];
        }
    }
    mesh.points = std::move(points);
}

}  // namespace

int remove_needles(Mesh& mesh, double height) {
    TriangleNet net(mesh);
    const auto is_needle = [&](std::uint32_t t) {
        return !net.is_gone(t) && net.height(t) < height;
    };
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    int before = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        before += is_needle(t) ? 1 : 0;
    }
    if (before == 0) {
        return 0;
    }
    // A flip can hand the needle on to the next triangle; a few rounds take it to where it ends.
    constexpr int kRounds = 10;
    bool changed = true;
    for (int round = 0; round < kRounds && changed; ++round) {
        changed = false;
        for (std::uint32_t t = 0; t < count; ++t) {
            changed = (is_needle(t) && (net.collapse(t, height) || net.flip(t))) || changed;
        }
    }
    int after = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        after += is_needle(t) ? 1 : 0;
    }
    tidy(mesh);
    return before - after;
}

int remove_back_to_back(Mesh& mesh) {
    // By its corners from the smallest on; turned round, the last two change places.
    const auto from_smallest = [](Corners corners) {
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        return corners;
    };
    std::map<Corners, std::vector<std::uint32_t>> places;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        places[from_smallest(mesh.triangles[t])].push_back(t);
    }
    int removed = 0;
    for (const auto& [corners, here] : places) {
        const auto there = places.find({corners[0], corners[2], corners[1]});
        if (corners[1] > corners[2] || there == places.end() || here.size() != 1 ||
            there->second.size() != 1 ||
            (!mesh.faces.empty() && mesh.faces[here[0]] == mesh.faces[there->second[0]])) {
            continue;
        }
        mesh.triangles[here[0]] = mesh.triangles[there->second[0]] = {};
        removed += 2;
    }
    if (removed > 0) {
        tidy(mesh);
    }
    return removed;
}

std::size_t count_open_edges(const Mesh& mesh) {
    const auto key = [](std::uint32_t a, std::uint32_t b) {
        constexpr int kHalf = 32;
        return (static_cast<std::uint64_t>(a) << kHalf) | b;
    };
    std::unordered_map<std::uint64_t, int> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (const Corners& c : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++uses[key(c[i], c[(i + 1) % 3])];
        }
    }
    std::size_t open = 0;
    for (const Corners& c : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto other = uses.find(key(c[(i + 1) % 3], c[i]));
            const bool met =
                other != uses.end() && other->second == uses[key(c[i], c[(i + 1) % 3])];
            open += met ? 0 : 1;
        }
    }
    return open;
}

}  // namespace suture::io
