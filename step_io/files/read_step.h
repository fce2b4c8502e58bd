#pragma once

#include "files/model_file.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <string_view>

namespace suture::io {

struct StepReading {
    bool face_names = true;
    bool from_text = false;      ///< the file is not the text: it is packed, or there is none
    bool external_files = true;  ///< in the folder of the file or below it
};

/// Reads the STEP file model.path, whose text is `text`, into model.document, with its schema,
/// unit, accuracy, origin and the names of files that are not read. Texts that are too long for
/// OCCT are cut; the notes say so.
///
/// Refuses  (Unreadable) a file that is cut off, refers to what it does not hold, or that OCCT
///          cannot read.
[[nodiscard]] Result<void> read_step(ModelFile& model, std::string_view text,
                                     const Progress& progress, const StepReading& options);

}  // namespace suture::io
