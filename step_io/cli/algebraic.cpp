#include "cli/algebraic.h"

#include "cli/algebraic_problem.h"
#include "cli/arguments.h"
#include "cli/options.h"
#include "cli/shell_output.h"
#include "cli/text_file.h"
#include "suture/faces/make_shell.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/parse.h"
#include "suture/fill/algebraic/patches.h"

#include <fmt/format.h>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "Solve a piecewise algebraic hole given by polynomials",
    "Fill a hole between algebraic surfaces that a JSON file gives as polynomials and planes, in "
    "exact arithmetic: which piecewise polynomials join them with G^k, and the member that is "
    "fair and of a single sheet.",
    "  suture algebraic table.json                       rank, dimension, polynomials\n"
    "  suture algebraic table.json -o table.step         the surface as B-spline faces\n"
    "  suture algebraic table.json --mesh table.obj      a mesh of the surface\n"
    "  suture algebraic table.json --json > table.out    exact coefficients\n"
    "  suture algebraic table.json --at 0.4,0.4,0.4      its cell and value at a point\n"
    "Exit codes: 0 done, 1 wrong usage, 2 the file cannot be read, 4 there is no such surface, 5 "
    "the "
    "output cannot be written.\n"};

/// How far the faces may lie from the polynomials, in sizes of the hole and in radians.
constexpr Tolerance kFaces{1e-7, radians(1e-3)};

struct AlgebraicOptions {
    std::filesystem::path output, mesh;
    io::Format format = io::Format::Step;
    std::vector<double> at;
    int divisions = 32;
};

Result<void> validate(Command& command, AlgebraicOptions& options) {
    if (!options.at.empty() && options.at.size() != 3) {
        return fail(ErrorCode::Usage, "--at takes x,y,z, not {} numbers", options.at.size());
    }
    if (options.divisions < 1) {
        return fail(ErrorCode::Usage, "--divisions is {}, less than 1", options.divisions);
    }
    if (!options.output.empty()) {
        const Result<io::Format> format = take_output(command, options.output);
        if (!format) {
            return tl::unexpected(format.error());
        }
        options.format = *format;
        auto writable = expect_writable("-o", options.output, command.input, Force::NotOffered);
        if (!writable) {
            return writable;
        }
    }
    if (!options.mesh.empty()) {
        command.outputs.push_back(options.mesh);
        command.one_output = command.outputs.size() == 1;
        return expect_writable("--mesh", options.mesh, command.input, Force::NotOffered);
    }
    return {};
}

/// The B-spline faces of a solution, written.
Result<void> write_faces(Run& run, const Command& command, const AlgebraicOptions& options,
                         const algebraic::ExactSolution& solution, Outcome& outcome) {
    const Progress progress = run.stage(Stage::Filling, "fitting faces", 0.4, 0.7);
    Tolerance goal = kFaces;
    goal.linear *= solution.unit.size;
    algebraic::FitReport fit;
    auto faces = algebraic::make_patches(solution.problem, solution.found, solution.unit, goal,
                                         goal, progress, fit);
    if (!faces) {
        return tl::unexpected(faces.error());
    }
    std::vector<Eigen::Vector3d> corners;
    for (const algebraic::UnitCurve& curve : solution.problem.curves) {
        corners.push_back(solution.unit.out(curve(0.0)));
    }
    const auto shell = make_shell(without_hole(std::move(*faces), {corners}));
    if (!shell) {
        return tl::unexpected(shell.error());
    }
    const auto written = write_shell(run, command, *shell, options.format, 0.7);
    if (!written) {
        return tl::unexpected(written.error());
    }
    outcome.document["faces"] = json_of(*written);
    outcome.document["faces"]["fit_error"] = fit.distance;
    outcome.document["faces"]["fit_angle_deg"] = degrees(fit.angle);
    outcome.document["faces"]["spans"] = fit.spans;
    outcome.verdict += fmt::format(
        "; wrote {}: {} within {:.2g} and {:.2g} deg of the polynomials, largest gap {:.2g}, "
        "angle {:.2g} deg",
        options.output.string(), counted(written->validity.faces, "face"), fit.distance,
        degrees(fit.angle), written->max_gap, degrees(written->max_angle));
    if (!written->validity.valid) {
        outcome.exit_code = kOutOfTolerance;
    }
    return {};
}

/// The cell that a point lies in, and the polynomial's value there; seen from the centre.
Json value_at(const algebraic::ExactSolution& solution, const Eigen::Vector3d& point) {
    const Eigen::Vector3d from_centre = solution.unit.in(point);
    double most = -INFINITY;
    int cell = 0;
    for (const algebraic::Sector& sector : solution.found.partition.sectors) {
        const algebraic::OnRay on =
            algebraic::on_ray(algebraic::directions_of(sector, solution.found.rays), from_centre);
        const double depth = on.t > 0.0 ? on.b.minCoeff() : -INFINITY;
        if (depth > most) {
            most = depth;
            cell = sector.cell;
        }
    }
    const auto g = rounded(solution.cells[static_cast<std::size_t>(cell)]);
    return {{"cell", cell + 1},
            {"inside", most >= 0.0},
            {"value", algebraic::evaluate<double>(g, {point.x(), point.y(), point.z()})}};
}

Result<Outcome> run_algebraic(Run& run, const Command& command, const AlgebraicOptions& options) {
    const auto problem = read_problem(command.input);
    if (!problem) {
        return tl::unexpected(problem.error());
    }
    const Progress progress = run.stage(Stage::Filling, "solving", 0.0, 0.4);
    const auto solution = algebraic::solve(*problem, progress);
    Outcome outcome;
    if (!solution && solution.error().code == ErrorCode::Refused) {
        outcome.exit_code = kOutOfTolerance;
        outcome.verdict = "refused: " + solution.error().message;
        outcome.document = {{"refused", solution.error().message}};
        return outcome;
    }
    if (!solution) {
        return tl::unexpected(solution.error());
    }
    outcome.document = json_of(*problem, *solution);
    const algebraic::Solution& found = solution->found;
    outcome.verdict = fmt::format(
        "G^{} of degree {} in {} cells: {} equations, {} unknowns, rank {}, dimension {}, {} "
        "different surfaces; single sheet proven{}",
        problem->k, found.degree, found.partition.cells, found.rows, found.columns, solution->rank,
        solution->dimension, solution->polynomials, found.guided_only ? "" : " under conditions");
    Section section{"", Table({">cell", "polynomial"}), found.tried};
    for (std::size_t c = 0; c < solution->cells.size(); ++c) {
        section.table.add({std::to_string(c + 1), to_text(rounded(solution->cells[c]))});
    }
    outcome.sections.push_back(std::move(section));
    if (!options.at.empty()) {
        const Json value = value_at(*solution, {options.at[0], options.at[1], options.at[2]});
        outcome.document["at"] = value;
        outcome.sections.back().notes.push_back("at the point: " + value.dump());
    }
    if (!options.output.empty()) {
        if (const auto done = write_faces(run, command, options, *solution, outcome); !done) {
            return tl::unexpected(done.error());
        }
    }
    if (!options.mesh.empty()) {
        const auto text = obj_of(*solution, options.divisions);
        if (!text) {
            return tl::unexpected(text.error());
        }
        if (const auto written = write_text_file(options.mesh, *text); !written) {
            return tl::unexpected(written.error());
        }
        outcome.verdict += fmt::format("; wrote {}", options.mesh.string());
    }
    return outcome;
}

}  // namespace

std::shared_ptr<Command> add_algebraic(CLI::App& app) {
    auto command = add_command(app, "algebraic", kHelp);
    auto options = std::make_shared<AlgebraicOptions>();
    command->app->add_option("PROBLEM", command->input, "The problem, a JSON file")
        ->required()
        ->option_text(" ");
    command->app
        ->add_option("-o,--output", options->output, "Write B-spline faces (STEP, IGES, ...)")
        ->option_text("OUT");
    command->app->add_option("--mesh", options->mesh, "Write a triangle mesh (OBJ)")
        ->option_text("FILE");
    command->app
        ->add_option("--divisions", options->divisions,
                     "Of the edges of the mesh's sectors (default 32)")
        ->option_text("N");
    command->app->add_option("--at", options->at, "Evaluate at this point")
        ->delimiter(',')
        ->option_text("X,Y,Z");
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, *options); };
    command->run = [options, self](Run& run) { return run_algebraic(run, *self, *options); };
    return command;
}

}  // namespace suture::cli
