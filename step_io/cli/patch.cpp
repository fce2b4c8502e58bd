#include "cli/patch.h"

#include "cli/arguments.h"
#include "cli/options.h"
#include "cli/shell_output.h"
#include "files/read_obj.h"
#include "suture/base/tolerance.h"
#include "suture/faces/make_shell.h"
#include "suture/fill/manifold/cells.h"
#include "suture/fill/manifold/fold.h"
#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/make_middle.h"
#include "suture/fill/manifold/star_mesh.h"

#include <Eigen/SVD>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace suture::cli {
namespace {

using namespace suture::manifold;

constexpr CommandHelp kHelp{
    "Make a smooth n-sided patch from a control mesh",
    "Make the C^k patch of a control mesh: layers of quads around a hole of 3 or more sides, in an "
    "OBJ file. The hole's corners are its vertices of valence 4, the outer border has as many of "
    "valence 2. The patch follows the mesh as a B-spline follows its control points, and along its "
    "border it is one B-spline of degree k + 1.",
    "  suture patch star.obj -o star.step                   k = 2\n"
    "  suture patch star.obj --k 3 --aperture 0.5 -o star.step\n"
    "  suture patch star.obj --k 1 --exact -o star.step     rational cells, nothing fitted\n"
    "Exit codes: 0 done, 1 wrong usage, 2 no such mesh, 4 done but out of tolerance or invalid, "
    "5 the output cannot be written.\n"};

struct PatchOptions {
    std::filesystem::path output;
    int k = 2;
    std::optional<double> aperture;
    double tolerance = 1e-6;  ///< relative to the diameter
    bool exact = false;
    bool quads = false;
    bool force = false;
    io::Format format = io::Format::Step;
};

Result<void> validate(Command& command, PatchOptions& options) {
    const Result<io::Format> format = take_output(command, options.output);
    if (!format) {
        return tl::unexpected(format.error());
    }
    options.format = *format;
    if (options.k < 0 || options.k > 4) {
        return fail(ErrorCode::Usage, "--k is 0 to 4, not {}", options.k);
    }
    if (options.aperture) {
        if (auto positive = expect_positive("--aperture", *options.aperture); !positive) {
            return positive;
        }
    }
    if (auto positive = expect_positive("--tolerance", options.tolerance); !positive) {
        return positive;
    }
    if (options.exact && options.k > kMostExactOrder) {
        return fail(ErrorCode::Usage, "--exact is for --k 0 and 1, not {}", options.k);
    }
    return expect_writable("-o", options.output, command.input, force_of(options.force));
}

/// Whether a mesh spans a surface at all: else all its vertices lie in a point or on a line.
Result<void> expect_area(const Command& command, const Eigen::Matrix3Xd& vertices) {
    const Eigen::Matrix3Xd about = vertices.colwise() - vertices.rowwise().mean();
    const Eigen::Vector3d extents = Eigen::JacobiSVD<Eigen::Matrix3Xd>(about).singularValues();
    constexpr double kNone = 1e-9;
    if (!(extents[0] > 0.0)) {
        return fail(ErrorCode::Unreadable, "{}: all {} vertices lie in one point",
                    command.input.string(), vertices.cols());
    }
    if (extents[1] <= kNone * extents[0]) {
        return fail(ErrorCode::Unreadable, "{}: all {} vertices lie on one line",
                    command.input.string(), vertices.cols());
    }
    return {};
}

/// Why a patch is not as it should be; empty: it is.
std::vector<std::string> reasons_of(const MadeMiddle& middle, double tolerance,
                                    const std::optional<Fold>& fold, const Validity& validity) {
    std::vector<std::string> reasons;
    if (fold) {
        reasons.push_back(fmt::format(
            "the surface folds at ({:.6g}, {:.6g}, {:.6g}): its normal turns by {:.0f} deg from "
            "one sample to the next",
            fold->at.x(), fold->at.y(), fold->at.z(), degrees(fold->angle)));
    }
    if (middle.error > tolerance) {
        reasons.push_back(
            fmt::format("the middle is {:.2g} off, above {:.2g}", middle.error, tolerance));
    }
    if (!validity.valid) {
        reasons.push_back(validity.problems.empty() ? "the shape is not valid"
                                                    : "not valid: " + validity.problems.front());
    }
    return reasons;
}

Result<Outcome> patch(Run& run, const Command& command, const PatchOptions& options) {
    Progress progress = run.stage(Stage::Reading, "reading", 0.0, 0.1);
    auto mesh = io::read_obj(command.input);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    const double diameter =
        (mesh->vertices.rowwise().maxCoeff() - mesh->vertices.rowwise().minCoeff()).norm();
    if (auto spans = expect_area(command, mesh->vertices); !spans) {
        return tl::unexpected(spans.error());
    }
    const auto star_mesh = recognise_star(std::move(*mesh));
    if (!star_mesh) {
        return fail(ErrorCode::Unreadable, "{}: {}", command.input.string(),
                    star_mesh.error().message);
    }
    const auto star = Star::make(star_mesh->size(options.k, options.aperture.value_or(0.0)));
    if (!star) {
        return fail(ErrorCode::Unreadable, "{}: {}", command.input.string(), star.error().message);
    }
    progress = run.stage(Stage::Filling, "fitting the middle", 0.1, 0.6);
    const Stopwatch watch;
    const StarSurface surface(*star, star_mesh->points(*star));
    const MiddleForm form = options.exact   ? MiddleForm::Cells
                            : options.quads ? MiddleForm::Quads
                                            : MiddleForm::Auto;
    auto middle = make_middle(surface, form, options.tolerance * diameter);
    if (!middle) {
        return fail(ErrorCode::Unreadable, "{}: {}", command.input.string(),
                    middle.error().message);
    }
    const auto shell = make_shell(lay_out(surface, std::move(middle->middle), {}));
    if (!shell) {
        return tl::unexpected(shell.error());
    }
    const double seconds = watch.seconds();
    const auto written = write_shell(run, command, *shell, options.format, 0.6);
    if (!written) {
        return tl::unexpected(written.error());
    }
    // With k = 0 kinks are as they should be, and look like folds.
    const auto fold = options.k > 0 ? find_fold(surface) : std::nullopt;
    const std::vector<std::string> reasons =
        reasons_of(*middle, options.tolerance * diameter, fold, written->validity);
    Outcome outcome;
    outcome.exit_code = reasons.empty() ? kDone : kOutOfTolerance;
    outcome.verdict = fmt::format(
        "wrote {}: {} sides, {} layers, k = {}, aperture {:.4g}; {}; {}, largest gap {:.3g}, angle "
        "{:.3g} deg",
        options.output.string(), star->n(), star->layers(), star->k(), star->aperture(),
        middle->note, counted(written->validity.faces, "face"), written->max_gap,
        degrees(written->max_angle));
    for (const std::string& reason : reasons) {
        outcome.verdict += "; " + reason;
    }
    outcome.document = {{"output", options.output.string()},
                        {"output_format", io::to_string(options.format)},
                        {"sides", star->n()},
                        {"layers", star->layers()},
                        {"k", star->k()},
                        {"aperture", star->aperture()},
                        {"aperture_bound", Star::aperture_bound(star->k(), star->n())},
                        {"diameter", diameter},
                        {"exact", middle->exact},
                        {"spans", middle->spans},
                        {"fit_error", middle->error},
                        {"reasons", reasons},
                        {"seconds", seconds}};
    outcome.document.update(json_of(*written));
    return outcome;
}

}  // namespace

std::shared_ptr<Command> add_patch(CLI::App& app) {
    auto command = add_command(app, "patch", kHelp);
    auto options = std::make_shared<PatchOptions>();
    CLI::App& sub = *command->app;
    sub.add_option("MESH", command->input, "The control mesh: a Wavefront OBJ file")
        ->required()
        ->option_text(" ");
    sub.add_option("-o,--output", options->output, "The file to write")
        ->required()
        ->option_text("OUT");
    sub.add_option("--k", options->k, "Order of continuity, 0 to 4 (default 2)")->option_text("K");
    sub.add_option("--aperture", options->aperture,
                   "Size of the central face in the parameters: how far the innermost control "
                   "points reach (default: even knots where possible, else 0.8 of the bound)")
        ->option_text("F");
    sub.add_option("--tolerance", options->tolerance,
                   "How far the middle may be off, relative to the mesh's diameter (default 1e-6)")
        ->option_text("T");
    CLI::Option* exact = sub.add_flag(
        "--exact", options->exact,
        "Write the middle exactly, as rational cells between its knot curves (k = 0 and 1 only)");
    sub.add_flag("--quads", options->quads,
                 "Write the middle as fitted quads whatever their error (default for k = 0 and 1: "
                 "quads within the tolerance, else exact cells)")
        ->excludes(exact);
    sub.add_flag("--force", options->force, "Allow OUT to be the mesh itself");
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, *options); };
    command->run = [options, self](Run& run) { return patch(run, *self, *options); };
    return command;
}

}  // namespace suture::cli
