#include "files/mesh.h"
#include "files/write_time.h"
#include "files/zip_module.h"
#include "suture/base/on_demand.h"
#include "suture/base/text.h"

#include <fmt/ostream.h>

#include <bit>
#include <iterator>

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

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr std::string_view kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

std::string model_xml(const Mesh& mesh, const std::string& name) {
    std::string xml = fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><object id="1" type="model" name="{}"><mesh><vertices>
)",
        escape_markup(name));
    auto out = std::back_inserter(xml);
    for (const auto& [x, y, z] : mesh.points) {
        fmt::format_to(out, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", x, y, z);
    }
    xml += "</vertices><triangles>\n";
    for (const auto& [a, b, c] : mesh.triangles) {
        fmt::format_to(out, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
    }
    xml +=
        "</triangles></mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n"
        "</model>\n";
    return xml;
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

Result<void> write_obj(const Mesh& mesh, const std::string& name, std::ostream& stream) {
    fmt::print(stream, "# Suture {}, millimetres\no {}\n", SUTURE_VERSION, name);
    for (const auto& [x, y, z] : mesh.points) {
        fmt::print(stream, "v {} {} {}\n", x, y, z);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        fmt::print(stream, "f {} {} {}\n", a + 1, b + 1, c + 1);
    }
    return {};
}

Result<void> write_3mf(const Mesh& mesh, const std::string& name, std::ostream& stream) {
    const Result<std::tm> time = time_of_writing();
    if (!time) {
        return tl::unexpected(time.error());
    }
    const std::string model = model_xml(mesh, name);
    MakeZip* const make_zip =
        *static_cast<MakeZip* const*>(symbol_on_demand("suture_zip.so", "suture_make_zip"));
    const ZipArchive archive = make_zip({{"[Content_Types].xml", kContentTypes},
                                         {"_rels/.rels", kRelations},
                                         {"3D/3dmodel.model", model}},
                                        *time);
    if (!archive.error.empty()) {
        return fail(ErrorCode::Internal, "the zip archive cannot be made: {}", archive.error);
    }
    stream << archive.bytes;
    return {};
}

}  // namespace suture::io
