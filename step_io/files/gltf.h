#pragma once

#include "files/mesh.h"
#include "files/model_file.h"
#include "suture/base/result.h"

#include <ostream>

namespace suture::io {

/// A model as binary glTF (.glb): the assembly tree, names and colours, in metres with y upwards,
/// as the format has it.
///
/// Input    options: with a deflection with which all faces can be meshed (make_mesh finds one)
/// Refuses  (WriteFailed) a folder for temporary files that has no room
[[nodiscard]] Result<void> write_gltf(const ModelFile& model, const MeshOptions& options,
                                      std::ostream& stream);

}  // namespace suture::io
