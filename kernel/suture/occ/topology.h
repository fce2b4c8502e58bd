#pragma once

#include <Eigen/Core>

#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include <optional>
#include <vector>

namespace suture::occ {

/// 1-based numbers of the faces and edges of a shape, as FreeCAD's FaceN and EdgeN: the indices of
/// TopExp::MapShapes.
struct Numbering {
    Numbering() = default;
    explicit Numbering(const TopoDS_Shape& shape);

    TopTools_IndexedMapOfShape faces;
    TopTools_IndexedMapOfShape edges;

    [[nodiscard]] int of(const TopoDS_Face& face) const { return faces.FindIndex(face); }
    [[nodiscard]] int of(const TopoDS_Edge& edge) const { return edges.FindIndex(edge); }
};

/// Where a part first stands in a model: whole contains part.Moved(result), perhaps reversed.
[[nodiscard]] std::optional<TopLoc_Location> placement_of(const TopoDS_Shape& part,
                                                          const TopoDS_Shape& whole);

/// The model's numbers for the shapes of one of its parts, in the part's own coordinates: those of
/// the instance at `placement`. Numbers of shapes outside of it belong to no shape.
[[nodiscard]] Numbering numbering_of_part(const Numbering& whole, const TopoDS_Shape& part,
                                          const TopLoc_Location& placement);

/// The faces (edges, shells, solids) of a shape in TopExp's order, each once.
[[nodiscard]] std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);
[[nodiscard]] std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape);

/// Diagonal of the bounding box, from geometry alone, without tolerances; 0 for an empty shape.
[[nodiscard]] double diagonal(const TopoDS_Shape& shape);

}  // namespace suture::occ
