#include "suture/fill/concentric/medial.h"

#include <Eigen/Geometry>

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace suture::concentric {

/// A side as Boost.Polygon wants it.
struct GridSegment {
    boost::polygon::point_data<std::int32_t> a, b;
};

}  // namespace suture::concentric

template <>
struct boost::polygon::geometry_concept<suture::concentric::GridSegment> {
    using type = segment_concept;  // NOLINT: Boost's name
};

template <>
struct boost::polygon::segment_traits<suture::concentric::GridSegment> {
    using coordinate_type = std::int32_t;         // NOLINT
    using point_type = point_data<std::int32_t>;  // NOLINT
    static point_type get(const suture::concentric::GridSegment& segment, const direction_1d& end) {
        return end.to_int() != 0 ? segment.b : segment.a;
    }
};

namespace suture::concentric {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;
using Cell = Diagram::cell_type;
using Eigen::Vector2d;

/// On the bisector of a reflex vertex' normals, and how near to it a node need not be split.
constexpr double kHalf = 0.5;
constexpr double kAtHalf = 1e-3;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The walk under construction, in grid coordinates.
class Walk {
  public:
    Walk(const Sites& sites, double widest, double same_place)
        : sites_(sites), widest_(widest), same_place_(same_place) {
        std::vector<GridSegment> segments;
        const int n = sites.count();
        for (int i = 0; i < n; ++i) {
            const auto& a = sites.vertices[static_cast<std::size_t>(i)];
            const auto& b = sites.vertices[static_cast<std::size_t>((i + 1) % n)];
            segments.push_back({{a.x, a.y}, {b.x, b.y}});
        }
        boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram_);
        sides_.resize(static_cast<std::size_t>(n), nullptr);
        points_.resize(static_cast<std::size_t>(n), nullptr);
        for (const Cell& cell : diagram_.cells()) {
            auto& row = cell.contains_segment() ? sides_ : points_;
            row[static_cast<std::size_t>(site_of(cell))] = &cell;
        }
        for (const auto& vertex : diagram_.vertices()) {
            grid_.emplace_back(vertex.x(), vertex.y());
        }
    }

    [[nodiscard]] Result<MedialAxis> make() {
        for (int i = 0; i < sites_.count(); ++i) {
            if (sites_.vertices[static_cast<std::size_t>(i)].reflex) {
                around_vertex(i);
            }
            along_side(i);
        }
        if (broken_ || walk_.empty()) {
            return fail(ErrorCode::Refused,
                        "the Voronoi diagram of the control polygon is not connected near s = "
                        "{:.6g}",
                        sites_.parameter(std::max(where_, 0), 0.5));
        }
        split_at_bisectors();
        return finished();
    }

  private:
    const Sites& sites_;
    double widest_;
    double same_place_;
    Diagram diagram_;
    std::vector<const Cell*> sides_, points_;
    std::vector<Vector2d> grid_;  ///< the diagram's vertices, then points on parabolas
    std::map<const Edge*, std::vector<int>> chords_;
    std::vector<Visit> walk_;
    bool broken_ = false;
    int where_ = -1;

    /// The index of the side, or of the vertex, whose cell it is.
    [[nodiscard]] int site_of(const Cell& cell) const {
        const auto index = static_cast<int>(cell.source_index());
        const bool end =
            cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT;
        return end ? (index + 1) % sites_.count() : index;
    }

    [[nodiscard]] int vertex_of(const Diagram::vertex_type* vertex) const {
        return static_cast<int>(vertex - diagram_.vertices().data());
    }

    [[nodiscard]] const Vector2d& at(int node) const {
        return grid_[static_cast<std::size_t>(node)];
    }

    /// The axis' part of a cell's boundary in the direction of increasing parameter, which is
    /// clockwise around the cell. A side's cell lies on both its sides: the inner one counts.
    [[nodiscard]] std::vector<const Edge*> chain(const Cell* cell) const {
        std::vector<const Edge*> found;
        if (cell == nullptr) {
            return found;
        }
        const Edge* const first = cell->incident_edge();
        const Edge* edge = first;
        do {
            if (edge->is_primary() && edge->is_finite() && inside(*edge)) {
                found.push_back(edge);
            }
            edge = edge->prev();
        } while (edge != first);
        // The run is cyclic: it begins after the gap.
        for (std::size_t k = 1; k < found.size(); ++k) {
            if (found[k - 1]->vertex0() != found[k]->vertex1()) {
                std::rotate(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(k),
                            found.end());
                break;
            }
        }
        return found;
    }

    [[nodiscard]] bool inside(const Edge& edge) const {
        const Cell& cell = *edge.cell();
        if (!cell.contains_segment()) {
            return sites_.vertices[static_cast<std::size_t>(site_of(cell))].reflex;
        }
        const int side = site_of(cell);
        const Vector2d a = sites_.grid(side);
        const Vector2d along = sites_.grid(side + 1) - a;
        const double h0 = cross(along, at(vertex_of(edge.vertex0())) - a);
        const double h1 = cross(along, at(vertex_of(edge.vertex1())) - a);
        return std::abs(h0) > std::abs(h1) ? h0 > 0.0 : h1 > 0.0;
    }

    /// The nodes along an edge in the chain's direction, with those on a parabola's arc.
    [[nodiscard]] std::vector<int> nodes_of(const Edge& edge) {
        std::vector<int> nodes = {vertex_of(edge.vertex1()), vertex_of(edge.vertex0())};
        if (!edge.is_curved()) {
            return nodes;
        }
        if (const auto known = chords_.find(edge.twin()); known != chords_.end()) {
            nodes.insert(nodes.begin() + 1, known->second.rbegin(), known->second.rend());
            return nodes;
        }
        const Cell& one = *edge.cell();
        const Cell& two = *edge.twin()->cell();
        const Vector2d focus = sites_.grid(site_of(one.contains_segment() ? two : one));
        const int side = site_of(one.contains_segment() ? one : two);
        const std::vector<int> inner = on_parabola(focus, side, at(nodes[0]), at(nodes[1]));
        nodes.insert(nodes.begin() + 1, inner.begin(), inner.end());
        chords_.emplace(&edge, inner);
        return nodes;
    }

    /// Points at equal angles as seen from the focus: the parabola with that focus and the side as
    /// directrix at distance d is r = d / (1 + cos(angle from the directrix' normal)).
    std::vector<int> on_parabola(const Vector2d& focus, int side, const Vector2d& from,
                                 const Vector2d& to) {
        const Vector2d a = sites_.grid(side);
        const Vector2d along = (sites_.grid(side + 1) - a).normalized();
        const Vector2d foot = a + along * along.dot(focus - a);
        const double distance = (foot - focus).norm();
        const Vector2d down = (foot - focus) / distance;
        const auto angle = [&](const Vector2d& x) {
            return std::atan2(along.dot(x - focus), down.dot(x - focus));
        };
        const double first = angle(from);
        const double last = angle(to);
        // The parabola's vertex, its nearest point, is a node wherever it is on the arc.
        std::vector<double> angles = {first, last};
        if (first * last < 0.0) {
            angles.insert(angles.begin() + 1, 0.0);
        }
        std::vector<int> inner;
        for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
            const double step = angles[i + 1] - angles[i];
            const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(step) / widest_)));
            for (int k = i == 0 ? 1 : 0; k < pieces; ++k) {
                const double phi = angles[i] + step * k / pieces;
                const double r = distance / (1.0 + std::cos(phi));
                inner.push_back(static_cast<int>(grid_.size()));
                grid_.emplace_back(focus + r * (std::cos(phi) * down + std::sin(phi) * along));
            }
        }
        return inner;
    }

    [[nodiscard]] std::vector<int> nodes_of(const std::vector<const Edge*>& edges) {
        std::vector<int> nodes;
        for (const Edge* edge : edges) {
            const std::vector<int> more = nodes_of(*edge);
            broken_ = broken_ || (!nodes.empty() && nodes.back() != more.front());
            nodes.insert(nodes.end(), more.begin() + (nodes.empty() ? 0 : 1), more.end());
        }
        return nodes;
    }

    /// A side's own nodes: those that it shares with the cell of a reflex vertex are that one's.
    void along_side(int side) {
        const std::vector<int> nodes = nodes_of(chain(sides_[static_cast<std::size_t>(side)]));
        note_break(side);
        const auto reflex = [&](int i) {
            return sites_.vertices[static_cast<std::size_t>(i % sites_.count())].reflex;
        };
        const std::size_t first = reflex(side) ? 1 : 0;
        const std::size_t last = nodes.size() - (reflex(side + 1) && !nodes.empty() ? 1 : 0);
        double least = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            least = std::max(least, fraction_on(side, nodes[k]));
            walk_.push_back({nodes[k], side, false, sites_.parameter(side, least)});
        }
    }

    void around_vertex(int vertex) {
        const std::vector<int> nodes = nodes_of(chain(points_[static_cast<std::size_t>(vertex)]));
        note_break(vertex);
        double least = 0.0;
        for (const int node : nodes) {
            least = std::max(least, fraction_at(vertex, node));
            walk_.push_back({node, vertex, true, nodes.size() == 1 ? kHalf : least});
        }
    }

    void note_break(int site) {
        if (broken_ && where_ < 0) {
            where_ = site;
        }
    }

    /// A reflex vertex sees its chain in the direction of one side as long as it stays before the
    /// bisector of the two normals, then in that of the other: there has to be a node between.
    void split_at_bisectors() {
        std::map<std::pair<int, int>, std::vector<int>> splits;
        for (std::size_t k = 0; k + 1 < walk_.size(); ++k) {
            const Visit& a = walk_[k];
            const Visit& b = walk_[k + 1];
            if (a.at_vertex && b.at_vertex && a.site == b.site && a.node != b.node &&
                a.place < kHalf - kAtHalf && b.place > kHalf + kAtHalf) {
                const Vector2d v = sites_.grid(a.site);
                const auto [before, after] = sides_at(a.site);
                const Vector2d ray = normal(before).normalized() + normal(after).normalized();
                const double ha = cross(ray, at(a.node) - v);
                const double hb = cross(ray, at(b.node) - v);
                const double f = ha / (ha - hb);
                splits[std::minmax(a.node, b.node)].push_back(static_cast<int>(grid_.size()));
                grid_.emplace_back((1.0 - f) * at(a.node) + f * at(b.node));
            }
        }
        std::vector<Visit> walk;
        for (std::size_t k = 0; k < walk_.size(); ++k) {
            const Visit& a = walk_[k];
            const Visit& b = walk_[(k + 1) % walk_.size()];
            walk.push_back(a);
            const auto found = splits.find(std::minmax(a.node, b.node));
            if (found == splits.end() || a.node == b.node) {
                continue;
            }
            std::vector<int> inner = found->second;
            std::sort(inner.begin(), inner.end(), [&](int x, int y) {
                return (at(x) - at(a.node)).norm() < (at(y) - at(a.node)).norm();
            });
            for (const int node : inner) {
                walk.push_back(visit_between(a, b, node));
            }
        }
        walk_ = std::move(walk);
    }

    /// The visit of a node on the edge from one visit to the next: in the cell of the edge.
    [[nodiscard]] Visit visit_between(const Visit& a, const Visit& b, int node) const {
        if (a.at_vertex && b.at_vertex && a.site == b.site) {
            return {node, a.site, true, std::clamp(fraction_at(a.site, node), a.place, b.place)};
        }
        const int side = a.at_vertex && !b.at_vertex ? b.site : a.site;
        return {node, side, false, sites_.parameter(side, fraction_on(side, node))};
    }

    /// The directions of the sides before and after a vertex.
    [[nodiscard]] std::pair<Vector2d, Vector2d> sides_at(int vertex) const {
        const Vector2d v = sites_.grid(vertex);
        return {v - sites_.grid(vertex + sites_.count() - 1), sites_.grid(vertex + 1) - v};
    }

    static Vector2d normal(const Vector2d& side) { return {-side.y(), side.x()}; }

    /// How far along a side the foot of a node is.
    [[nodiscard]] double fraction_on(int side, int node) const {
        const Vector2d a = sites_.grid(side);
        const Vector2d along = sites_.grid(side + 1) - a;
        return std::clamp(along.dot(at(node) - a) / along.squaredNorm(), 0.0, 1.0);
    }

    /// How far a node is from the normal of the side before a vertex to that of the side after.
    [[nodiscard]] double fraction_at(int vertex, int node) const {
        const auto [before, after] = sides_at(vertex);
        const double whole = std::atan2(-cross(before, after), before.dot(after));
        const Vector2d d = at(node) - sites_.grid(vertex);
        return std::clamp(std::atan2(before.dot(d), cross(before, d)) / whole, 0.0, 1.0);
    }

    /// Nodes at the same place become one.
    [[nodiscard]] Result<MedialAxis> finished() const {
        std::vector<int> same(grid_.size());
        std::iota(same.begin(), same.end(), 0);
        const auto root = [&](int i) {
            while (same[static_cast<std::size_t>(i)] != i) {
                i = same[static_cast<std::size_t>(i)];
            }
            return i;
        };
        for (std::size_t k = 0; k < walk_.size(); ++k) {
            const int a = root(walk_[k].node);
            const int b = root(walk_[(k + 1) % walk_.size()].node);
            if (a != b && (at(a) - at(b)).norm() < same_place_) {
                same[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
            }
        }
        MedialAxis axis;
        std::vector<int> number(grid_.size(), -1);
        for (const Visit& visit : walk_) {
            const int node = root(visit.node);
            int& name = number[static_cast<std::size_t>(node)];
            if (name < 0) {
                name = static_cast<int>(axis.nodes.size());
                axis.nodes.push_back({sites_.point(at(node)), radius(visit, at(node))});
            }
            axis.walk.push_back(visit);
            axis.walk.back().node = name;
        }
        if (const int at = unmatched(axis); at >= 0) {
            const Vector2d& where = axis.nodes[static_cast<std::size_t>(at)].point;
            return fail(ErrorCode::Refused,
                        "the medial axis is no tree near ({:.6g}, {:.6g}): two parts of the "
                        "boundary nearly touch",
                        where.x(), where.y());
        }
        return axis;
    }

    /// A node from which an edge is not walked once in each direction, or -1.
    [[nodiscard]] static int unmatched(const MedialAxis& axis) {
        std::map<std::pair<int, int>, int> balance;
        for (std::size_t k = 0; k < axis.walk.size(); ++k) {
            const int a = axis.walk[k].node;
            const int b = axis.walk[(k + 1) % axis.walk.size()].node;
            if (a != b) {
                ++balance[{a, b}];
            }
        }
        for (const auto& [edge, count] : balance) {
            const auto back = balance.find({edge.second, edge.first});
            if (count != 1 || back == balance.end()) {
                return edge.first;
            }
        }
        return -1;
    }

    [[nodiscard]] double radius(const Visit& visit, const Vector2d& x) const {
        const Vector2d d = x - sites_.grid(visit.site);
        const Vector2d along = sites_.grid(visit.site + 1) - sites_.grid(visit.site);
        return (visit.at_vertex ? d.norm() : std::abs(cross(along, d)) / along.norm()) /
               sites_.scale;
    }
};

}  // namespace

Result<MedialAxis> medial_axis(const Sites& sites, double widest, double same_place) {
    return Walk(sites, widest, same_place).make();
}

}  // namespace suture::concentric
