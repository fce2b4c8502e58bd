#include "suture/occ/topology.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <cmath>

namespace suture::occ {

Numbering::Numbering(const TopoDS_Shape& shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
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
