#pragma once

#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <ostream>
#include <string>

namespace suture::io {

/// OCCT's own files. `bytes` is what `file` holds.
///
/// Refuses  (Unreadable) a file that is cut off or that OCCT cannot make a shape of.
[[nodiscard]] Result<TopoDS_Shape> read_brep_text(const std::string& bytes,
                                                  const std::filesystem::path& file);

/// Binary, with OCCT's ending or FreeCAD's: which of them shows after the shapes.
[[nodiscard]] Result<TopoDS_Shape> read_brep_binary(const std::string& bytes,
                                                    const std::filesystem::path& file);

/// Without triangulations; text in version 1 and binary in version 3, which old readers take too.
[[nodiscard]] Result<void> write_brep_text(const TopoDS_Shape& shape, std::ostream& stream);
[[nodiscard]] Result<void> write_brep_binary(const TopoDS_Shape& shape, std::ostream& stream);
[[nodiscard]] Result<void> write_brep_freecad(const TopoDS_Shape& shape, std::ostream& stream);

}  // namespace suture::io
