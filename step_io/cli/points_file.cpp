#include "cli/points_file.h"

#include "files/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace suture::cli {
namespace {

/// Of three numbers, or of six: the last three are the direction of the normal.
std::optional<ThroughPoint> point_of(std::string line) {
    for (char& c : line) {
        if (c == ',' || c == ';' || c == '\t' || c == '\r') {
            c = ' ';
        }
    }
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::vector<double> numbers;
    for (double number = 0.0; words >> number;) {
        numbers.push_back(number);
    }
    const bool whole = words.eof() && (numbers.size() == 3 || numbers.size() == 6);
    if (!whole || !std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) {
        return std::nullopt;
    }
    ThroughPoint result{Eigen::Vector3d(numbers.data())};
    if (numbers.size() == 6) {
        const Eigen::Vector3d direction(numbers.data() + 3);
        if (!(direction.norm() > 0.0)) {
            return std::nullopt;
        }
        result.normal = direction.stableNormalized();
    }
    return result;
}

}  // namespace

Result<std::vector<ThroughPoint>> read_points(const std::filesystem::path& file) {
    constexpr std::size_t kMostBytes = 64 << 20;
    constexpr std::size_t kLongestLine = 1000;
    const Result<std::string> bytes = io::read_bytes(file, kMostBytes);
    if (!bytes) {
        return fail(ErrorCode::Usage, "--through: {}", bytes.error().message);
    }
    std::istringstream stream(*bytes);
    std::vector<ThroughPoint> points;
    std::string line;
    bool titles = false;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (line.size() > kLongestLine) {
            return fail(ErrorCode::Usage,
                        "--through: line {} of {} has {} characters, more than {}", number,
                        file.string(), line.size(), kLongestLine);
        }
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == line.npos || line[first] == '#') {
            continue;
        }
        if (const auto point = point_of(line)) {
            points.push_back(*point);
        } else if (points.empty() && !titles) {
            titles = true;
        } else {
            return fail(ErrorCode::Usage,
                        "--through: line {} of {} is no point x, y, z, nor one with a normal x, y, "
                        "z, nx, ny, nz: {}",
                        number, file.string(), line);
        }
    }
    if (points.empty()) {
        return fail(ErrorCode::Usage, "--through: {} holds no point x, y, z", file.string());
    }
    return points;
}

}  // namespace suture::cli
