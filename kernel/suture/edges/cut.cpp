#include "suture/edges/cut.h"

#include "suture/occ/children.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>

namespace suture {
namespace {

/// The shape without the faces; null if nothing is left of it.
TopoDS_Shape without(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& taken) {
    if (shape.ShapeType() == TopAbs_FACE) {
        return taken.Contains(shape) ? TopoDS_Shape() : shape;
    }
    if (shape.ShapeType() > TopAbs_FACE) {
        return shape;
    }
    const auto children = occ::changed_children(
        shape, [&](const TopoDS_Shape& child) { return without(child, taken); });
    if (!children) {
        return shape;
    }
    if (children->empty()) {
        return {};
    }
    TopoDS_Shape copy = shape.EmptyCopied();
    for (const TopoDS_Shape& child : *children) {
        BRep_Builder().Add(copy, child);
    }
    if (copy.ShapeType() == TopAbs_SHELL) {
        copy.Closed(BRep_Tool::IsClosed(copy));
    }
    return copy;
}

/// Groups of faces that share edges.
std::vector<std::vector<TopoDS_Face>> groups_of(std::vector<TopoDS_Face> faces) {
    const auto touch = [](const TopoDS_Face& a, const TopoDS_Face& b) {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(a, TopAbs_EDGE, edges);
        return std::ranges::any_of(occ::edges_of(b),
                                   [&](const TopoDS_Edge& e) { return edges.Contains(e); });
    };
    std::vector<std::vector<TopoDS_Face>> groups;
    while (!faces.empty()) {
        std::vector<TopoDS_Face>& group = groups.emplace_back(1, faces.front());
        faces.erase(faces.begin());
        for (std::size_t k = 0; k < group.size(); ++k) {
            const auto near = std::stable_partition(
                faces.begin(), faces.end(),
                [&](const TopoDS_Face& face) { return !touch(face, group[k]); });
            group.insert(group.end(), near, faces.end());
            faces.erase(near, faces.end());
        }
    }
    return groups;
}

/// Completes a rim that ends at a hole that was there before: along the hole's own free edges.
class RimCloser {
  public:
    explicit RimCloser(const TopTools_IndexedDataMapOfShapeListOfShape& users) {
        for (int i = 1; i <= users.Extent(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(users.FindKey(i));
            if (users(i).Extent() == 1 && !BRep_Tool::Degenerated(edge)) {
                for (const TopoDS_Vertex& end : ends_of(edge)) {
                    if (!free_.Contains(end)) {
                        free_.Add(end, TopTools_ListOfShape());
                    }
                    free_.ChangeFromKey(end).Append(edge);
                }
            }
        }
    }

    void close(TopTools_IndexedMapOfShape& rim) const {
        TopTools_IndexedMapOfShape open;  // ends at which the rim does not go on
        for (int i = 1; i <= rim.Extent(); ++i) {
            toggle(TopoDS::Edge(rim(i)), open);
        }
        while (!open.IsEmpty()) {
            const TopoDS_Edge next = way_on(open(open.Extent()), rim);
            if (next.IsNull()) {
                return;
            }
            rim.Add(next);
            toggle(next, open);
        }
    }

  private:
    static std::array<TopoDS_Vertex, 2> ends_of(const TopoDS_Edge& edge) {
        return {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)};
    }

    static void toggle(const TopoDS_Edge& edge, TopTools_IndexedMapOfShape& open) {
        for (const TopoDS_Vertex& end : ends_of(edge)) {
            if (!open.RemoveKey(end)) {
                open.Add(end);
            }
        }
    }

    /// The free edge at a vertex that the rim does not have yet; null if there is not just one.
    [[nodiscard]] TopoDS_Edge way_on(const TopoDS_Shape& vertex,
                                     const TopTools_IndexedMapOfShape& rim) const {
        TopoDS_Edge found;
        if (!free_.Contains(vertex)) {
            return found;
        }
        for (const TopoDS_Shape& edge : free_.FindFromKey(vertex)) {
            if (!rim.Contains(edge)) {
                if (!found.IsNull()) {
                    return {};
                }
                found = TopoDS::Edge(edge);
            }
        }
        return found;
    }

    TopTools_IndexedDataMapOfShapeListOfShape free_;
};

/// The edges of a group that one of the other faces uses, once, and those of a hole beside it.
std::vector<TopoDS_Edge> rim_of(const std::vector<TopoDS_Face>& group,
                                const TopTools_IndexedDataMapOfShapeListOfShape& users) {
    TopTools_IndexedMapOfShape rim;
    for (const TopoDS_Face& face : group) {
        for (const TopoDS_Edge& edge : occ::edges_of(face)) {
            const int index = users.FindIndex(edge);
            if (!BRep_Tool::Degenerated(edge) && index > 0 && users(index).Extent() == 1) {
                rim.Add(edge);
            }
        }
    }
    RimCloser(users).close(rim);
    std::vector<TopoDS_Edge> edges;
    for (int i = 1; i <= rim.Extent(); ++i) {
        edges.push_back(TopoDS::Edge(rim(i)));
    }
    return edges;
}

Result<CutShape> cut(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
    TopTools_IndexedMapOfShape taken;
    for (const TopoDS_Face& face : faces) {
        taken.Add(face);
    }
    CutShape result;
    result.shape = without(shape, taken);
    if (result.shape.IsNull()) {
        return fail(ErrorCode::Usage, "all faces would go: nothing would be left around them");
    }
    TopTools_IndexedDataMapOfShapeListOfShape users;
    TopExp::MapShapesAndAncestors(result.shape, TopAbs_EDGE, TopAbs_FACE, users);
    for (const std::vector<TopoDS_Face>& group : groups_of(faces)) {
        result.wounds.push_back(rim_of(group, users));
        if (result.wounds.back().empty()) {
            return fail(ErrorCode::Usage,
                        "all faces that hang together would go: nothing would be left around them");
        }
    }
    return result;
}

}  // namespace

Result<CutShape> cut_faces(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
    return occ::guarded("taking faces out", [&] { return cut(shape, faces); });
}

}  // namespace suture
