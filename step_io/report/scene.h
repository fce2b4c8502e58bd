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

/// A hole, or another boundary loop: shown with its number, and listed.
struct SceneHole {
    std::string id;
    std::string status;      ///< hole, rim, ...; of a fill good, near, ..., refused, skipped
    std::string text;        ///< why
    std::vector<int> edges;  ///< EdgeN of `before` if there is one, else of the shape
    std::vector<int> faces;  ///< FaceN of the same: the neighbour at each of these edges
};

/// A line of the assembly tree. Assemblies have no faces of their own.
struct ScenePart {
    std::string name;
    int depth = 0;
    std::vector<int> faces;  ///< FaceN and EdgeN of the shape
    std::vector<int> edges;
};

/// What a report shows in 3D, and what it says of the edges.
struct SceneInput {
    TopoDS_Shape shape;                  ///< whose EdgeN and FaceN all numbers are
    TopoDS_Shape before;                 ///< of a fill, else null
    std::vector<TopoDS_Face> new_faces;  ///< of a fill, in any place
    Profile profile;
    ContinuityReport report;
    std::vector<KnotLine> knots;
    CheckSummary summary;
    std::vector<SceneHole> holes;
    std::vector<ScenePart> parts;  ///< the tree, parents first
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
