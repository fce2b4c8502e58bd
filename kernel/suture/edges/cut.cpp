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

/// The edges of a group that one of the other faces uses, once.
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
