#include "cli/arguments.h"
#include "cli/batch.h"
#include "cli/convert.h"
#include "cli/fill_page.h"
#include "cli/fill_report.h"
#include "cli/methods.h"
#include "cli/options.h"
#include "cli/points_file.h"
#include "suture/choose/choose.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <optional>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "Fill the holes of a model with smooth faces",
    "Fill the holes of a model with smooth B-spline faces, sew them in, and write the model. The "
    "faces around a hole, their edges and their names and colours stay as they are. The result is "
    "read again from the written file and measured there; what is out of tolerance is written "
    "all the same, and the report and the exit code say so; a fill that is bad stays out of the "
    "model, and its hole open.",
    "  suture fill part.step -o filled.step                   all holes, the best method for each\n"
    "  suture fill part.step -o filled.step --hole 2 5        two of those that `inspect` lists\n"
    "  suture fill part.step -o filled.step --hole 3+4        one face with an island\n"
    "  suture fill part.step -o filled.step --edges 12        the hole that has this edge\n"
    "  suture fill sheets.step -o skin.step --boundary 1,5,9,13   a face over chosen edges\n"
    "  suture fill part.step -o part2.step --replace-faces 12,13   these faces anew\n"
    "  suture fill part.step -o part2.step --remove-faces 12      a fillet back to an edge\n"
    "  suture fill part.step -o filled.step --continuity G1 --edge-continuity 12=G2,13=G0\n"
    "  suture fill part.step -o filled.step --hole 2 --through scan.csv   points to pass\n"
    "  suture fill wing.igs -o wing.step --report wing.html   loose faces are sewn first\n"
    "  suture fill part.step -o part.3mf --deflection 0.02    a watertight mesh\n"
    "Exit codes: 0 done, 4 done but out of tolerance or some hole refused, 3 no hole (nothing is "
    "written),\n2 the file cannot be read, 1 wrong usage, 5 the output could not be written.\n"};

constexpr CommandHelp kBridgeHelp{
    "Join two edges, rims or bodies with a smooth face",
    "Make a face between two edges, or between two chains of edges. Along them it joins their "
    "faces as "
    "smoothly as these allow; its free sides are curves that leave both ends smoothly. Two closed "
    "rims are joined by a tube. The edges may belong to one sheet, two sheets or two bodies, which "
    "become one.",
    "  suture bridge plates.step -o bridged.step --edges 3,17\n"
    "  suture bridge pipes.step -o pipe.step --edges 2,8 --continuity G2\n"
    "Exit codes: as those of `suture fill`.\n"};

/// The group of the help that CLI11 puts options into unasked.
constexpr const char* kNoGroup = "Options";

struct FillOptions {
    std::filesystem::path output;
    std::string holes, edges;
    std::vector<std::string> boundaries;
    std::string replace_faces, remove_faces;
    std::vector<std::string> splits;
    std::string supports;
    std::string method = "auto";
    std::vector<std::string> own;
    std::string continuity = "auto";
    std::string edge_continuity;
    std::string occt_setting = "default";
    std::string recognise = "model";
    std::string prefer = "tight";
    std::string effort = "normal";
    std::filesystem::path through;
    std::string through_edges;
    std::optional<double> tolerance, angle, curvature, occt_timeout, tension;
    MeshSettings mesh;
    std::optional<int> jobs;
    bool all_loops = false;
    bool keep_bad = false;
    bool force = false;
    FillSettings settings;
};

template <class T, class Target>
Result<void> take(Result<T> value, Target& target) {
    if (!value) {
        return tl::unexpected(value.error());
    }
    target = std::move(*value);
    return {};
}

Result<void> take_positive(std::string_view option, const std::optional<double>& given,
                           double factor, double& target) {
    if (!given) {
        return {};
    }
    target = *given * factor;
    return expect_positive(option, *given);
}

/// Faces over chosen edges, and faces that are to go.
Result<void> take_borders(const FillOptions& options, FillSettings& settings) {
    const std::array ways{!options.holes.empty() || !options.edges.empty() || options.all_loops,
                          !options.boundaries.empty(), !options.replace_faces.empty(),
                          !options.remove_faces.empty()};
    if (std::ranges::count(ways, true) > 1) {
        return fail(ErrorCode::Usage,
                    "give holes (--hole, --edges, --all-loops), --boundary, --replace-faces or "
                    "--remove-faces, one of these");
    }
    if (settings.grow && !(ways[0] || std::ranges::count(ways, true) == 0)) {
        return fail(ErrorCode::Usage, "--grow is for holes; for faces there is --remove-faces");
    }
    const HoleFilter& filter = settings.filter;
    if (!filter.empty() && (!options.holes.empty() || !options.edges.empty() || settings.grow ||
                            std::ranges::count(ways.begin() + 1, ways.end(), true) > 0)) {
        return fail(ErrorCode::Usage,
                    "--planar, --larger, --smaller and --sides choose among all holes: name none "
                    "besides");
    }
    for (const auto& [option, value] :
         {std::pair("--larger", filter.larger), std::pair("--smaller", filter.smaller)}) {
        if (auto valid = value ? expect_positive(option, *value) : Result<void>(); !valid) {
            return valid;
        }
    }
    if (filter.sides && *filter.sides < 1) {
        return fail(ErrorCode::Usage, "--sides must be at least 1, not {}", *filter.sides);
    }
    for (const std::string& boundary : options.boundaries) {
        auto& edges = settings.request.boundaries.emplace_back();
        if (auto result = take(parse_edges(boundary), edges); !result) {
            return result;
        }
        settings.load.content = io::Content::Curves;
    }
    for (const std::string& split : options.splits) {
        if (split == "auto") {
            settings.request.split_sharp = true;
        } else if (auto result = take(parse_vertices(split), settings.splits.emplace_back());
                   !result) {
            return result;
        }
    }
    if (!options.supports.empty()) {
        if (options.boundaries.empty()) {
            return fail(ErrorCode::Usage, "--support is for edges of a --boundary");
        }
        if (auto result = take(parse_supports(options.supports), settings.request.supports);
            !result) {
            return result;
        }
        for (const auto& [edge, face] : settings.request.supports) {
            if (std::ranges::none_of(settings.request.boundaries,
                                     [edge = edge](const std::vector<int>& boundary) {
                                         return std::ranges::count(boundary, edge) > 0;
                                     })) {
                return fail(ErrorCode::Usage, "--support: edge {} is no edge of the border", edge);
            }
        }
    }
    if (settings.grow && !options.splits.empty()) {
        return fail(ErrorCode::Usage, "--split is for fills, and --grow makes none");
    }
    for (const auto& [text, faces] : {std::pair(&options.replace_faces, &settings.replace_faces),
                                      std::pair(&options.remove_faces, &settings.remove_faces)}) {
        if (!text->empty()) {
            if (auto result = take(parse_faces(*text), *faces); !result) {
                return result;
            }
        }
    }
    return {};
}

/// Which holes, and how smooth.
Result<void> take_wishes(const FillOptions& options, FillRequest& request) {
    if (!options.holes.empty()) {
        if (!options.edges.empty()) {
            return fail(ErrorCode::Usage, "give --hole or --edges, not both");
        }
        if (auto result = take(parse_holes(options.holes), request.holes); !result) {
            return result;
        }
    }
    if (!options.edges.empty()) {
        if (auto result = take(parse_edges(options.edges), request.edges); !result) {
            return result;
        }
    }
    if (!options.edge_continuity.empty()) {
        if (auto result =
                take(parse_edge_continuity(options.edge_continuity), request.edge_continuity);
            !result) {
            return result;
        }
    }
    request.all_loops = options.all_loops;
    request.keep_bad = options.keep_bad;
    return take(parse_continuity(options.continuity), request.continuity);
}

/// How far bridges and the curves of --connect reach; a loft has it as its own option.
Result<void> take_tension(const FillOptions& options, FillRequest& request) {
    if (!options.tension) {
        return {};
    }
    if (request.method == "auto" && request.bridge) {
        request.method = "loft";
    }
    const auto own = options_of(request.method);
    const bool taken = std::ranges::any_of(
        own, [](const MethodOption& option) { return option.key == "tension"; });
    if (taken) {
        request.options["tension"] = {OptionKind::Number, {*options.tension}, {}};
    } else if (!request.connect) {
        return fail(ErrorCode::Usage,
                    "--tension is for bridges, for --connect and for the method loft: the method "
                    "{} finds the length of its cross tangents itself; points (--through) and "
                    "edges (--through-edges) say how far a face bulges",
                    request.method);
    }
    return take_positive("--tension", options.tension, 1.0, request.tension);
}

/// The method's own options.
Result<void> take_own(const FillOptions& options, FillRequest& request) {
    for (const std::string& text : options.own) {
        auto value = parse_option(options.method, options_of(options.method), text);
        if (!value) {
            return fail(ErrorCode::Usage, "--option: {}", value.error().message);
        }
        if (!request.options.insert(*value).second) {
            return fail(ErrorCode::Usage, "--option: '{}' is given twice", value->first);
        }
    }
    return {};
}

/// How, and how exactly.
Result<void> take_limits(const FillOptions& options, FillRequest& request) {
    request.method = options.method;
    request.recognise = options.recognise == "off"          ? std::nullopt
                        : options.recognise == "neighbours" ? std::optional(Scope::Neighbours)
                                                            : std::optional(Scope::Model);
    request.prefer = options.prefer == "original" ? Prefer::Original : Prefer::Tight;
    request.effort = options.effort == "quick"      ? Effort::Quick
                     : options.effort == "thorough" ? Effort::Thorough
                                                    : Effort::Normal;
    request.plate_setting =
        options.occt_setting == "tuned" ? PlateSetting::Tuned : PlateSetting::Default;
    double timeout = std::chrono::duration<double>(request.plate_limit).count();
    if (options.jobs && *options.jobs < 1) {
        return fail(ErrorCode::Usage, "--jobs must be at least 1, not {}", *options.jobs);
    }
    for (const auto& result :
         {expect_method(options.method),
          take_positive("--tolerance", options.tolerance, 1.0, request.tolerance.linear),
          take_positive("--angle", options.angle, kPi / 180.0, request.tolerance.angular),
          take_positive("--curvature", options.curvature, 0.01, request.tolerance.curvature),
          take_positive("--occt-timeout", options.occt_timeout, 1.0, timeout),
          validate(request.tolerance)}) {
        if (!result) {
            return result;
        }
    }
    request.plate_limit = std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * timeout));
    return {};
}

Result<void> validate_fill(Command& command, FillOptions& options) {
    FillSettings& settings = options.settings;
    settings.input = command.input;
    settings.output = options.output;
    if (auto format = take(take_output(command, options.output), settings.format); !format) {
        return format;
    }
    if (!options.through.empty()) {
        command.more_inputs = {options.through};
    }
    if (!options.through_edges.empty()) {
        if (auto edges = take(parse_edges_on_faces(options.through_edges), settings.through_edges);
            !edges) {
            return edges;
        }
        settings.load.content = io::Content::Curves;
    }
    for (const auto& result :
         {take_borders(options, settings), take_wishes(options, settings.request),
          take_limits(options, settings.request), take_own(options, settings.request),
          take_tension(options, settings.request), validate_sewing(settings.load),
          validate_mesh(options.mesh),
          expect_writable("-o", options.output, command.input, force_of(options.force))}) {
        if (!result) {
            return result;
        }
    }
    settings.mesh = to_io(options.mesh);
    return {};
}

/// What `bridge` has instead of the choice of holes.
Result<void> take_bridge(FillOptions& options) {
    options.boundaries = {options.edges};
    options.edges.clear();
    options.settings.request.connect = true;
    options.settings.request.bridge = true;
    return {};
}

/// All options that are in no group of the help yet become one, but for those of every command.
void name_group(CLI::App& app, const std::string& name) {
    for (CLI::Option* option : app.get_options([](const CLI::Option* option) {
             return option->get_group() == kNoGroup && !option->get_positional();
         })) {
        option->group(name);
    }
}

void add_holes(CLI::App& app, FillOptions& options) {
    add_list(app, "--hole,--holes", options.holes,
             "Only these holes, as `suture inspect` numbers them; 3+4 is one face with an island")
        ->option_text("ID...");
    add_list(app, "--edges,--edge", options.edges,
             "Only the holes that have these edges (FreeCAD's EdgeN)")
        ->option_text("E...");
    HoleFilter& filter = options.settings.filter;
    app.add_flag("--planar", filter.planar, "Only holes whose border lies in a plane");
    app.add_option("--larger", filter.larger, "Only holes of a larger diameter")->option_text("MM");
    app.add_option("--smaller", filter.smaller, "Only holes of a smaller diameter")
        ->option_text("MM");
    app.add_option("--sides", filter.sides, "Only holes with so many sides")->option_text("N");
    app.add_flag("--all-loops", options.all_loops,
                 "Fill rims of open sheets and doubtful loops too");
    app.add_option("--split", options.splits,
                   "Cut a hole in two along a line between two of its corners (FreeCAD's VertexN), "
                   "or between sharp turns where flat faces fit better; may be given several times")
        ->allow_extra_args(false)
        ->option_text("V,V|auto");
    app.add_flag("--grow", options.settings.grow,
                 "Let the neighbours of the holes grow together where they can, instead of a fill: "
                 "an edge where a fillet was");
    name_group(app, "Which holes");
}

void add_support(CLI::App& app, FillOptions& options) {
    add_list(app, "--support", options.supports,
             "Edges of the border, and the face that the new one is tangent to there, for edges "
             "without a face or instead of their own: 3=7")
        ->option_text("E=F...");
}

void add_borders(CLI::App& app, FillOptions& options) {
    app.add_option("--boundary", options.boundaries,
                   "A new face over these edges (FreeCAD's EdgeN), in any order: rims of one or "
                   "more sheets, loose curves; once for each face")
        ->allow_extra_args(false)
        ->option_text("E...");
    app.add_flag("--connect", options.settings.request.connect,
                 "Bridge gaps between the ends of a --boundary by curves");
    add_support(app, options);
    add_list(app, "--replace-faces", options.replace_faces,
             "These faces (FreeCAD's FaceN) go, and what they leave is filled anew")
        ->option_text("F...");
    add_list(app, "--remove-faces", options.remove_faces,
             "These faces go, and their neighbours grow together: a fillet becomes an edge again")
        ->option_text("F...");
    name_group(app, "Instead of holes: chosen edges, faces that go");
}

void add_choice(CLI::App& app, FillOptions& options) {
    add_holes(app, options);
    add_borders(app, options);
}

void add_wishes(CLI::App& app, FillOptions& options) {
    app.add_option("--method", options.method,
                   "Fill method (default auto: tries, measures, keeps the best); see `suture "
                   "methods`")
        ->option_text("ID");
    app.add_option("--option", options.own,
                   "An option that only this method has, as `suture methods` lists them; may be "
                   "given several times")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE");
    app.add_option("--effort", options.effort,
                   "How much auto tries where nothing is within tolerance at once: what is quick, "
                   "some seconds more a hole (default), or all that can come nearer")
        ->check(CLI::IsMember({"quick", "normal", "thorough"}))
        ->option_text("quick|normal|thorough");
    app.add_option("--recognise", options.recognise,
                   "Where the very face that was lost is looked for: around the hole, in the "
                   "whole model (default), or not at all")
        ->check(CLI::IsMember({"off", "neighbours", "model"}))
        ->option_text("off|neighbours|model");
    app.add_option("--prefer", options.prefer,
                   "Of a rolling ball's own envelope and a face's approximation of one: the "
                   "tighter (default) or the original")
        ->check(CLI::IsMember({"tight", "original"}))
        ->option_text("tight|original");
    app.add_option("--continuity", options.continuity,
                   "How the new face joins its neighbours: G0 (position), G1 (tangent), G2 "
                   "(curvature) or auto")
        ->option_text("G0|G1|G2|auto");
    add_list(app, "--edge-continuity", options.edge_continuity,
             "The same for single edges: 12=G2,13=G0")
        ->option_text("E=G2...");
    app.add_option(
           "--through", options.through,
           "Points that the new face has to pass: a text file with x, y, z on each line, or "
           "x, y, z, nx, ny, nz with its normal there")
        ->option_text("POINTS.csv");
    add_list(
        app, "--through-edges", options.through_edges,
        "Edges of the model that the new face has to follow (FreeCAD's EdgeN); 12=7: tangent to "
        "face 7 there")
        ->option_text("E|E=F...");
    app.add_option("--tension", options.tension,
                   "Bridges, and curves of --connect: how far they go on straight from both ends, "
                   "1 (default) as the gap is wide")
        ->option_text("FACTOR");
    app.add_flag("--merge", options.settings.merge,
                 "Make new faces one with neighbours that lie on the same surface");
    app.add_option("--occt-setting", options.occt_setting,
                   "Method occt: OCCT's default settings, or better ones")
        ->check(CLI::IsMember({"default", "tuned"}))
        ->option_text("default|tuned");
    app.add_option("--occt-timeout", options.occt_timeout,
                   "Method occt: give up a hole after so many seconds (default 120)")
        ->option_text("SECONDS");
    name_group(app, "How it is filled");
    app.add_option("--tolerance", options.tolerance, "Largest gap (default 0.001)")
        ->option_text("MM");
    app.add_option("--angle", options.angle, "Largest angle of tangent joins (default 0.01)")
        ->option_text("DEG");
    app.add_option("--curvature", options.curvature,
                   "Largest curvature mismatch of G2 joins (default 2)")
        ->option_text("PERCENT");
    app.add_flag("--keep-bad", options.keep_bad,
                 "Put fills into the model that are bad: folded, clashing, far off, sharp");
    name_group(app, "What counts as good");
}

/// What `fill` and `bridge` have in common: all but the choice of what is filled.
std::shared_ptr<Command> add_filling(CLI::App& app, const std::string& name,
                                     const CommandHelp& help,
                                     void (*choice)(CLI::App&, FillOptions&),
                                     Result<void> (*prepare)(FillOptions&)) {
    auto command = add_command(app, name, help);
    auto options = std::make_shared<FillOptions>();
    add_input(*command);
    CLI::App& sub = *command->app;
    sub.add_option("-o,--output", options->output,
                   "The file to write: .step .iges .brep, or a mesh .stl .off .obj .3mf .glb")
        ->required()
        ->option_text("OUT");
    sub.add_flag("--force", options->force, "Allow OUT to be IN itself");
    sub.add_option("--jobs,-j", options->jobs, "Threads (default: all cores)")->option_text("N");
    name_group(sub, "General");
    choice(sub, *options);
    add_wishes(sub, *options);
    add_sewing(*command, options->settings.load);
    add_mesh(sub, options->mesh);
    name_group(sub, "Sewing, and meshes as output");
    add_reports(*command);
    add_picture(*command);
    name_group(sub, "Reports and pictures");
    Command* self = command.get();
    command->validate = [options, self, prepare] {
        return prepare(*options).and_then([&] { return validate_fill(*self, *options); });
    };
    command->run = [options, self](Run& run) -> Result<Outcome> {
        std::optional<tbb::global_control> threads;
        if (options->jobs) {
            threads.emplace(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(*options->jobs));
        }
        if (!options->through.empty()) {
            if (auto points =
                    take(read_points(options->through), options->settings.request.through);
                !points) {
                return tl::unexpected(points.error());
            }
        }
        Result<FillSummary> filled = fill_model(run, options->settings);
        if (!filled) {
            return tl::unexpected(filled.error());
        }
        const auto summary = std::make_shared<const FillSummary>(std::move(*filled));
        Outcome outcome = report_fill(*summary, options->settings);
        add_fill_page(*self, summary, options->settings.request.tolerance, outcome);
        return outcome;
    };
    return command;
}

}  // namespace

std::shared_ptr<Command> add_fill(CLI::App& app) {
    auto command =
        add_filling(app, "fill", kHelp, add_choice, [](FillOptions&) { return Result<void>(); });
    add_batch_options(*command->app, true);
    name_group(*command->app, "Many files");
    return command;
}

std::shared_ptr<Command> add_bridge(CLI::App& app) {
    const auto choice = [](CLI::App& sub, FillOptions& options) {
        add_list(sub, "--edges,--edge", options.edges,
                 "The edges of both sides (FreeCAD's EdgeN), in any order")
            ->required()
            ->option_text("E...");
        add_support(sub, options);
        name_group(sub, "What is bridged");
    };
    return add_filling(app, "bridge", kBridgeHelp, choice, take_bridge);
}

}  // namespace suture::cli
