#pragma once

#include "files/mesh_faces.h"
#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace suture::io {

struct MeshOptions {
    double deflection = 0.0;           ///< model units; 0: a thousandth of the model's diagonal
    double angular_deflection = 0.35;  ///< radians between neighbouring facets
};

/// What is to be said of a mesh.
struct MeshFacts {
    double deflection = 0.0;     ///< with which it was made
    int needles = 0;             ///< triangles without height, or back to back, that were taken out
    std::size_t open_edges = 0;  ///< edges of triangles with no triangle beyond: 0 if it is closed
    std::size_t triangles = 0;
    std::size_t points = 0;
    std::vector<UnmeshedFace> left_out;  ///< faces that have no triangles
};

/// Triangles over shared points. Where two faces share an edge they share its points too, so the
/// mesh of a closed shell is watertight: every directed edge has its opposite exactly once.
struct Mesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< anticlockwise seen from outside
    std::vector<std::uint32_t> faces;                     ///< of each triangle, FaceN of the shape
    MeshFacts facts;
};

/// Meshes a copy of the shape, all faces in parallel; the shape itself is left without triangles.
/// Solids that are inside out are turned, needles are taken out (remove_needles). Where OCCT cannot
/// mesh a face, it is meshed finer (triangulate), then all is, coarser; what is still without
/// triangles is left out and stands in the facts.
///
/// Refuses  (Internal) edges whose points do not agree.
[[nodiscard]] Result<Mesh> make_mesh(const TopoDS_Shape& shape, const MeshOptions& options);

/// The deflection that is used where none is asked for: a thousandth of the diagonal.
[[nodiscard]] double usual_deflection(const TopoDS_Shape& shape);

/// A mesh as a file. Lengths are millimetres.
[[nodiscard]] Result<void> write_stl(const Mesh& mesh, std::ostream& stream);
[[nodiscard]] Result<void> write_off(const Mesh& mesh, std::ostream& stream);

}  // namespace suture::io
