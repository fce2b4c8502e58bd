#include "suture/occ/topology.h"

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <cmath>
#include <type_traits>

namespace suture::occ {

Numbering::Numbering(const TopoDS_Shape& shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
}

std::optional<TopLoc_Location> placement_of(const TopoDS_Shape& part, const TopoDS_Shape& whole) {
    if (whole.IsPartner(part)) {
        return whole.Location() * part.Location().Inverted();
    }
    if (whole.ShapeType() == TopAbs_COMPOUND) {  // below a solid or a shell there is no part
        for (TopoDS_Iterator child(whole); child.More(); child.Next()) {
            if (auto found = placement_of(part, child.Value())) {
                return found;
            }
        }
    }
    return std::nullopt;
}

Numbering numbering_of_part(const Numbering& whole, const TopoDS_Shape& part,
                            const TopLoc_Location& placement) {
    const Numbering own(part);
    const TopLoc_Location back = placement.Inverted();
    const auto renumber = [&](const TopTools_IndexedMapOfShape& numbered,
                              const TopTools_IndexedMapOfShape& wanted, auto empty_shape,
                              TopTools_IndexedMapOfShape& result) {
        for (int i = 1; i <= numbered.Extent(); ++i) {
            const TopoDS_Shape shape = numbered(i).Moved(back);
            if (wanted.Contains(shape)) {
                result.Add(shape);
            } else {
                // A shape of its own keeps the place, so that the indices stay the model's.
                BRep_Builder builder;
                if constexpr (std::is_same_v<decltype(empty_shape), TopoDS_Face>) {
                    builder.MakeFace(empty_shape);
                } else {
                    builder.MakeEdge(empty_shape);
                }
                result.Add(empty_shape);
            }
        }
    };
    Numbering result;
    renumber(whole.faces, own.faces, TopoDS_Face(), result.faces);
    renumber(whole.edges, own.edges, TopoDS_Edge(), result.edges);
    return result;
}

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_FACE, map);
    std::vector<TopoDS_Face> result;
    for (int i = 1; i <= map.Extent(); ++i) {
        result.push_back(TopoDS::Face(map(i)));
    }
    return result;
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_EDGE, map);
    std::vector<TopoDS_Edge> result;
    for (int i = 1; i <= map.Extent(); ++i) {
        result.push_back(TopoDS::Edge(map(i)));
    }
    return result;
}

double diagonal(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, /*useTriangulation=*/Standard_False);
    return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

}  // namespace suture::occ
