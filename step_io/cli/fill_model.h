#pragma once

#include "cli/choose_holes.h"
#include "cli/command.h"
#include "cli/load.h"
#include "cli/survival.h"
#include "files/write.h"
#include "suture/check/validity.h"
#include "suture/fill_holes.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace suture::cli {

/// What `fill` is asked for. Hole ids and edge numbers in `request` are the model's.
struct FillSettings {
    std::filesystem::path input;
    std::filesystem::path output;
    io::Format format = io::Format::Step;
    LoadOptions load;
    FillRequest request;
    HoleFilter filter;  ///< where the request names no hole
    /// EdgeN of the model that the new face has to pass, besides request.through; and, if not 0,
    /// FaceN that it has to be tangent to there.
    std::vector<std::pair<int, int>> through_edges;
    /// FaceN of the model: these go, and what they leave is filled; or the neighbours grow
    /// together.
    std::vector<int> replace_faces, remove_faces;
    /// The neighbours of the chosen holes grow together, where they can, instead of a fill.
    bool grow = false;
    /// VertexN of the model: a hole that has both is cut in two between them.
    std::vector<std::pair<int, int>> splits;
    /// The new faces become one with neighbours that lie on the same surface.
    bool merge = false;
    io::MeshOptions mesh;
};

/// Seconds per step, for the report.
struct FillSeconds {
    double read = 0.0, detect = 0.0, sew = 0.0, check = 0.0, write = 0.0;
    double fill = 0.0;       ///< within the fill methods
    double choose = 0.0;     ///< `fill`, and making and measuring what each method gave
    double reread = 0.0;     ///< the part of `check` that reads the output again
    double fill_step = 0.0;  ///< the whole step: `choose`, ribbons, faces, joining
};

/// What of an output is read again and measured.
enum class MeasuredOn {
    Memory,    ///< nothing: it is a mesh
    NewFaces,  ///< the new faces and all that they meet
    File,      ///< the whole file
};

/// What has become of a model. The figures of the holes are measured on the output as it is read
/// again, or, if that is a mesh, on the model in memory; `validity` is that of the model in memory
/// and of all that is read again.
struct FillSummary {
    std::vector<HoleReport> holes;  ///< every boundary loop of the model
    std::vector<Finding> findings;  ///< of the model as a whole
    std::vector<int> sides;         ///< how many edges each of these has
    std::vector<HoleForm> forms;    ///< of holes whose method has one
    std::vector<WritingLoss> lost_by_writing;
    Validity validity;
    MeasuredOn measured_on = MeasuredOn::Memory;
    SewingFacts sewing;
    std::vector<std::string> changes;  ///< what was done to the model before, a sentence each
    std::string other_loops;  ///< where no loop is a hole: what else there is, and how to fill it
    io::ModelFile file;
    FillSeconds seconds;
    TopoDS_Shape before;                 ///< the model as it was, loose faces sewn
    std::vector<TopoDS_Face> new_faces;  ///< of every part, in its own place
};

/// Reads a model, fills its holes, writes it, reads it again, and judges. A fill that is bad in the
/// written file, though it was not in memory, is taken out again: all is done once more without it.
///
/// Refuses  (Usage) holes and edges that do not exist; (NothingToDo) a model without a hole, unless
///          sewing its loose faces has changed it: then it is written.
[[nodiscard]] Result<FillSummary> fill_model(Run& run, const FillSettings& settings);

}  // namespace suture::cli
