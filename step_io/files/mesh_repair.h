#pragma once

#include "files/mesh.h"

namespace suture::io {

/// Takes needles out of a mesh, triangles flatter than `height`: an edge shorter than that is drawn
/// together, and where a corner lies on the opposite edge the diagonal with the triangle beyond is
/// turned. A closed mesh stays closed, and no point moves by more than `height`. What programs with
/// exact arithmetic (OpenSCAD's CGAL) make of such triangles is no solid.
///
/// Result   how many were taken out. Those that cannot go without opening the mesh stay.
int remove_needles(Mesh& mesh, double height);

/// Takes out triangles of two faces that have the same corners and look in opposite directions:
/// where faces meet in a sharp corner, coarse ones can lie on each other. They enclose nothing, and
/// have four triangles meet at an edge, of which those programs make no solid either.
///
/// Result   how many were taken out.
int remove_back_to_back(Mesh& mesh);

/// Edges of triangles that are not met by just one triangle on the other side: 0 for a closed mesh.
[[nodiscard]] std::size_t count_open_edges(const Mesh& mesh);

}  // namespace suture::io
