#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/check/continuity.h"
#include "suture/check/face_knots.h"
#include "suture/judge/summary.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace suture::report {

/// What a report shows in 3D, and what it says of the edges.
struct SceneInput {
    TopoDS_Shape shape;                  ///< whose EdgeN and FaceN all numbers are
    TopoDS_Shape before;                 ///< of a fill, else null
    std::vector<TopoDS_Face> new_faces;  ///< of a fill, in any place
    Profile profile;
    ContinuityReport report;
    std::vector<KnotLine> knots;
    CheckSummary summary;
};

/// A JSON document for the page's script: the meshes, the edges with their figures, and their
/// course along the edges. Arrays of numbers are base64 texts of little-endian binary.
///
/// Refuses  a cancelled run.
[[nodiscard]] Result<std::string> make_scene(const SceneInput& input, const Progress& progress);

/// The page's script and style sheet, bundled when the program was built.
[[nodiscard]] const std::string& viewer_script();
[[nodiscard]] const std::string& viewer_style();

}  // namespace suture::report
