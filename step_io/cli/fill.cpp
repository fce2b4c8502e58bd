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
    "  suture fill part.step -o filled.step --continuity G1 --edge-continuity 12=G2,13=G0\n"
    "  suture fill part.step -o filled.step --hole 2 --through scan.csv   points to pass\n"
    "  suture fill wing.igs -o wing.step --report wing.html   loose faces are sewn first\n"
    "  suture fill part.step -o part.3mf --deflection 0.02    a watertight mesh\n"
    "Exit codes: 0 done, 4 done but out of tolerance or some hole refused, 3 no hole (nothing is "
    "written),\n2 the file cannot be read, 1 wrong usage, 5 the output could not be written.\n"};

struct FillOptions {
    std::filesystem::path output;
    std::string holes, edges;
    std::string method = "auto";
    std::vector<std::string> own;
    std::string continuity = "auto";
    std::string edge_continuity;
    std::string occt_setting = "default";
    std::string recognise = "model";
    std::string prefer = "tight";
    std::filesystem::path through;
    std::string through_edges;
    std::optional<double> tolerance, angle, curvature, occt_timeout;
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
        if (auto edges = take(parse_edges(options.through_edges), settings.through_edges); !edges) {
            return edges;
        }
    }
    for (const auto& result :
         {take_wishes(options, settings.request), take_limits(options, settings.request),
          take_own(options, settings.request), validate_sewing(settings.load),
          validate_mesh(options.mesh),
          expect_writable("-o", options.output, command.input, force_of(options.force))}) {
        if (!result) {
            return result;
        }
    }
    settings.mesh = to_io(options.mesh);
    return {};
}

void add_choice(CLI::App& app, FillOptions& options) {
    add_list(app, "--hole,--holes", options.holes,
             "Only these holes, as `suture inspect` numbers them; 3+4 is one face with an island")
        ->option_text("ID...");
    add_list(app, "--edges,--edge", options.edges,
             "Only the holes that have these edges (FreeCAD's EdgeN)")
        ->option_text("E...");
    app.add_flag("--all-loops", options.all_loops,
                 "Fill rims of open sheets and doubtful loops too");
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
    app.add_option("--through", options.through,
                   "Points that the new face has to pass: a text file with x, y, z on each line")
        ->option_text("POINTS.csv");
    add_list(app, "--through-edges", options.through_edges,
             "Edges of the model that the new face has to follow (FreeCAD's EdgeN)")
        ->option_text("E...");
    add_list(app, "--edge-continuity", options.edge_continuity,
             "The same for single edges: 12=G2,13=G0")
        ->option_text("E=G2...");
    app.add_option("--tolerance", options.tolerance, "Largest gap (default 0.001)")
        ->option_text("MM");
    app.add_option("--angle", options.angle, "Largest angle of tangent joins (default 0.01)")
        ->option_text("DEG");
    app.add_option("--curvature", options.curvature,
                   "Largest curvature mismatch of G2 joins (default 2)")
        ->option_text("PERCENT");
    app.add_option("--occt-setting", options.occt_setting,
                   "Method occt: OCCT's default settings, or better ones")
        ->check(CLI::IsMember({"default", "tuned"}))
        ->option_text("default|tuned");
    app.add_option("--occt-timeout", options.occt_timeout,
                   "Method occt: give up a hole after so many seconds (default 120)")
        ->option_text("SECONDS");
    app.add_flag("--keep-bad", options.keep_bad,
                 "Put fills into the model that are bad: folded, clashing, far off, sharp");
    app.add_option("--jobs,-j", options.jobs, "Threads (default: all cores)")->option_text("N");
}

}  // namespace

std::shared_ptr<Command> add_fill(CLI::App& app) {
    auto command = add_command(app, "fill", kHelp);
    auto options = std::make_shared<FillOptions>();
    add_input(*command);
    CLI::App& sub = *command->app;
    sub.add_option("-o,--output", options->output,
                   "The file to write: .step .iges .brep, or a mesh .stl .off .obj .3mf")
        ->required()
        ->option_text("OUT");
    add_choice(sub, *options);
    add_wishes(sub, *options);
    add_sewing(*command, options->settings.load);
    add_mesh(sub, options->mesh);
    add_reports(*command);
    add_picture(*command);
    sub.add_flag("--force", options->force, "Allow OUT to be IN itself");
    add_batch_options(*command->app, true);
    Command* self = command.get();
    command->validate = [options, self] { return validate_fill(*self, *options); };
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

}  // namespace suture::cli
