#include "suture/fill/manifold/star_mesh.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace suture::manifold {
namespace {

/// Half-edges of a mesh without its central polygon.
class HalfEdges {
  public:
    [[nodiscard]] static Result<HalfEdges> make(const std::vector<std::vector<int>>& faces) {
        HalfEdges result;
        for (const std::vector<int>& face : faces) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const int a = face[k];
                const int b = face[(k + 1) % face.size()];
                const int c = face[(k + 2) % face.size()];
                if (!result.next_.emplace(std::pair(a, b), c).second) {
                    return fail(ErrorCode::Refused,
                                "two faces run along the edge of vertices {} and {} in the same "
                                "sense: turn one of them over",
                                a + 1, b + 1);
                }
                result.neighbours_[a].insert(b);
                result.neighbours_[b].insert(a);
            }
        }
        return result;
    }

    /// The vertex after a, b in the face that has the edge a -> b, or none.
    [[nodiscard]] std::optional<int> after(int a, int b) const {
        const auto it = next_.find({a, b});
        return it == next_.end() ? std::nullopt : std::optional(it->second);
    }
    [[nodiscard]] int valence(int vertex) const {
        return static_cast<int>(neighbours_.at(vertex).size());
    }
    [[nodiscard]] const std::map<int, std::set<int>>& neighbours() const { return neighbours_; }

    /// Loops of edges that one face has, in the sense of that face.
    [[nodiscard]] Result<std::vector<std::vector<int>>> borders() const {
        std::map<int, int> step;
        for (const auto& [edge, unused] : next_) {
            if (!next_.contains({edge.second, edge.first}) &&
                !step.emplace(edge.first, edge.second).second) {
                return fail(ErrorCode::Refused, "two borders of the mesh touch at vertex {}",
                            edge.first + 1);
            }
        }
        std::vector<std::vector<int>> loops;
        while (!step.empty()) {
            std::vector<int>& loop = loops.emplace_back();
            for (auto it = step.begin(); it != step.end(); it = step.find(loop.back())) {
                if (loop.empty()) {
                    loop.push_back(it->first);
                }
                loop.push_back(it->second);
                step.erase(it);
            }
            loop.pop_back();
        }
        return loops;
    }

  private:
    std::map<std::pair<int, int>, int> next_;
    std::map<int, std::set<int>> neighbours_;
};

/// Faces without the one polygon that may stand in the hole.
Result<std::vector<std::vector<int>>> quads_of(const PolygonMesh& mesh) {
    std::vector<std::vector<int>> quads;
    std::optional<std::size_t> other;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (mesh.faces[f].size() == 4) {
            quads.push_back(mesh.faces[f]);
        } else if (other) {
            return fail(ErrorCode::Refused,
                        "faces {} and {} have {} and {} sides: all but the one in the hole have 4",
                        *other + 1, f + 1, mesh.faces[*other].size(), mesh.faces[f].size());
        } else {
            other = f;
        }
    }
    if (quads.empty()) {
        return fail(ErrorCode::Refused, "the mesh has no face of four sides");
    }
    return quads;
}

/// Follows the rows and columns of the mesh.
class Walk {
  public:
    Walk(const HalfEdges& edges, StarMesh& star) : edges_(edges), star_(star) {}

    Result<void> run() {
        const auto borders = edges_.borders();
        if (!borders) {
            return tl::unexpected(borders.error());
        }
        if (borders->size() != 2) {
            return fail(ErrorCode::Refused,
                        "the mesh has {} borders, not 2: the hole in the middle and the outer one "
                        "(leave the central face away if it is a quad)",
                        borders->size());
        }
        return label(*borders);
    }

  private:
    const HalfEdges& edges_;
    StarMesh& star_;
    std::vector<std::vector<int>> middles_;  ///< C_m: i fastest, (s' + 1) x (r'_m + 1)
    std::vector<std::vector<int>> corners_;  ///< L_m: i fastest, (s' + 1) x (s' + 1)

    Result<void> label(const std::vector<std::vector<int>>& borders) {
        const auto has_valence_2 = [&](const std::vector<int>& loop) {
            return std::any_of(loop.begin(), loop.end(),
                               [&](int v) { return edges_.valence(v) == 2; });
        };
        const std::size_t outer = has_valence_2(borders[0]) ? 0 : 1;
        // A border runs with its faces on the left: the hole's, clockwise about the hole.
        std::vector<int> hole(borders[1 - outer].rbegin(), borders[1 - outer].rend());
        if (auto valences = check_valences(hole, borders[outer]); !valences) {
            return valences;
        }
        const auto first =
            std::find_if(hole.begin(), hole.end(), [&](int v) { return edges_.valence(v) == 4; });
        std::rotate(hole.begin(), first, hole.end());
        for (std::size_t a = 0; a < hole.size();) {
            std::vector<int> side = {hole[a]};
            do {
                ++a;
                side.push_back(hole[a % hole.size()]);
            } while (edges_.valence(side.back()) != 4);
            if (auto done = walk_middle(std::move(side)); !done) {
                return done;
            }
        }
        return join();
    }

    [[nodiscard]] Result<void> check_valences(const std::vector<int>& hole,
                                              const std::vector<int>& outer) const {
        const auto place = [&](int v) {
            return std::find(hole.begin(), hole.end(), v) != hole.end()      ? 1
                   : std::find(outer.begin(), outer.end(), v) != outer.end() ? 2
                                                                             : 0;
        };
        int corners = 0;
        int ends = 0;
        for (const auto& [vertex, unused] : edges_.neighbours()) {
            const int valence = edges_.valence(vertex);
            const int where = place(vertex);
            if (where == 0 && valence != 4) {
                return fail(ErrorCode::Refused, "vertex {} has valence {}: inside it has to be 4",
                            vertex + 1, valence);
            }
            if (where == 1 && valence != 3 && valence != 4) {
                return fail(ErrorCode::Refused,
                            "vertex {} has valence {}: along the hole it has to be 3, or 4 at the "
                            "hole's corners",
                            vertex + 1, valence);
            }
            if (where == 2 && valence != 2 && valence != 3) {
                return fail(ErrorCode::Refused,
                            "vertex {} has valence {}: along the outer border it has to be 3, or 2 "
                            "at the corners",
                            vertex + 1, valence);
            }
            corners += where == 1 && valence == 4 ? 1 : 0;
            ends += where == 2 && valence == 2 ? 1 : 0;
        }
        if (corners < 3) {
            return fail(ErrorCode::Refused,
                        "the hole has {} corners (vertices of valence 4), fewer than 3", corners);
        }
        if (ends != corners) {
            return fail(ErrorCode::Refused,
                        "the hole has {} corners (valence 4), the outer border {} (valence 2)",
                        corners, ends);
        }
        return {};
    }

    /// The row beyond a row of vertices, over the quads to the left of b -> a for a, b in order.
    [[nodiscard]] std::vector<int> next_row(const std::vector<int>& row) const {
        std::vector<int> next;
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            const auto a = edges_.after(row[k + 1], row[k]);
            if (!a) {
                return {};
            }
            const auto b = edges_.after(row[k], *a);
            if ((!next.empty() && next.back() != *a) || !b) {
                return {};
            }
            if (next.empty()) {
                next.push_back(*a);
            }
            next.push_back(*b);
        }
        return next;
    }

    Result<void> walk_middle(std::vector<int> row) {
        star_.columns.push_back(static_cast<int>(row.size()) - 1);
        std::vector<std::vector<int>> rows;
        for (; !row.empty(); row = next_row(row)) {
            rows.push_back(row);
            if (rows.size() > static_cast<std::size_t>(star_.mesh.vertices.cols())) {
                return fail(ErrorCode::Refused, "the layers about vertex {} never end",
                            rows.front().front() + 1);
            }
        }
        const int layers = static_cast<int>(rows.size()) - 1;
        if (star_.layers == 0) {
            star_.layers = layers;
        }
        if (layers != star_.layers || layers == 0) {
            return fail(ErrorCode::Refused,
                        "{} layers lie outside of the hole's side that begins at vertex {}, {} "
                        "outside of the first",
                        layers, rows.front().front() + 1, star_.layers);
        }
        std::vector<int>& block = middles_.emplace_back();
        for (std::size_t j = 0; j < rows.front().size(); ++j) {
            for (const auto& across : rows) {
                block.push_back(across[j]);
            }
        }
        return {};
    }

    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(star_.layers) + 1; }

    /// L_m: rows along the last column of C_m.
    Result<void> walk_corner(std::size_t m) {
        std::vector<int> row(middles_[m].end() - static_cast<std::ptrdiff_t>(width()),
                             middles_[m].end());
        std::vector<int>& block = corners_.emplace_back();
        for (std::size_t b = 0; b < width(); ++b) {
            if (row.size() != width()) {
                return fail(ErrorCode::Refused,
                            "the corner of the hole at vertex {} has {} layers on one side of it "
                            "and {} on the other",
                            middles_[m][middles_[m].size() - width()] + 1, star_.layers, b - 1);
            }
            block.insert(block.end(), row.begin(), row.end());
            // Rows of C_m turn left, those of L_m are read outwards: the quads lie to the left of
            // a -> b here.
            std::vector<int> turned(row.rbegin(), row.rend());
            turned = next_row(turned);
            row.assign(turned.rbegin(), turned.rend());
        }
        return {};
    }

    Result<void> join() {
        const std::size_t n = middles_.size();
        for (std::size_t m = 0; m < n; ++m) {
            if (auto done = walk_corner(m); !done) {
                return done;
            }
        }
        std::set<int> seen;
        for (std::size_t m = 0; m < n; ++m) {
            const std::vector<int>& before = corners_[(m + n - 1) % n];
            std::vector<int>& grid = star_.grids.emplace_back();
            // (i, j) of L_(m-1) as side m sees it is its (s' - j, i).
            for (std::size_t j = 0; j < width(); ++j) {
                for (std::size_t i = 0; i < width(); ++i) {
                    grid.push_back(before[width() - 1 - j + width() * i]);
                }
            }
            const std::vector<int> first(grid.end() - static_cast<std::ptrdiff_t>(width()),
                                         grid.end());
            if (!std::equal(first.begin(), first.end(), middles_[m].begin())) {
                return fail(ErrorCode::Refused,
                            "the rows of the hole's sides do not meet at its corner at vertex {}",
                            middles_[m].front() + 1);
            }
            const auto skip = static_cast<std::ptrdiff_t>(width());
            grid.insert(grid.end(), middles_[m].begin() + skip, middles_[m].end());
            grid.insert(grid.end(), corners_[m].begin() + skip, corners_[m].end());
            seen.insert(grid.begin(), grid.end());
        }
        if (seen.size() != edges_.neighbours().size()) {
            return fail(ErrorCode::Refused, "{} of {} vertices lie in no layer around the hole",
                        edges_.neighbours().size() - seen.size(), edges_.neighbours().size());
        }
        return {};
    }
};

}  // namespace

StarSize StarMesh::size(int k, double aperture) const {
    StarSize size;
    size.k = k;
    size.aperture = aperture;
    const int odd = k % 2;
    size.layers = layers + odd;
    for (const int intervals : columns) {
        size.columns.push_back(intervals - odd);
    }
    return size;
}

Eigen::Matrix3Xd StarMesh::points(const Star& star) const {
    Eigen::Matrix3Xd points(3, star.count());
    for (int m = 0; m < star.n(); ++m) {
        for (int j = 0; j < star.charts_y(m); ++j) {
            for (int i = 0; i < star.charts_x(); ++i) {
                const auto slot = static_cast<std::size_t>(i + star.charts_x() * j);
                points.col(star.point_of(m, i, j)) =
                    mesh.vertices.col(grids[static_cast<std::size_t>(m)][slot]);
            }
        }
    }
    return points;
}

Result<StarMesh> recognise_star(PolygonMesh mesh) {
    const auto quads = quads_of(mesh);
    if (!quads) {
        return tl::unexpected(quads.error());
    }
    const auto edges = HalfEdges::make(*quads);
    if (!edges) {
        return tl::unexpected(edges.error());
    }
    StarMesh star;
    star.mesh = std::move(mesh);
    if (auto walked = Walk(*edges, star).run(); !walked) {
        return tl::unexpected(walked.error());
    }
    return star;
}

}  // namespace suture::manifold
