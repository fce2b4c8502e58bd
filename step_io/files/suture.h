// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// The library in one header: read a model, find its holes, fill them, check, write.
/// docs/examples/fill_a_model.cpp uses it. Installed as <suture/suture.h>; link suture::io.

#include "files/format.h"              // format_of_content, format_of_extension
#include "files/mesh.h"                // MeshOptions
#include "files/model_file.h"          // ModelFile, Part
#include "files/read.h"                // read_model
#include "files/write.h"               // write_model
#include "suture/base/result.h"        // Result, Error
#include "suture/check/continuity.h"   // measure_continuity
#include "suture/check/validity.h"     // measure_validity
#include "suture/detect/find_loops.h"  // find_loops
#include "suture/fill_holes.h"         // fill_holes, FillRequest
#include "suture/sew/sew_shape.h"      // sew_shape
