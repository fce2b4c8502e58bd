#pragma once

#include "cli/command.h"
#include "suture/fill/algebraic/exact_problem.h"

#include <filesystem>

namespace suture::cli {

/// Reads the problem file of `suture algebraic` (docs/methods/algebraic.md).
///
/// Refuses  (Unreadable) a file that is no JSON; (Usage) a key that is missing or means nothing.
[[nodiscard]] Result<algebraic::ExactProblem> read_problem(const std::filesystem::path& file);

/// The piecewise polynomials with exact and with rounded coefficients, and how they were found.
[[nodiscard]] Json json_of(const algebraic::ExactProblem& problem,
                           const algebraic::ExactSolution& solution);

/// A triangle mesh of all cells in the OBJ format, with the surface's own normals.
///
/// Input    divisions: of each sector's edges.
/// Refuses  a sheet that ends inside its sector.
[[nodiscard]] Result<std::string> obj_of(const algebraic::ExactSolution& solution, int divisions);

}  // namespace suture::cli
