#pragma once

#include <TopoDS_Shape.hxx>

namespace suture::io {

/// The shape without placements that mirror or scale, which only BREP files have: they are worked
/// into the geometry. OCCT's other algorithms refuse such shapes, or turn their faces inside out.
///
/// Result   the same structure; what is placed by motions alone keeps its TShape.
[[nodiscard]] TopoDS_Shape with_rigid_placements(const TopoDS_Shape& shape);

}  // namespace suture::io
