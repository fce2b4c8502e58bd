#pragma once

#include <Interface_InterfaceModel.hxx>

#include <filesystem>
#include <string>
#include <vector>

namespace suture::io {

/// Lets the entities of a STEP file name only those other files that may be read: ordinary files in
/// the folder of the file or below it, links followed, which themselves name no others. All other
/// names are taken away, so that OCCT opens nothing.
///
/// Input    allowed: false takes every name away.
/// Result   the files that will not be read, sorted, with the reason unless they are just missing.
[[nodiscard]] std::vector<std::string> close_external_files(
    const Interface_InterfaceModel& entities, const std::filesystem::path& file, bool allowed);

}  // namespace suture::io
