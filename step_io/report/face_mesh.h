#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <vector>

namespace suture::report {

/// The triangles of a shape to be looked at: of every face its own points, with the surface's
/// normals and curvatures there.
struct FaceMesh {
    std::vector<float> points;           ///< x, y, z
    std::vector<std::int16_t> normals;   ///< outward unit normals, octahedral, 2 each
    std::vector<float> curvatures;       ///< principal, the larger first, 2 each; + is concave
    std::vector<std::uint32_t> corners;  ///< 3 for each triangle, counted through all points
    std::vector<std::uint32_t> first;    ///< of each face the first triangle; one more at the end
    std::vector<float> edge_points;      ///< x, y, z of all edges' polylines
    std::vector<std::uint32_t> edge_first;  ///< of each edge the first point; one more at the end
    int faces_without = 0;                  ///< faces that OCCT could not mesh
};

struct FaceMeshOptions {
    double relative_deflection = 5e-4;  ///< of the shape's diagonal
    double angular_deflection = 0.15;   ///< radians between neighbouring facets
    std::size_t most_triangles = 150'000;
};

/// Meshes a shape, coarser where it would have more triangles than wanted; leaves triangles in it.
///
/// Refuses  a cancelled run. Faces that cannot be meshed are counted and left out.
[[nodiscard]] Result<FaceMesh> make_face_mesh(const TopoDS_Shape& shape,
                                              const FaceMeshOptions& options,
                                              const Progress& progress);

}  // namespace suture::report
