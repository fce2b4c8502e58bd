#include "files/mesh.h"

#include <fmt/ostream.h>

#include <bit>
#include <cmath>

namespace suture::io {

namespace {

using Point = std::array<double, 3>;

static_assert(std::endian::native == std::endian::little, "STL is little-endian, as written here");

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::array<float, 3> to_float(const Point& point) {
    return {static_cast<float>(point[0]), static_cast<float>(point[1]),
            static_cast<float>(point[2])};
}

std::array<float, 3> unit_normal(const Point& a, const Point& b, const Point& c) {
    Point n{};
    for (std::size_t i = 0; i < n.size(); ++i) {
        const std::size_t j = (i + 1) % n.size();
        const std::size_t k = (i + 2) % n.size();
        n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    const double length = std::hypot(n[0], n[1], n[2]);
    return length > 0.0 ? to_float({n[0] / length, n[1] / length, n[2] / length})
                        : std::array<float, 3>{};
}

}  // namespace

Result<void> write_stl(const Mesh& mesh, std::ostream& stream) {
    std::string bytes = fmt::format("{:<80}", "Suture " SUTURE_VERSION ", millimetres");
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles) {
        append(bytes, unit_normal(mesh.points[a], mesh.points[b], mesh.points[c]));
        for (const std::uint32_t point : {a, b, c}) {
            append(bytes, to_float(mesh.points[point]));
        }
        append(bytes, std::uint16_t{0});
    }
    stream << bytes;
    return {};
}

Result<void> write_off(const Mesh& mesh, std::ostream& stream) {
    fmt::print(stream, "OFF\n{} {} 0\n", mesh.points.size(), mesh.triangles.size());
    for (const auto& [x, y, z] : mesh.points) {
        fmt::print(stream, "{} {} {}\n", x, y, z);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        fmt::print(stream, "3 {} {} {}\n", a, b, c);
    }
    return {};
}

}  // namespace suture::io
