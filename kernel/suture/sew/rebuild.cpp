#include "suture/sew/rebuild.h"

#include "suture/occ/convert.h"
#include "suture/sew/common_edge.h"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopAbs.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <map>

namespace suture {

namespace {

/// One common edge as it stands in one of the two edges that it comes from.
struct Insert {
    double first = 0.0;
    double last = 0.0;
    TopoDS_Edge edge;  ///< oriented as the old edge runs
};

class Rebuilder {
  public:
    Rebuilder(const ShellGraph& graph, const std::vector<FreeEdge>& edges, const Places& places,
              const SewMatcher& matches)
        : graph_(graph), edges_(edges), places_(places), inserts_(edges.size()) {
        result_.sewn.assign(graph.faces.size(), false);
        for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
            free_edge_of_.Bind(graph.uses[edges[e].use].edge, e);
        }
        make_vertices(matches);
        for (const SewPair& pair : matches.pairs()) {
            make_common_edge(pair);
        }
        for (const int edge : matches.collapsed()) {
            gone_.push_back(edge);
            result_.sewn[edges[edge].face] = true;
            ++result_.points;
        }
    }

    RebuiltFaces run() {
        for (const TopoDS_Face& face : graph_.faces) {
            // one that bounds two bodies stands there twice
            if (!rebuilt_.IsBound(face)) {
                rebuilt_.Bind(face, rebuilt(TopoDS::Face(face.Oriented(TopAbs_FORWARD))));
            }
            result_.faces.push_back(TopoDS::Face(rebuilt_.Find(face).Oriented(face.Orientation())));
        }
        return std::move(result_);
    }

  private:
    /// One vertex per place that a pair or a collapsed edge ends in: an old one where it will do.
    void make_vertices(const SewMatcher& matches) {
        std::map<int, std::vector<int>> points;
        for (const SewPair& pair : matches.pairs()) {
            points[places_.of(pair.kept.start)];
            points[places_.of(pair.kept.end)];
        }
        for (const int edge : matches.collapsed()) {
            points[places_.of(edges_[edge].ends[0])];
        }
        for (int i = 0; i < places_.count(); ++i) {
            const auto found = points.find(places_.of(i));
            if (found != points.end()) {
                found->second.push_back(i);
            }
        }
        for (const auto& [place, members] : points) {
            const TopoDS_Vertex vertex = common_vertex(members);
            vertex_of_place_[place] = vertex;
            for (const int i : members) {
                if (!places_.vertex(i).IsNull() && !places_.vertex(i).IsSame(vertex)) {
                    vertex_of_.Bind(places_.vertex(i), vertex);
                }
            }
        }
    }

    [[nodiscard]] TopoDS_Vertex common_vertex(const std::vector<int>& members) const {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const int i : members) {
            mean += places_.point(i) / static_cast<double>(members.size());
        }
        const int nearest = *std::min_element(members.begin(), members.end(), [&](int a, int b) {
            return (places_.point(a) - mean).norm() < (places_.point(b) - mean).norm();
        });
        const Eigen::Vector3d& at = places_.point(nearest);
        double tolerance = Precision::Confusion();
        for (const int i : members) {
            const TopoDS_Vertex& vertex = places_.vertex(i);
            const double own = vertex.IsNull() ? 0.0 : BRep_Tool::Tolerance(vertex);
            tolerance = std::max(tolerance, own + (places_.point(i) - at).norm());
        }
        const TopoDS_Vertex& known = places_.vertex(nearest);
        if (!known.IsNull() && BRep_Tool::Tolerance(known) >= tolerance) {
            return TopoDS::Vertex(known.Oriented(TopAbs_FORWARD));
        }
        TopoDS_Vertex vertex;
        BRep_Builder().MakeVertex(vertex, occ::to_point(at), tolerance);
        return vertex;
    }

    [[nodiscard]] TopoDS_Vertex new_vertex(const TopoDS_Vertex& old) const {
        return vertex_of_.IsBound(old) ? TopoDS::Vertex(vertex_of_.Find(old)) : old;
    }

    /// A forward copy of an edge from one vertex to another, with the edge's curves.
    static TopoDS_Edge copied(const TopoDS_Edge& edge, const TopoDS_Vertex& start,
                              const TopoDS_Vertex& end) {
        const BRep_Builder builder;
        TopoDS_Edge copy = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD).EmptyCopied());
        copy.Orientation(TopAbs_FORWARD);
        builder.Add(copy, start.Oriented(TopAbs_FORWARD));
        builder.Add(copy, end.Oriented(TopAbs_REVERSED));
        copy.Closed(start.IsSame(end));
        return copy;
    }

    [[nodiscard]] TopoDS_Edge part_of(int edge, double first, double last,
                                      const TopoDS_Vertex& start, const TopoDS_Vertex& end) const {
        const TopoDS_Edge& whole = graph_.uses[edges_[edge].use].edge;
        TopoDS_Edge part = copied(whole, start, end);
        if (first > edges_[edge].first() || last < edges_[edge].last()) {
            if (!BRep_Tool::SameRange(part)) {
                BRepLib::SameRange(part);
            }
            BRep_Builder().Range(part, first, last);
        }
        return part;
    }

    void make_common_edge(const SewPair& pair) {
        const auto part = [&](const SewPiece& piece) {
            const Coedge& use = graph_.uses[edges_[piece.edge].use];
            return EdgePart{use.edge, graph_.faces[use.face], piece.first, piece.last};
        };
        TopoDS_Vertex start = vertex_of_place_[places_.of(pair.kept.start)];
        TopoDS_Vertex end = vertex_of_place_[places_.of(pair.kept.end)];
        TopoDS_Edge common = part_of(pair.kept.edge, pair.kept.first, pair.kept.last, start, end);
        const auto distance =
            add_other_face(part(pair.kept), part(pair.gone), pair.same_way, pair.gap, common);
        if (!distance) {
            return;
        }
        cover(start, edges_[pair.kept.edge].point(pair.kept.first), BRep_Tool::Tolerance(common));
        cover(end, edges_[pair.kept.edge].point(pair.kept.last), BRep_Tool::Tolerance(common));
        ++result_.pairs;
        result_.largest_gap = std::max(result_.largest_gap, pair.gap);
        result_.sewn[edges_[pair.kept.edge].face] = true;
        result_.sewn[edges_[pair.gone.edge].face] = true;
        inserts_[pair.kept.edge].push_back({pair.kept.first, pair.kept.last, common});
        inserts_[pair.gone.edge].push_back(
            {pair.gone.first, pair.gone.last,
             pair.same_way ? common : TopoDS::Edge(common.Reversed())});
    }

    static void cover(TopoDS_Vertex& vertex, const Eigen::Vector3d& end, double tolerance) {
        const double apart = (occ::from_occ(BRep_Tool::Pnt(vertex)) - end).norm();
        BRep_Builder().UpdateVertex(vertex, std::max(apart, tolerance));
    }

    /// What stands in the place of an edge, in the order and the direction of its curve.
    [[nodiscard]] std::vector<TopoDS_Edge> replacement(const TopoDS_Edge& old) {
        if (const int* known = replacement_of_.Seek(old)) {
            return replacements_[*known];
        }
        std::vector<TopoDS_Edge> result = make_replacement(old);
        replacement_of_.Bind(old, static_cast<int>(replacements_.size()));
        replacements_.push_back(result);
        return result;
    }

    [[nodiscard]] std::vector<TopoDS_Edge> make_replacement(const TopoDS_Edge& old) {
        const TopoDS_Vertex start = TopExp::FirstVertex(old);
        const TopoDS_Vertex end = TopExp::LastVertex(old);
        const int* free = free_edge_of_.Seek(old);
        if (free != nullptr && std::find(gone_.begin(), gone_.end(), *free) != gone_.end()) {
            return {};
        }
        if (free == nullptr || inserts_[*free].empty()) {
            const bool changed = !start.IsNull() && !end.IsNull() &&
                                 (vertex_of_.IsBound(start) || vertex_of_.IsBound(end));
            return {changed ? copied(old, new_vertex(start), new_vertex(end))
                            : TopoDS::Edge(old.Oriented(TopAbs_FORWARD))};
        }
        std::vector<Insert>& inserts = inserts_[*free];
        std::sort(inserts.begin(), inserts.end(),
                  [](const Insert& a, const Insert& b) { return a.first < b.first; });
        std::vector<TopoDS_Edge> result;
        double from = edges_[*free].first();
        TopoDS_Vertex here = new_vertex(start);
        for (const Insert& insert : inserts) {
            if (insert.first > from) {
                result.push_back(part_of(*free, from, insert.first, here,
                                         TopExp::FirstVertex(insert.edge, Standard_True)));
            }
            result.push_back(insert.edge);
            from = insert.last;
            here = TopExp::LastVertex(insert.edge, Standard_True);
        }
        if (from < edges_[*free].last()) {
            result.push_back(part_of(*free, from, edges_[*free].last(), here, new_vertex(end)));
        }
        return result;
    }

    [[nodiscard]] TopoDS_Shape rebuilt_wire(const TopoDS_Shape& wire, bool& changed) {
        const BRep_Builder builder;
        TopoDS_Shape copy = wire.EmptyCopied();
        copy.Orientation(TopAbs_FORWARD);
        for (TopoDS_Iterator it(wire.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
            if (it.Value().ShapeType() != TopAbs_EDGE) {
                builder.Add(copy, it.Value());
                continue;
            }
            std::vector<TopoDS_Edge> now = replacement(TopoDS::Edge(it.Value()));
            changed = changed || now.size() != 1 || !now.front().IsSame(it.Value());
            const bool reversed = it.Value().Orientation() == TopAbs_REVERSED;
            if (reversed) {
                std::reverse(now.begin(), now.end());
            }
            for (const TopoDS_Edge& edge : now) {
                const bool plain = reversed || it.Value().Orientation() == TopAbs_FORWARD;
                builder.Add(copy, plain
                                      ? edge.Oriented(reversed ? TopAbs::Reverse(edge.Orientation())
                                                               : edge.Orientation())
                                      : edge.Oriented(it.Value().Orientation()));
            }
        }
        copy.Closed(BRep_Tool::IsClosed(copy));
        copy.Orientation(wire.Orientation());
        return copy;
    }

    [[nodiscard]] TopoDS_Face rebuilt(const TopoDS_Face& face) {
        const BRep_Builder builder;
        bool changed = false;
        TopoDS_Shape copy = face.EmptyCopied();
        copy.Orientation(TopAbs_FORWARD);
        for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
            if (it.Value().ShapeType() != TopAbs_WIRE) {
                builder.Add(copy, it.Value());
                continue;
            }
            const TopoDS_Shape wire = rebuilt_wire(it.Value(), changed);
            if (TopoDS_Iterator(wire).More()) {  // a hole can have become a point
                builder.Add(copy, wire);
            }
        }
        copy.Orientation(face.Orientation());
        return changed ? TopoDS::Face(copy) : face;
    }

    const ShellGraph& graph_;
    const std::vector<FreeEdge>& edges_;
    const Places& places_;
    std::vector<std::vector<Insert>> inserts_;  // per free edge
    std::vector<int> gone_;                     // free edges that have become points
    TopTools_DataMapOfShapeInteger free_edge_of_;
    std::map<int, TopoDS_Vertex> vertex_of_place_;
    TopTools_DataMapOfShapeShape vertex_of_;  // old vertex -> another one
    TopTools_DataMapOfShapeInteger replacement_of_;
    std::vector<std::vector<TopoDS_Edge>> replacements_;
    TopTools_DataMapOfShapeShape rebuilt_;  // old face -> another one
    RebuiltFaces result_;
};

}  // namespace

RebuiltFaces rebuild_faces(const ShellGraph& graph, const std::vector<FreeEdge>& edges,
                           const Places& places, const SewMatcher& matches) {
    return Rebuilder(graph, edges, places, matches).run();
}

}  // namespace suture
