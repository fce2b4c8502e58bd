#include "cli/arguments.h"

#include "suture/base/text.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numeric>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListOptions[] = {"--hole",          "--holes",         "--edge",
                                             "--edges",         "--through-edges", "--boundary",
                                             "--replace-faces", "--remove-faces",  "--split"};

/// A range like 1-1000000000 is a slip of the pen, not a list of edges.
constexpr int kLongestRange = 1'000'000;

/// How FreeCAD calls edge 12, face 12 and vertex 12.
constexpr std::string_view kFreecadEdge = "Edge";
constexpr std::string_view kFreecadFace = "Face";
constexpr std::string_view kFreecadVertex = "Vertex";

bool is_number_list(std::string_view word) {
    for (const std::string_view prefix : {kFreecadEdge, kFreecadFace, kFreecadVertex}) {
        if (word.starts_with(prefix)) {
            word.remove_prefix(prefix.size());
        }
    }
    return !word.empty() && word.find_first_not_of("0123456789,+-") == std::string_view::npos &&
           word[0] >= '0' && word[0] <= '9';
}

Result<int> parse_number(std::string_view text, std::string_view noun) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1) {
        return fail(ErrorCode::Usage,
                    "'{}' is no number of {}: they are 1, 2, 3, ... as `suture inspect` lists them",
                    text, noun);
    }
    return number;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

std::vector<std::string> join_number_lists(const std::vector<std::string>& words) {
    std::vector<std::string> joined;
    for (std::size_t i = 0; i < words.size(); ++i) {
        joined.push_back(words[i]);
        if (std::find(std::begin(kListOptions), std::end(kListOptions), words[i]) ==
            std::end(kListOptions)) {
            continue;
        }
        std::string list;
        while (i + 1 < words.size() && is_number_list(words[i + 1])) {
            list += (list.empty() ? "" : ",") + words[++i];
        }
        if (!list.empty()) {
            joined.push_back(list);
        }
    }
    return joined;
}

namespace {

/// 12 or Edge12.
Result<int> parse_named(std::string_view text, std::string_view prefix, std::string_view noun) {
    return parse_number(text.starts_with(prefix) ? text.substr(prefix.size()) : text, noun);
}

Result<int> parse_edge(std::string_view text) {
    return parse_named(text, kFreecadEdge, "an edge");
}

/// "12,15-17" -> {12, 15, 16, 17}
Result<std::vector<int>> parse_ranges(std::string_view text, std::string_view prefix,
                                      std::string_view noun, std::string_view plural) {
    std::vector<int> numbers;
    for (const std::string_view entry : split(text, ',')) {
        const std::size_t dash = entry.find('-');
        const Result<int> first = parse_named(entry.substr(0, dash), prefix, noun);
        if (!first) {
            return tl::unexpected(first.error());
        }
        const Result<int> last = dash == std::string_view::npos
                                     ? first
                                     : parse_named(entry.substr(dash + 1), prefix, noun);
        if (!last) {
            return tl::unexpected(last.error());
        }
        if (*last < *first || *last - *first > kLongestRange) {
            return fail(ErrorCode::Usage, "'{}' is no range of {}: write it as 15-17", entry,
                        plural);
        }
        for (int number = *first; number <= *last; ++number) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

}  // namespace

Result<std::vector<std::vector<int>>> parse_holes(std::string_view text) {
    std::vector<std::vector<int>> holes;
    for (const std::string_view entry : split(text, ',')) {
        std::vector<int>& loops = holes.emplace_back();
        for (const std::string_view number : split(entry, '+')) {
            const Result<int> id = parse_number(number, "a hole");
            if (!id) {
                return tl::unexpected(id.error());
            }
            if (std::ranges::find(loops, *id) != loops.end()) {
                return fail(ErrorCode::Usage, "'{}' names loop {} twice", entry, *id);
            }
            loops.push_back(*id);
        }
    }
    return holes;
}

Result<std::vector<int>> parse_edges(std::string_view text) {
    return parse_ranges(text, kFreecadEdge, "an edge", "edges");
}

Result<std::vector<int>> parse_faces(std::string_view text) {
    return parse_ranges(text, kFreecadFace, "a face", "faces");
}

Result<std::pair<int, int>> parse_vertices(std::string_view text) {
    const auto vertices = parse_ranges(text, kFreecadVertex, "a vertex", "vertices");
    if (!vertices) {
        return tl::unexpected(vertices.error());
    }
    if (vertices->size() != 2 || vertices->front() == vertices->back()) {
        return fail(ErrorCode::Usage, "'{}' is no pair of vertices: write it as 3,7", text);
    }
    return std::pair(vertices->front(), vertices->back());
}

Result<std::optional<Continuity>> parse_continuity(std::string_view text) {
    if (text == "auto") {
        return std::nullopt;
    }
    if (text.size() == 2 && (text[0] == 'G' || text[0] == 'g') && text[1] >= '0' &&
        text[1] <= '2') {
        return static_cast<Continuity>(text[1] - '0');
    }
    return fail(ErrorCode::Usage, "'{}' is no continuity: it is G0, G1, G2 or auto", text);
}

Result<std::map<int, Continuity>> parse_edge_continuity(std::string_view text) {
    std::map<int, Continuity> result;
    for (const std::string_view entry : split(text, ',')) {
        const std::size_t equals = entry.find('=');
        if (equals == std::string_view::npos) {
            return fail(ErrorCode::Usage, "'{}' names no continuity: write it as 12=G2", entry);
        }
        const Result<int> edge = parse_edge(entry.substr(0, equals));
        if (!edge) {
            return tl::unexpected(edge.error());
        }
        const auto continuity = parse_continuity(entry.substr(equals + 1));
        if (!continuity) {
            return tl::unexpected(continuity.error());
        }
        if (*continuity) {
            result[*edge] = **continuity;
        }
    }
    return result;
}

namespace {

/// "3=7" -> (3, 7)
Result<std::pair<int, int>> parse_edge_on_face(std::string_view entry) {
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) {
        return fail(ErrorCode::Usage, "'{}' names no support: write it as 3=7, edge and face",
                    entry);
    }
    const Result<int> edge = parse_edge(entry.substr(0, equals));
    const Result<int> face = parse_named(entry.substr(equals + 1), kFreecadFace, "a face");
    for (const Result<int>& number : {edge, face}) {
        if (!number) {
            return tl::unexpected(number.error());
        }
    }
    return std::pair(*edge, *face);
}

}  // namespace

Result<std::map<int, int>> parse_supports(std::string_view text) {
    std::map<int, int> result;
    for (const std::string_view entry : split(text, ',')) {
        const auto pair = parse_edge_on_face(entry);
        if (!pair) {
            return tl::unexpected(pair.error());
        }
        if (!result.insert(*pair).second) {
            return fail(ErrorCode::Usage, "edge {} is given two supports", pair->first);
        }
    }
    return result;
}

Result<std::vector<std::pair<int, int>>> parse_edges_on_faces(std::string_view text) {
    std::vector<std::pair<int, int>> result;
    for (const std::string_view entry : split(text, ',')) {
        if (entry.find('=') != std::string_view::npos) {
            const auto pair = parse_edge_on_face(entry);
            if (!pair) {
                return tl::unexpected(pair.error());
            }
            result.push_back(*pair);
            continue;
        }
        const auto edges = parse_edges(entry);
        if (!edges) {
            return tl::unexpected(edges.error());
        }
        for (const int edge : *edges) {
            result.emplace_back(edge, 0);
        }
    }
    return result;
}

Result<void> expect_positive(std::string_view option, double value) {
    if (std::isfinite(value) && value > 0.0) {
        return {};
    }
    return fail(ErrorCode::Usage, "{} must be a positive number, not {}", option, value);
}

std::optional<std::string_view> nearest(std::string_view name,
                                        const std::vector<std::string_view>& known) {
    const auto distance = [&](std::string_view other) { return edit_distance(name, other); };
    const auto best = std::min_element(known.begin(), known.end(),
                                       [&](auto a, auto b) { return distance(a) < distance(b); });
    // Half of the letters right: below that it is another word, not a slip.
    if (best == known.end() || 2 * distance(*best) > std::max(name.size(), best->size())) {
        return std::nullopt;
    }
    return *best;
}

Result<void> expect_writable(std::string_view option, const fs::path& output, const fs::path& input,
                             Force force) {
    std::error_code error;
    if (fs::is_directory(output, error)) {
        return fail(ErrorCode::Usage, "{} {} is a folder: name a file in it", option,
                    output.string());
    }
    const fs::file_status status = fs::status(output, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return fail(ErrorCode::Usage, "{} {} is no ordinary file: name another one", option,
                    output.string());
    }
    if (fs::exists(status) && access(output.c_str(), W_OK) != 0) {
        return fail(ErrorCode::Usage, "{} {} is there and must not be written ({})", option,
                    output.string(), std::strerror(errno));
    }
    const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error)) {
        return fail(ErrorCode::Usage, "{} {}: there is no folder {}: make it first", option,
                    output.string(), folder.string());
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        return fail(ErrorCode::Usage, "{} {}: the folder {} takes no new files ({})", option,
                    output.string(), folder.string(), std::strerror(errno));
    }
    if (force != Force::Given && fs::equivalent(output, input, error)) {
        return fail(ErrorCode::Usage, "{} {} is the input itself: name another file{}", option,
                    output.string(),
                    force == Force::NotGiven ? ", or add --force to replace it" : "");
    }
    return {};
}

}  // namespace suture::cli
