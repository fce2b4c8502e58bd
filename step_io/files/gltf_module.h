#pragma once

#include "files/document.h"

namespace suture::io {

/// All that calls OCCT's writer of meshes with colours: a module of its own,
/// loaded only by runs that write glTF. The document's shapes have triangles,
/// in millimetres.
///
/// Result   whether `file`, a .glb, is written.
using WriteGltf = bool(const Document& document, const char* file);

}  // namespace suture::io
