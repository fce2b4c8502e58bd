#pragma once

#include "suture/base/result.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// A shape without some of its faces.
struct CutShape {
    TopoDS_Shape shape;  ///< same structure; shells that lost a face are open
    /// The edges around each wound, a group of taken faces that hang together by edges: those that
    /// one face that stayed still uses; and where a hole was beside it, that one's as well.
    std::vector<std::vector<TopoDS_Edge>> wounds;
};

/// Takes faces out of a shape.
///
/// Refuses  (Usage) where nothing would be left around a wound.
[[nodiscard]] Result<CutShape> cut_faces(const TopoDS_Shape& shape,
                                         const std::vector<TopoDS_Face>& faces);

}  // namespace suture
