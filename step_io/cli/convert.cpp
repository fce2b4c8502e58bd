#include "cli/convert.h"

#include "cli/arguments.h"
#include "cli/batch.h"
#include "cli/load.h"
#include "cli/options.h"
#include "cli/report_json.h"
#include "files/losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace suture::cli {
namespace {

/// OCCT's mesher takes nothing finer.
constexpr double kLeastDeflection = 1e-7;

constexpr CommandHelp kHelp{
    "Convert a model to another format, or to a mesh",
    "Convert a model to the format that the output's ending asks for: .step .stp, .iges .igs, "
    ".brep (and FreeCAD's .bin), or as a watertight mesh .stl .off .obj .3mf .glb, for OpenSCAD's "
    "import() and 3D printing. Names, colours and the assembly tree stay where the format has a "
    "place for them.",
    "  suture convert part.igs part.step --sew      loose faces become shells and solids\n"
    "  suture convert part.step part.3mf            a mesh for printing, with its parts and "
    "colours\n"
    "  suture convert part.step part.glb            for viewers in browsers and for rendering\n"
    "  suture convert part.step part.stl --deflection 0.01\n"
    "Exit codes: 0 done, 4 the mesh is written, but open, 2 the file cannot be read, 1 wrong "
    "usage,\n"
    "5 the output cannot be written.\n"};

struct ConvertOptions {
    std::filesystem::path output;
    LoadOptions load{false, std::nullopt};
    MeshSettings mesh;
    bool force = false;
    bool open_ok = false;
    io::Format format = io::Format::Step;
};

Result<void> validate(Command& command, ConvertOptions& options) {
    const Result<io::Format> format = take_output(command, options.output);
    if (!format) {
        return tl::unexpected(format.error());
    }
    options.format = *format;
    if (options.load.sew_tolerance) {
        options.load.sew = true;
    }
    for (const auto& result :
         {validate_mesh(options.mesh), validate_sewing(options.load),
          expect_writable("OUT", options.output, command.input, force_of(options.force))}) {
        if (!result) {
            return result;
        }
    }
    return {};
}

/// What is to be said of the mesh that was written; nothing of other formats.
Result<std::optional<io::MeshFacts>> write(const io::ModelFile& model,
                                           const ConvertOptions& options) {
    if (!io::is_mesh(options.format)) {
        return io::write_model(model, options.output, options.format, {}).map([](const auto&) {
            return std::optional<io::MeshFacts>();
        });
    }
    return io::write_mesh(model, options.output, options.format, to_io(options.mesh))
        .map([](const io::MeshFacts& facts) { return std::optional(facts); });
}

Json json_of_left_out(const std::vector<io::UnmeshedFace>& faces) {
    Json list = Json::array();
    for (const io::UnmeshedFace& face : faces) {
        list.push_back({{"face", face.face},
                        {"part", face.part},
                        {"has_area", face.area},
                        {"reason", face.reason}});
    }
    return list;
}

/// The faces that the mesh is without, as part of the verdict; the worst news last.
std::string text_of_left_out(const std::vector<io::UnmeshedFace>& faces) {
    const auto missing = std::ranges::find_if(faces, &io::UnmeshedFace::area);
    const auto count = std::ranges::count_if(faces, &io::UnmeshedFace::area);
    const auto collapsed = std::ssize(faces) - count;
    std::string text;
    if (collapsed > 0) {
        text += fmt::format("; {} without area", counted(collapsed, "face"));
    }
    if (count > 0) {
        text += fmt::format("; WITHOUT {}: {}", counted(count, "face"), io::text_of(*missing));
    }
    return text;
}

/// What a user has to know of a mesh.
void tell_mesh(const io::MeshFacts& mesh, const ConvertOptions& options, Outcome& outcome) {
    outcome.document["mesh"] = {
        {"triangles", mesh.triangles},   {"points", mesh.points},
        {"deflection", mesh.deflection}, {"needles_removed", mesh.needles},
        {"open_edges", mesh.open_edges}, {"faces_left_out", json_of_left_out(mesh.left_out)}};
    outcome.verdict += fmt::format(", {} triangles", mesh.triangles);
    const double wanted = options.mesh.deflection.value_or(mesh.deflection);
    if (mesh.deflection > wanted) {
        outcome.verdict += fmt::format(
            ", with a deflection of {} mm: OCCT could not mesh all faces "
            "with {} mm",
            short_number(mesh.deflection), short_number(wanted));
    }
    outcome.verdict += text_of_left_out(mesh.left_out);
    if (std::ranges::any_of(mesh.left_out, &io::UnmeshedFace::area)) {
        outcome.next =
            "next: try another --deflection; `suture check` says what is wrong with the face";
        outcome.exit_code = kOutOfTolerance;
        return;
    }
    if (mesh.open_edges == 0) {
        return;
    }
    outcome.verdict +=
        fmt::format("; the mesh is OPEN along {} edges of triangles", mesh.open_edges);
    outcome.next = options.open_ok
                       ? ""
                       : "next: `suture fill` closes the holes, --sew joins loose faces; "
                         "--open-ok takes an open mesh as good";
    outcome.exit_code = options.open_ok ? kDone : kOutOfTolerance;
}

Result<Outcome> convert(Run& run, const Command& command, const ConvertOptions& options) {
    constexpr double kLoaded = 0.6;
    const Result<LoadedModel> model = load_model(run, command.input, options.load, kLoaded);
    if (!model) {
        return tl::unexpected(model.error());
    }
    const Stopwatch watch;
    const Progress progress =
        run.stage(Stage::Writing, "writing " + options.output.filename().string(), kLoaded, 1.0);
    const Result<std::optional<io::MeshFacts>> written = write(model->file, options);
    if (!written) {
        return tl::unexpected(written.error());
    }
    const std::vector<std::string> lost = io::lost_in(model->file, options.format);
    for (const std::string& loss : lost) {
        print_warning(loss);
    }
    Outcome outcome;
    outcome.verdict =
        fmt::format("wrote {} ({})", options.output.string(), io::to_string(options.format));
    if (model->sewing.changed) {
        outcome.verdict += fmt::format("; {}, {} left", text_of(model->sewing),
                                       counted(model->sewing.free_edges_after, "free edge"));
    }
    outcome.document = {
        {"output", options.output.string()},
        {"output_format", io::to_string(options.format)},
        {"model", json_of(model->file)},
        {"sewing", json_of(model->sewing)},
        {"lost", lost},
        {"seconds",
         {{"read", model->seconds_read}, {"sew", model->seconds_sew}, {"write", watch.seconds()}}}};
    if (*written) {
        tell_mesh(**written, options, outcome);
    }
    return outcome;
}

}  // namespace

void add_mesh(CLI::App& app, MeshSettings& mesh) {
    app.add_option("--deflection", mesh.deflection,
                   "Meshes: how far facets may lie from the faces (default: a thousandth of the "
                   "model's diagonal)")
        ->option_text("MM");
    app.add_option("--angular-deflection", mesh.angular_deflection,
                   "Meshes: largest angle between neighbouring facets (default 20)")
        ->option_text("DEG");
}

Result<void> validate_mesh(const MeshSettings& mesh) {
    if (mesh.deflection) {
        Result<void> positive = expect_positive("--deflection", *mesh.deflection);
        if (!positive) {
            return positive;
        }
        if (*mesh.deflection < kLeastDeflection) {
            return fail(ErrorCode::Usage, "--deflection must be at least {:g} mm, not {:g}",
                        kLeastDeflection, *mesh.deflection);
        }
    }
    if (mesh.angular_deflection) {
        return expect_positive("--angular-deflection", *mesh.angular_deflection);
    }
    return {};
}

io::MeshOptions to_io(const MeshSettings& mesh) {
    io::MeshOptions options;
    options.deflection = mesh.deflection.value_or(options.deflection);
    if (mesh.angular_deflection) {
        options.angular_deflection = radians(*mesh.angular_deflection);
    }
    return options;
}

std::shared_ptr<Command> add_convert(CLI::App& app) {
    auto command = add_command(app, "convert", kHelp);
    auto options = std::make_shared<ConvertOptions>();
    add_input(*command);
    CLI::App& sub = *command->app;
    sub.add_option("OUT", options->output, "The file to write")->required()->option_text(" ");
    sub.add_flag("--sew", options->load.sew,
                 "Sew faces and shells that lie on each other, into solids where they close");
    sub.add_option("--sew-tolerance", options->load.sew_tolerance,
                   "Sew edges that lie closer than this (default: from the model)")
        ->option_text("MM");
    add_mesh(sub, options->mesh);
    sub.add_flag("--open-ok", options->open_ok,
                 "Meshes: an open one is no failure (exit code 4), as of surface models");
    sub.add_flag("--force", options->force, "Allow OUT to be IN itself");
    add_batch_options(*command->app, true);
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, *options); };
    command->run = [options, self](Run& run) { return convert(run, *self, *options); };
    return command;
}

}  // namespace suture::cli
