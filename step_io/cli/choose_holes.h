#pragma once

#include "cli/load.h"
#include "suture/fill_holes.h"

#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

/// What is to be done with one part of a model.
struct PartRequest {
    std::size_t part = 0;  ///< index of its PartLoops
    FillRequest request;   ///< with ids as they count in the part
};

/// Which of a model's holes are meant, where none is named.
struct HoleFilter {
    bool planar = false;
    std::optional<double> larger, smaller;  ///< diameters, mm
    std::optional<int> sides;               ///< islands' sides count as well

    [[nodiscard]] bool empty() const { return !planar && !larger && !smaller && !sides; }
};

/// The holes that pass the filter, as FillRequest::holes has them.
///
/// Refuses  (NothingToDo) if there is none.
[[nodiscard]] Result<std::vector<std::vector<int>>> holes_like(const HoleFilter& filter,
                                                               const FillRequest& request,
                                                               const std::vector<PartLoops>& parts);

/// Divides a request for a whole model into requests for its parts.
///
/// Result   only parts with something to fill.
/// Refuses  (Usage) holes and edges that do not exist, islands from different parts;
///          (NothingToDo) a model without a hole, with a hint at what it has instead.
[[nodiscard]] Result<std::vector<PartRequest>> divide_request(const FillRequest& request,
                                                              const std::vector<PartLoops>& parts,
                                                              int edges_in_model);

/// "; it has 2 rims of open sheets (--all-loops fills them)": the loops that are no holes, and how
/// to fill them; empty if there is none.
[[nodiscard]] std::string what_else(const std::vector<PartLoops>& parts);

}  // namespace suture::cli
