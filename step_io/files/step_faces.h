#pragma once

#include "files/step_scan.h"
#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace suture::io {

/// The text of a STEP file that holds, of another one, only some faces and what these need.
///
/// Input    text is a whole STEP file; every group names ADVANCED_FACE entities.
/// Result   the file's own statements, unchanged, and one open shell a group.
/// Refuses  (Unreadable) a number that is not that of a face, and a file that has not `all_faces`
///          faces.
[[nodiscard]] Result<std::string> extract_step_faces(std::string_view text,
                                                     const std::vector<std::vector<StepId>>& groups,
                                                     std::size_t all_faces);

/// Reads some faces of a STEP file as read_model does, but nothing else of it: in the coordinates
/// of their own part, and without assembly, names and colours.
///
/// Result   a shape for every group of entity numbers, in which faces share the edges that they
///          share in the file.
/// Refuses  (Unreadable) a file that has not `all_faces` faces in all, that OCCT cannot read, or of
///          which it reads fewer faces than the groups have.
[[nodiscard]] Result<std::vector<TopoDS_Shape>> read_step_faces(
    const std::filesystem::path& file, const std::vector<std::vector<StepId>>& groups,
    std::size_t all_faces);

}  // namespace suture::io
