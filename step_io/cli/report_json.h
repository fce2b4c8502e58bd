#pragma once

#include "cli/command.h"
#include "cli/load.h"
#include "suture/check/continuity.h"
#include "suture/check/face_knots.h"
#include "suture/check/validity.h"
#include "suture/fill_holes.h"
#include "suture/ribbon/extract.h"

#include <string_view>
#include <vector>

namespace suture::cli {

/// The version of the JSON documents: it grows when a key changes its meaning or goes away, not
/// when one is added. docs/json.md describes every key.
inline constexpr int kSchema = 3;

/// What every document begins with.
[[nodiscard]] Json document_head(const Command& command);

/// A whole document as text.
[[nodiscard]] std::string to_text(const Json& document);

/// The whole document of a command that is done, or was ended by an error.
[[nodiscard]] Json whole_document(const Command& command, const Outcome& outcome);
[[nodiscard]] Json error_document(const Command& command, const Error& error, int exit_code);

[[nodiscard]] Json json_of(const Eigen::Vector3d& point);
[[nodiscard]] Json json_of(const io::ModelFile& file);
[[nodiscard]] Json json_of(const SewingFacts& sewing);
[[nodiscard]] Json json_of(const Validity& validity);

/// One entry of `findings`; the figures in the finding's unit.
[[nodiscard]] Json json_of(const Finding& finding);

/// One entry of `holes` of inspect. The loop's corners in the model's coordinates.
[[nodiscard]] Json json_of(const BoundaryLoop& loop, const io::Part& part,
                           const std::vector<Corner>& corners);

/// `polynomials` of an entry of `holes` of fill.
[[nodiscard]] Json json_of(const ImplicitForm& form);

/// One entry of `holes` of fill. sides: how many edges bound it.
[[nodiscard]] Json json_of(const HoleReport& hole, int sides);

/// One entry of `edges` of check, one of `face_knots`, and its profile.
[[nodiscard]] Json json_of(const EdgeContinuity& edge);
[[nodiscard]] Json json_of(const KnotLine& line);

}  // namespace suture::cli
