#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <chrono>
#include <vector>

namespace suture {

/// A shape some of whose faces have gone into others.
struct GrownShape {
    TopoDS_Shape shape;
    TopTools_DataMapOfShapeShape replaced;  ///< what the faces that were there are now
};

/// Removes faces by letting their neighbours grow together (OCCT's BRepAlgoAPI_Defeaturing, in a
/// process of its own, since it can crash or hang).
///
/// Input    shape: with at least one solid that holds the faces.
/// Refuses  where OCCT finds no way to close what is left, or leaves one of the faces where it is.
[[nodiscard]] Result<GrownShape> grow_over(const TopoDS_Shape& shape,
                                           const std::vector<TopoDS_Face>& faces,
                                           std::chrono::milliseconds limit,
                                           const Progress& progress);

/// Makes faces one with neighbours that lie on the same surface (OCCT's
/// ShapeUpgrade_UnifySameDomain, in a process of its own); edges and vertices that no face of these
/// has stay as they are.
///
/// Result   the shape itself where no neighbour lies on one surface with them.
/// Refuses  where OCCT fails.
[[nodiscard]] Result<GrownShape> merge_with_neighbours(const TopoDS_Shape& shape,
                                                       const std::vector<TopoDS_Face>& faces,
                                                       std::chrono::milliseconds limit,
                                                       const Progress& progress);

}  // namespace suture
