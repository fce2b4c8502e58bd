#pragma once

#include "suture/base/result.h"
#include "suture/model/continuity.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture::cli {

/// argv with the values of --hole and --edges, which may be several words, joined by commas: the
/// first word that is no list of numbers ends them, so that a file name may follow.
[[nodiscard]] std::vector<std::string> join_number_lists(const std::vector<std::string>& words);

/// "1,3+4" -> {{1}, {3, 4}}
///
/// Refuses  (Usage) anything but positive numbers.
[[nodiscard]] Result<std::vector<std::vector<int>>> parse_holes(std::string_view text);

/// "12,15-17" -> {12, 15, 16, 17}
[[nodiscard]] Result<std::vector<int>> parse_edges(std::string_view text);

/// The same of faces: "12,15-17", "Face12"
[[nodiscard]] Result<std::vector<int>> parse_faces(std::string_view text);

/// "3=7,4=7", "Edge3=Face7" -> {3: 7, 4: 7}
[[nodiscard]] Result<std::map<int, int>> parse_supports(std::string_view text);

/// "12,15-17", "12=7" -> {{12, 7}}: edges, and the face of each or 0
[[nodiscard]] Result<std::vector<std::pair<int, int>>> parse_edges_on_faces(std::string_view text);

/// "3,7", "Vertex3,Vertex7" -> {3, 7}
[[nodiscard]] Result<std::pair<int, int>> parse_vertices(std::string_view text);

/// "G1", "g1" -> G1; "auto" -> none
[[nodiscard]] Result<std::optional<Continuity>> parse_continuity(std::string_view text);

/// "12=G2,13=G0"
[[nodiscard]] Result<std::map<int, Continuity>> parse_edge_continuity(std::string_view text);

/// Refuses (Usage) what is not a positive finite number, naming the option.
[[nodiscard]] Result<void> expect_positive(std::string_view option, double value);

/// The known name that is nearest to a misspelt one, if one is near.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view name,
                                                      const std::vector<std::string_view>& known);

/// Whether an output may be the input.
enum class Force {
    Given,      ///< it may
    NotGiven,   ///< not without --force
    NotOffered  ///< never: the command has no --force for this output
};

[[nodiscard]] constexpr Force force_of(bool given) {
    return given ? Force::Given : Force::NotGiven;
}

/// Refuses (Usage) an output that makes no sense before any work is done: a folder, a file in a
/// folder that does not exist or takes no new files, or, unless `force` is given, the input itself.
[[nodiscard]] Result<void> expect_writable(std::string_view option,
                                           const std::filesystem::path& output,
                                           const std::filesystem::path& input, Force force);

}  // namespace suture::cli
