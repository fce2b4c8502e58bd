#include "cli/batch.h"
#include "cli/load.h"
#include "cli/options.h"
#include "cli/report_html.h"
#include "cli/report_json.h"
#include "cli/scene_parts.h"
#include "suture/check/validity.h"
#include "suture/ribbon/extract.h"

#include <fmt/ranges.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include <algorithm>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "List the holes of a model",
    "List the holes of a model: which edges and faces bound them, how large they are, and how "
    "their corners meet. Nothing is changed. Rims of open sheets and unsewn seams are listed "
    "apart: they are no holes. Faces and shells that lie on each other are sewn first, in memory; "
    "edge and face numbers are then those of the sewn model.",
    "  suture inspect part.step             the holes of a model\n"
    "  suture inspect part.step --json      the same for a program\n"
    "  suture inspect wing.igs --sew-tolerance 0.05\n"
    "Exit codes: 0 there are holes, 3 there is none, 2 the file cannot be read, 1 wrong usage.\n"};

Eigen::Vector3d placed(const Eigen::Vector3d& point, const TopLoc_Location& placement) {
    gp_Pnt p(point.x(), point.y(), point.z());
    p.Transform(placement.Transformation());
    return {p.X(), p.Y(), p.Z()};
}

/// The corners in the model's coordinates; none, and a note, where the sides have no ribbons.
std::vector<Corner> corners_in_model(const BoundaryLoop& loop, const TopLoc_Location& placement,
                                     std::vector<std::string>& notes) {
    const Result<Hole> hole = extract_hole({loop});
    if (!hole) {
        notes.push_back(fmt::format("loop {}: {}", loop.id, hole.error().message));
        return {};
    }
    std::vector<Corner> corners = corners_of(hole->loops.front());
    for (Corner& corner : corners) {
        corner.point = placed(corner.point, placement);
    }
    return corners;
}

std::string edges_of_loop(const BoundaryLoop& loop) {
    std::vector<int> edges;
    for (const BoundaryEdge& side : loop.edges) {
        edges.push_back(side.edge_number);
    }
    return ranges(std::move(edges));
}

std::string neighbours_of(const BoundaryLoop& loop) {
    std::vector<int> faces;
    for (const BoundaryEdge& side : loop.edges) {
        faces.push_back(side.face_number);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return ranges(std::move(faces));
}

std::string position_of(const BoundaryLoop& loop, const TopLoc_Location& placement) {
    Bnd_Box box;
    for (const BoundaryEdge& side : loop.edges) {
        BRepBndLib::Add(side.edge, box);
    }
    if (box.IsVoid()) {
        return "-";
    }
    const gp_Pnt middle = gp_Pnt(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()))
                              .Transformed(placement.Transformation());
    return fmt::format("{:.4g} {:.4g} {:.4g}", middle.X(), middle.Y(), middle.Z());
}

/// Below a millionth of a degree there is only rounding.
std::string mismatch_text(double mismatch) {
    return degrees(mismatch) < 1e-6 ? "0" : short_number(degrees(mismatch));
}

/// The table of the holes, or of the loops that are none.
class LoopTables {
  public:
    void add(const BoundaryLoop& loop, const io::Part& part, const std::vector<Corner>& corners,
             const std::string& position) {
        const bool is_hole = loop.kind == LoopKind::Hole;
        ++(is_hole ? holes_ : others_);
        double mismatch = 0.0;
        for (const Corner& corner : corners) {
            mismatch = std::max(mismatch, corner.normal_mismatch);
        }
        const std::string where =
            part.instances > 1 ? fmt::format("{} (x{})", part.name, part.instances) : part.name;
        if (is_hole) {
            hole_table_.add({std::to_string(loop.id), std::to_string(loop.edges.size()),
                             short_number(loop.diameter), position, loop.planar ? "yes" : "no",
                             corners.empty() ? "-" : mismatch_text(mismatch), edges_of_loop(loop),
                             neighbours_of(loop), where});
        } else {
            other_table_.add({std::to_string(loop.id), std::string(to_string(loop.kind)),
                              std::to_string(loop.edges.size()), short_number(loop.diameter),
                              position, edges_of_loop(loop), where, loop.reason});
        }
    }

    [[nodiscard]] int holes() const { return holes_; }
    [[nodiscard]] int others() const { return others_; }

    [[nodiscard]] std::vector<Section> sections(std::vector<std::string> notes) && {
        std::vector<Section> sections;
        if (holes_ > 0) {
            sections.push_back({"Holes", std::move(hole_table_), {}});
        }
        if (others_ > 0) {
            sections.push_back({"Other loops", std::move(other_table_), {}});
        }
        if (!notes.empty()) {
            sections.push_back({"Notes", Table({}), std::move(notes)});
        }
        return sections;
    }

  private:
    Table hole_table_{{">hole", ">sides", ">diameter [mm]", "at", "planar",
                       ">corner mismatch [deg]", "edges", "neighbours", "part"}};
    Table other_table_{{">loop", "kind", ">sides", ">diameter [mm]", "at", "edges", "part", "why"}};
    int holes_ = 0;
    int others_ = 0;
};

/// Said once, at the first of the loops.
void note_islands(const BoundaryLoop& loop, std::vector<std::string>& notes) {
    const std::vector<int>& others = loop.islands_with;
    if (others.empty() || loop.id > *std::ranges::min_element(others)) {
        return;
    }
    const std::string ids = fmt::format("{}+{}", loop.id, fmt::join(others, "+"));
    notes.push_back(
        loop.kind == LoopKind::Hole
            ? fmt::format("loops {} bound one missing face: `fill` takes them together", ids)
            : fmt::format("loops {} may bound one missing face: --hole {} takes them "
                          "together",
                          ids, ids));
}

std::string verdict_of(const LoopTables& tables, const LoadedModel& model) {
    std::string verdict = tables.holes() > 0 ? counted(tables.holes(), "hole") : "no hole";
    if (tables.others() > 0) {
        verdict += ", " + counted(tables.others(), "other loop");
    }
    if (model.sewing.changed) {
        verdict += "; " + text_of(model.sewing) + " in memory";
    }
    return verdict;
}

/// The page shows the holes in 3D, and how smoothly the faces around them meet as they are.
Result<report::SceneInput> scene_of(const LoadedModel& model, const std::vector<PartLoops>& parts,
                                    const Progress& progress) {
    report::SceneInput input;
    input.shape = model.whole;
    Result<ContinuityReport> report = measure_continuity(input.shape, input.profile, {}, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    input.report = std::move(*report);
    input.summary = summarise(input.report, input.knots, input.profile);
    input.holes = scene_holes(parts);
    input.parts = scene_parts(model.file);
    return input;
}

void add_page(const Command& command, const std::shared_ptr<const LoadedModel>& model,
              const std::shared_ptr<const std::vector<PartLoops>>& parts, Outcome& outcome) {
    outcome.reports[".html"] = [&command, model, parts, shown = std::make_shared<Outcome>(outcome)](
                                   Run& run) -> Result<std::string> {
        const Progress progress = run.stage(Stage::Checking, "drawing the model", 0.9, 1.0);
        return scene_of(*model, *parts, progress)
            .and_then([&](const report::SceneInput& input) {
                return report::make_scene(input, progress);
            })
            .map([&](const std::string& scene) { return html_report(command, *shown, scene); });
    };
}

Result<Outcome> inspect(Run& run, const Command& command, const LoadOptions& options) {
    // Reading takes most of the time.
    constexpr double kLoaded = 0.8;
    Result<LoadedModel> loaded = load_model(run, command.input, options, kLoaded);
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    const auto model = std::make_shared<const LoadedModel>(std::move(*loaded));
    const Stopwatch watch;
    const Progress progress = run.stage(Stage::Finding, "finding holes", kLoaded, 1.0);
    Result<std::vector<PartLoops>> found = find_model_loops(*model);
    if (!found) {
        return tl::unexpected(found.error());
    }
    const auto parts = std::make_shared<const std::vector<PartLoops>>(std::move(*found));
    LoopTables tables;
    std::vector<std::string> notes = notes_of(model->sewing);
    Json holes = Json::array();
    for (const PartLoops& part : *parts) {
        for (const BoundaryLoop& loop : part.loops) {
            const std::vector<Corner> corners = corners_in_model(loop, part.placement, notes);
            tables.add(loop, part.part, corners, position_of(loop, part.placement));
            note_islands(loop, notes);
            holes.push_back(json_of(loop, part.part, corners));
        }
    }
    Outcome outcome;
    outcome.exit_code = tables.holes() > 0 ? kDone : kNothingToDo;
    outcome.verdict = verdict_of(tables, *model);
    if (tables.holes() == 0 && !measure_validity(model->whole, ValidityDepth::Valid).valid) {
        outcome.verdict += "; but the model is NOT valid: `suture check` says why";
    }
    outcome.document = {{"model", json_of(model->file)},
                        {"sewing", json_of(model->sewing)},
                        {"holes", holes},
                        {"hole_count", tables.holes()},
                        {"notes", notes},
                        {"seconds",
                         {{"read", model->seconds_read},
                          {"sew", model->seconds_sew},
                          {"detect", watch.seconds()}}}};
    outcome.sections = std::move(tables).sections(std::move(notes));
    add_page(command, model, parts, outcome);
    return outcome;
}

}  // namespace

std::shared_ptr<Command> add_inspect(CLI::App& app) {
    auto command = add_command(app, "inspect", kHelp);
    auto options = std::make_shared<LoadOptions>();
    add_input(*command);
    add_reports(*command);
    add_picture(*command);
    add_sewing(*command, *options);
    command->validate = [options] { return validate_sewing(*options); };
    const Command* self = command.get();
    add_batch_options(*command->app, false);
    command->run = [options, self](Run& run) { return inspect(run, *self, *options); };
    return command;
}

}  // namespace suture::cli
