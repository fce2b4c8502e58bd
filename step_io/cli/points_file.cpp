#include "cli/points_file.h"

#include "files/file_bytes.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace suture::cli {
namespace {

std::optional<Eigen::Vector3d> point_of(std::string line) {
    for (char& c : line) {
        if (c == ',' || c == ';' || c == '\t' || c == '\r') {
            c = ' ';
        }
    }
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    Eigen::Vector3d point;
    std::string rest;
    if (!(words >> point.x() >> point.y() >> point.z()) || words >> rest || !point.allFinite()) {
        return std::nullopt;
    }
    return point;
}

}  // namespace

Result<std::vector<Eigen::Vector3d>> read_points(const std::filesystem::path& file) {
    constexpr std::size_t kMostBytes = 64 << 20;
    constexpr std::size_t kLongestLine = 1000;
    const Result<std::string> bytes = io::read_bytes(file, kMostBytes);
    if (!bytes) {
        return fail(ErrorCode::Usage, "--through: {}", bytes.error().message);
    }
    std::istringstream stream(*bytes);
    std::vector<Eigen::Vector3d> points;
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
            return fail(ErrorCode::Usage, "--through: line {} of {} is no point x, y, z: {}",
                        number, file.string(), line);
        }
    }
    if (points.empty()) {
        return fail(ErrorCode::Usage, "--through: {} holds no point x, y, z", file.string());
    }
    return points;
}

}  // namespace suture::cli
