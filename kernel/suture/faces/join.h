#pragma once

#include "suture/base/result.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// The shape with faces added to the shells they close.
///
/// Result   same structure; sheets that a face joins become one shell, and those that face the
///          other way than the face are turned over; a face that stands on curves alone is a shell
///          of its own, in place of the curves; a shell that is closed now becomes a solid with
///          outward orientation, or stays in the solid that it was in. Everything untouched keeps
///          its TShape.
[[nodiscard]] Result<TopoDS_Shape> join(const TopoDS_Shape& shape,
                                        const std::vector<TopoDS_Face>& faces);

}  // namespace suture
