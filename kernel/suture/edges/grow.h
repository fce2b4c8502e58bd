#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <chrono>
#include <vector>

namespace suture {

/// A shape without some of its faces, whose neighbours have been extended until they meet.
struct GrownShape {
    TopoDS_Shape shape;
    TopTools_DataMapOfShapeShape replaced;  ///< what the faces that stayed are now
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

}  // namespace suture
