#pragma once

#include "suture/base/result.h"
#include "suture/fill/manifold/star_mesh.h"

#include <filesystem>

namespace suture::io {

/// The vertices and faces of a Wavefront OBJ file; everything else in it is passed over.
///
/// Refuses  (Unreadable) a missing file, a line that is no vertex or no face, a face with a vertex
///          that does not exist, a file without faces: with the line's number.
[[nodiscard]] Result<manifold::PolygonMesh> read_obj(const std::filesystem::path& file);

}  // namespace suture::io
