#pragma once

#include <TopoDS_Face.hxx>

#include <optional>

namespace suture {

/// Makes a face that closes a window of another one part of that one, on a surface that may close
/// in itself: the window may lie across its seam, which becomes one edge again.
///
/// Input    around: the face with the window; inside: one all of whose edges around has too, each
///          once; both as they stand in their shell.
/// Result   around without the window; none where the two do not lie on one surface, within the
///          tolerances that they have, or the window cuts the seam more than once.
[[nodiscard]] std::optional<TopoDS_Face> close_window(const TopoDS_Face& around,
                                                      const TopoDS_Face& inside);

}  // namespace suture
