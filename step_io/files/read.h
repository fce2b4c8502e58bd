#pragma once

#include "files/model_file.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <filesystem>

namespace suture::io {

/// STEP files are read without the names of their faces from now on, by this process and those that
/// it starts: OCCT's reader crashes on some files with them.
void forget_face_names();

/// From now on no other file is opened that a STEP file names, by this process and those that it
/// starts.
void close_external_references();

/// What a file has to hold.
enum class Content { Faces, Curves };

/// Reads STEP, IGES, BREP or FreeCAD's binary BREP; the type is told by the content. Faces with an
/// edge that has no curve are left out; ModelFile::notes names them.
///
/// OCCT's reader can crash or hang on a damaged file. Callers who must survive that run the whole
/// job under supervise() (cli/supervise.h) or in occ::run_isolated.
/// Of an assembly whose parts lie in other STEP files, only those in the folder of the file or
/// below are read; ModelFile::missing_files names the others.
/// Input    content: whether a file that has curves alone will do.
/// Refuses  (Unreadable) what OCCT cannot read, a file without any face (edge), and numbers that no
/// work
///          can bear (files/check_numbers.h).
[[nodiscard]] Result<ModelFile> read_model(const std::filesystem::path& file,
                                           const Progress& progress,
                                           Content content = Content::Faces);

}  // namespace suture::io
