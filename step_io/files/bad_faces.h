#pragma once

#include "files/model_file.h"

namespace suture::io {

/// Takes faces out of the model that nothing can be done with: an edge of them has neither a curve
/// nor one on the face's surface, or the face has no surface. `notes` names each. Shells without a
/// face go as well.
void leave_out_bad_faces(ModelFile& model);

}  // namespace suture::io
