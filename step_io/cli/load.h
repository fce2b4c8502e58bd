#pragma once

#include "cli/command.h"
#include "files/model_file.h"
#include "files/read.h"
#include "suture/detect/boundary_loop.h"
#include "suture/occ/topology.h"
#include "suture/sew/sew_shape.h"

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

struct LoadOptions {
    bool sew = true;                      ///< what lies on each other: faces, shells, cracks
    std::optional<double> sew_tolerance;  ///< none: from the model
    io::Content content = io::Content::Faces;
};

/// What sewing has done to the whole model.
struct SewingFacts {
    bool changed = false;
    int loose_faces = 0;  ///< in the parts that were sewn
    int sewn_edges = 0;   ///< pairs of edges that became one
    int walls = 0;        ///< inner walls that now bound both bodies
    int free_edges_before = 0;
    int free_edges_after = 0;
    double tolerance = 0.0;
    double largest_gap = 0.0;
    std::vector<LeftOpen> left;  ///< of all parts
};

/// "6 loose faces sewn at 0.001 mm", "4 edges sewn at 0.001 mm"
[[nodiscard]] std::string text_of(const SewingFacts& sewing);

/// One line for each that looks like a gap and was left, the widest first, a few at most.
[[nodiscard]] std::vector<std::string> notes_of(const SewingFacts& sewing);

/// A model as read and sewn.
struct LoadedModel {
    io::ModelFile file;
    /// file.shape() after sewing: EdgeN and FaceN are its numbers, also where what has been chosen
    /// by them has changed the file's shape since.
    TopoDS_Shape whole;
    SewingFacts sewing;
    std::vector<std::string> changes;  ///< what has been done to it besides, a sentence each
    bool grown = false;                ///< neighbours have grown together: nothing is left to fill
    double seconds_read = 0.0;
    double seconds_sew = 0.0;
};

/// Reads a model and sews each part of it. Takes the part [0, to] of the run's progress.
[[nodiscard]] Result<LoadedModel> load_model(Run& run, const std::filesystem::path& file,
                                             const LoadOptions& options, double to);

/// One part of a model with its boundary loops, in the part's own coordinates.
struct PartLoops {
    io::Part part;
    TopLoc_Location placement;        ///< of its first instance in the model
    occ::Numbering numbering;         ///< the model's, for the part's own shapes
    std::vector<BoundaryLoop> loops;  ///< with ids that count through the whole model
    int ids_before = 0;               ///< id in the model = id in the part + ids_before
};

/// The boundary loops of every part, each part once however often it stands in the model.
[[nodiscard]] Result<std::vector<PartLoops>> find_model_loops(const LoadedModel& model);

}  // namespace suture::cli
