#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include <Eigen/Core>
#include <vector>

namespace suture::occ {

/// 1-based numbers of the faces and edges of a shape, as FreeCAD's FaceN and EdgeN: the indices of
/// TopExp::MapShapes.
struct Numbering {
    explicit Numbering(const TopoDS_Shape& shape);

    TopTools_IndexedMapOfShape faces;
    TopTools_IndexedMapOfShape edges;

    [[nodiscard]] int of(const TopoDS_Face& face) const { return faces.FindIndex(face); }
    [[nodiscard]] int of(const TopoDS_Edge& edge) const { return edges.FindIndex(edge); }
};

/// The faces (edges, shells, solids) of a shape in TopExp's order, each once.
[[nodiscard]] std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);
[[nodiscard]] std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape);

/// Diagonal of the bounding box, from geometry alone, without tolerances; 0 for an empty shape.
[[nodiscard]] double diagonal(const TopoDS_Shape& shape);

}  // namespace suture::occ
