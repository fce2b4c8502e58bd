#include "suture/fill/concentric/basic.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;

/// Where c has to come by: `place` counts the walk's stays, with fractions between two of them.
struct Mark {
    double place = 0.0;
    int node = 0;
    std::optional<double> parameter;  ///< of the vertex that it is the image of
};

/// A stay of the walk: consecutive visits of one node.
struct Stay {
    int node = 0;
    int first = 0;
    int last = 0;
};

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

struct Nearest {
    double distance = INFINITY;
    double fraction = 0.0;
};

Nearest nearest_on(const Vector2d& x, const Vector2d& a, const Vector2d& b) {
    const double length2 = (b - a).squaredNorm();
    const double f = length2 > 0.0 ? std::clamp((x - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
    return {(x - a - f * (b - a)).norm(), f};
}

class Basic {
  public:
    Basic(const MedialAxis& axis, const Sites& sites) : axis_(axis), sites_(sites) {
        const auto visits = static_cast<int>(axis.walk.size());
        int start = 0;
        while (axis.walk[static_cast<std::size_t>(start)].node ==
               axis.walk[static_cast<std::size_t>((start + visits - 1) % visits)].node) {
            ++start;
        }
        for (int k = start; k < start + visits; ++k) {
            const int node = visit(k).node;
            if (!stays_.empty() && stays_.back().node == node) {
                stays_.back().last = k;
            } else {
                stays_.push_back({node, k, k});
            }
        }
        degree_.resize(axis.nodes.size(), 0);
        for (const Stay& stay : stays_) {
            ++degree_[static_cast<std::size_t>(stay.node)];
        }
        for (const MedialNode& node : axis.nodes) {
            nodes_.push_back(node.point);
        }
    }

    [[nodiscard]] ConcentricCurve make() {
        for (int k = 0; k < count(); ++k) {
            if (degree(k) >= 3) {
                marks_.push_back({static_cast<double>(k), stay(k).node, std::nullopt});
            }
        }
        for (int v = 0; v < sites_.count(); ++v) {
            if (sites_.vertices[static_cast<std::size_t>(v)].reflex) {
                map_reflex(v);
            }
        }
        cut_seams();
        return timed();
    }

  private:
    const MedialAxis& axis_;
    const Sites& sites_;
    std::vector<Stay> stays_;
    std::vector<int> degree_;
    std::vector<Vector2d> nodes_;
    std::vector<Mark> marks_;

    [[nodiscard]] int count() const { return static_cast<int>(stays_.size()); }
    [[nodiscard]] const Visit& visit(int k) const {
        return axis_.walk[static_cast<std::size_t>(k) % axis_.walk.size()];
    }
    [[nodiscard]] const Stay& stay(int k) const {
        return stays_[static_cast<std::size_t>((k % count() + count()) % count())];
    }
    [[nodiscard]] int degree(int k) const {
        return degree_[static_cast<std::size_t>(stay(k).node)];
    }
    [[nodiscard]] const Vector2d& point(int k) const {
        return nodes_[static_cast<std::size_t>(stay(k).node)];
    }
    void sort() {
        std::stable_sort(marks_.begin(), marks_.end(),
                         [](const Mark& a, const Mark& b) { return a.place < b.place; });
    }

    /// A convex corner's image is the closest concentric vertex along its seam: a branch point, or
    /// the image of a reflex vertex before it (step 4).
    void cut_seams() {
        std::vector<Mark> corners;
        for (int leaf = 0; leaf < count(); ++leaf) {
            if (degree(leaf) != 1) {
                continue;
            }
            // On the way back from the corner the walk comes by the same ones as on the way there.
            const auto next = std::find_if(marks_.begin(), marks_.end(),
                                           [&](const Mark& mark) { return mark.place > leaf; });
            const Mark& image = next == marks_.end() ? marks_.front() : *next;
            const Sites::Vertex& corner =
                sites_.vertices[static_cast<std::size_t>(visit(stay(leaf).last).site)];
            corners.push_back(
                {static_cast<double>(leaf), image.node, 0.5 * (corner.before + corner.after)});
        }
        marks_.insert(marks_.end(), corners.begin(), corners.end());
        sort();
    }

    /// The stays that border on a reflex vertex' cell: a cyclic range.
    [[nodiscard]] std::pair<int, int> range_of(int vertex) const {
        const auto at_vertex = [&](int k) {
            for (int v = stay(k).first; v <= stay(k).last; ++v) {
                if (visit(v).at_vertex && visit(v).site == vertex) {
                    return true;
                }
            }
            return false;
        };
        int first = 0;
        while (first < count() && !(at_vertex(first) && !at_vertex(first + count() - 1))) {
            ++first;
        }
        int last = first;
        while (last + 1 < first + count() && at_vertex(last + 1)) {
            ++last;
        }
        return {first, last};
    }

    void map_reflex(int vertex) {
        const Sites::Vertex& v = sites_.vertices[static_cast<std::size_t>(vertex)];
        const double s = 0.5 * (v.before + v.after);
        const Vector2d x = sites_.point(sites_.grid(vertex));
        const auto [first, last] = range_of(vertex);
        if (Mark* found = nearest_mark(x, first, last)) {
            Mark image = *found;
            image.parameter = s;
            if (found->parameter) {
                // Beside another reflex vertex whose image it is as well.
                image.place = found->place < first ? first : last;
                marks_.push_back(image);
            } else {
                *found = image;
            }
        } else {
            insert_image(x, s, first, last);
        }
        sort();
    }

    [[nodiscard]] Mark* nearest_mark(const Vector2d& x, int first, int last) {
        Mark* best = nullptr;
        double distance = INFINITY;
        for (Mark& mark : marks_) {
            const double place = mark.place < first ? mark.place + count() : mark.place;
            const double d = (nodes_[static_cast<std::size_t>(mark.node)] - x).norm();
            if (place >= first && place <= last && d < distance) {
                distance = d;
                best = &mark;
            }
        }
        return best;
    }

    /// Whether the edge after stay k, in the cell of a vertex, has a vertex' cell on its other
    /// side.
    [[nodiscard]] bool straight(int k) const {
        for (int m = 0; m < count(); ++m) {
            if (stay(m).node == stay(k + 1).node && stay(m + 1).node == stay(k).node) {
                const Visit& a = visit(stay(m).last);
                const Visit& b = visit(stay(m + 1).first);
                return a.at_vertex && b.at_vertex && a.site == b.site;
            }
        }
        return false;
    }

    /// The nearest point of the range becomes a node, on both its sides.
    void insert_image(const Vector2d& x, double s, int first, int last) {
        Nearest best;
        int edge = first;
        for (int k = first; k < last; ++k) {
            Nearest here = nearest_on(x, point(k), point(k + 1));
            if (!straight(k)) {
                // A chord of a parabola is nearer than the arc that it stands for.
                const double to_start = (point(k) - x).norm();
                const double to_end = (point(k + 1) - x).norm();
                here = to_start < to_end ? Nearest{to_start, 0.0} : Nearest{to_end, 1.0};
            }
            if (here.distance < best.distance) {
                best = here;
                edge = k;
            }
        }
        const auto node = static_cast<int>(nodes_.size());
        const double f = best.fraction;
        const int a = stay(edge).node;
        const int b = stay(first == last ? edge : edge + 1).node;
        const double place = std::fmod(edge + f, count());
        nodes_.push_back((1.0 - f) * nodes_[static_cast<std::size_t>(a)] +
                         f * nodes_[static_cast<std::size_t>(b)]);
        marks_.push_back({place, node, s});
        for (int k = 0; k < count(); ++k) {
            if (stay(k).node == b && stay(k + 1).node == a) {
                marks_.push_back({k + 1.0 - f, node, std::nullopt});
            }
        }
    }

    /// Parameters for the marks without one: by length between those that have one.
    [[nodiscard]] ConcentricCurve timed() const {
        ConcentricCurve curve;
        curve.nodes = nodes_;
        curve.period = sites_.period;
        const auto n = static_cast<int>(marks_.size());
        const auto mark = [&](int k) -> const Mark& {
            return marks_[static_cast<std::size_t>(k % n)];
        };
        const auto at = [&](int k) -> const Vector2d& {
            return nodes_[static_cast<std::size_t>(mark(k).node)];
        };
        int first = 0;
        while (first < n && !mark(first).parameter) {
            ++first;
        }
        SUTURE_EXPECTS(first < n);
        double base = *mark(first).parameter;
        for (int k = first; k < first + n;) {
            int next = k + 1;
            double length = (at(next) - at(k)).norm();
            for (; !mark(next).parameter; ++next) {
                length += (at(next + 1) - at(next)).norm();
            }
            double end = *mark(next).parameter;
            while (end < base || (end == base && next == first + n)) {
                end += curve.period;
            }
            double walked = 0.0;
            for (int i = k; i < next; ++i) {
                const double f = length > 0.0 ? walked / length : 0.0;
                add(curve, mark(i).node, base + f * (end - base));
                walked += (at(i + 1) - at(i)).norm();
            }
            base = end;
            k = next;
        }
        return curve;
    }

    static void add(ConcentricCurve& curve, int node, double s) {
        if (!curve.stops.empty() && curve.stops.back().node == node) {
            curve.stops.back().to = s;
        } else {
            curve.stops.push_back({node, s, s});
        }
    }
};

/// Nodes that have come to the same place are one, where c rests.
void merge_nodes(ConcentricCurve& curve) {
    Vector2d low = curve.nodes.front();
    Vector2d high = low;
    for (const Vector2d& node : curve.nodes) {
        low = low.cwiseMin(node);
        high = high.cwiseMax(node);
    }
    constexpr double kSame = 1e-6;
    const double same = kSame * (high - low).norm();
    const auto first_at = [&](int number) {
        const Vector2d& node = curve.nodes[static_cast<std::size_t>(number)];
        const auto found =
            std::find_if(curve.nodes.begin(), curve.nodes.end(),
                         [&](const Vector2d& other) { return (other - node).norm() <= same; });
        return static_cast<int>(found - curve.nodes.begin());
    };
    std::vector<Stop> stops;
    for (Stop stop : curve.stops) {
        stop.node = first_at(stop.node);
        if (!stops.empty() && stops.back().node == stop.node) {
            stops.back().to = stop.to;
        } else {
            stops.push_back(stop);
        }
    }
    if (stops.size() > 1 && stops.front().node == stops.back().node) {
        stops.front().from = stops.back().from - curve.period;
        stops.pop_back();
    }
    curve.stops = std::move(stops);
}

}  // namespace

ConcentricCurve basic_axis(const MedialAxis& axis, const Sites& sites) {
    ConcentricCurve curve = Basic(axis, sites).make();
    // The walk may begin in the middle of a stay.
    if (curve.count() > 1 && curve.stops.front().node == curve.stops.back().node) {
        curve.stops.front().from = curve.stops.back().from - curve.period;
        curve.stops.pop_back();
    }
    return curve;
}

ConcentricCurve moved_onto(const ConcentricCurve& coarse, const ConcentricCurve& fine) {
    ConcentricCurve moved = coarse;
    const std::vector<Course> edges = courses(fine);
    for (Vector2d& node : moved.nodes) {
        Nearest best;
        Vector2d to = node;
        for (const Course& edge : edges) {
            const Vector2d& a = fine.nodes[static_cast<std::size_t>(edge.start)];
            const Vector2d& b = fine.nodes[static_cast<std::size_t>(edge.end)];
            const Nearest here = nearest_on(node, a, b);
            if (here.distance < best.distance) {
                best = here;
                to = (1.0 - here.fraction) * a + here.fraction * b;
            }
        }
        node = to;
    }
    merge_nodes(moved);
    return moved;
}

std::vector<int> courses_outside(const BoundaryPieces& boundary, const ConcentricCurve& curve,
                                 int chords) {
    std::vector<Vector2d> around;
    for (const BezierPiece& piece : boundary.all()) {
        for (int k = 0; k < chords; ++k) {
            around.push_back(boundary.at(piece.from + (piece.to - piece.from) * k / chords));
        }
    }
    const auto inside = [&](const Vector2d& x) {
        bool odd = false;
        for (std::size_t i = 0; i < around.size(); ++i) {
            const Vector2d& a = around[i];
            const Vector2d& b = around[(i + 1) % around.size()];
            if ((a.y() > x.y()) != (b.y() > x.y()) &&
                x.x() < a.x() + (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y())) {
                odd = !odd;
            }
        }
        return odd;
    };
    const auto crosses = [&](const Vector2d& p, const Vector2d& q) {
        for (std::size_t i = 0; i < around.size(); ++i) {
            const Vector2d& a = around[i];
            const Vector2d& b = around[(i + 1) % around.size()];
            if (cross(q - p, a - p) * cross(q - p, b - p) < 0.0 &&
                cross(b - a, p - a) * cross(b - a, q - a) < 0.0) {
                return true;
            }
        }
        return false;
    };
    std::vector<int> outside;
    const std::vector<Course> all = courses(curve);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Vector2d& p = curve.nodes[static_cast<std::size_t>(all[k].start)];
        const Vector2d& q = curve.nodes[static_cast<std::size_t>(all[k].end)];
        if (!inside(p) || crosses(p, q)) {
            outside.push_back(static_cast<int>(k));
        }
    }
    return outside;
}

}  // namespace suture::concentric
