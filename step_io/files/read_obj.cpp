#include "files/read_obj.h"

#include "files/file_bytes.h"

#include <charconv>
#include <sstream>
#include <string>
#include <vector>

namespace suture::io {
namespace {

/// "7", "7/1", "7//3" or "-1", as a 0-based index of the vertices so far, or -1.
int vertex_of(const std::string& word, int vertices) {
    int number = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || (stop != end && *stop != '/')) {
        return -1;
    }
    const int index = number > 0 ? number - 1 : vertices + number;
    return number != 0 && index >= 0 && index < vertices ? index : -1;
}

}  // namespace

Result<manifold::PolygonMesh> read_obj(const std::filesystem::path& file) {
    const auto bytes = read_bytes(file);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    std::istringstream stream(*bytes);
    std::vector<Eigen::Vector3d> vertices;
    manifold::PolygonMesh mesh;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Eigen::Vector3d point;
            if (!(words >> point.x() >> point.y() >> point.z()) || !point.allFinite()) {
                return fail(ErrorCode::Unreadable, "line {} of {} is no vertex: {}", number,
                            file.string(), line);
            }
            vertices.push_back(point);
        } else if (kind == "f") {
            std::vector<int>& face = mesh.faces.emplace_back();
            for (std::string word; words >> word;) {
                face.push_back(vertex_of(word, static_cast<int>(vertices.size())));
                if (face.back() < 0) {
                    return fail(ErrorCode::Unreadable, "line {} of {} has no vertex '{}'", number,
                                file.string(), word);
                }
            }
            if (face.size() < 3) {
                return fail(ErrorCode::Unreadable, "line {} of {} is no face: {}", number,
                            file.string(), line);
            }
        }
    }
    if (mesh.faces.empty()) {
        return fail(ErrorCode::Unreadable, "{} holds no face of a mesh (a Wavefront OBJ file)",
                    file.string());
    }
    mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        mesh.vertices.col(static_cast<Eigen::Index>(k)) = vertices[k];
    }
    return mesh;
}

}  // namespace suture::io
