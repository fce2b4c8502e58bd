#include "files/mesh_tree.h"
#include "files/write_time.h"
#include "files/zip_module.h"
#include "suture/base/text.h"
#include "suture/platform/on_demand.h"

#include <fmt/ostream.h>

#include <cmath>
#include <iterator>
#include <optional>

// Written by hand, for points with all digits that faces share: docs/openscad.md has what lib3mf
// and OCCT's RWObj make of them.

namespace suture::io {

namespace {

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

/// Objects of 3MF are numbered from 1; the colours are number 1 among the resources.
std::size_t id_of(std::size_t object) {
    return object + 2;
}

std::string hex_of(const std::array<double, 4>& colour) {
    const auto byte = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
    return fmt::format("#{:02X}{:02X}{:02X}{:02X}", byte(colour[0]), byte(colour[1]),
                       byte(colour[2]), byte(colour[3]));
}

/// By rows of the transposed matrix, as 3MF multiplies from the left.
std::string matrix_of(const gp_Trsf& place) {
    std::string text;
    for (int column = 1; column <= 4; ++column) {
        for (int row = 1; row <= 3; ++row) {
            text += fmt::format("{}{}", text.empty() ? "" : " ", place.Value(row, column));
        }
    }
    return text;
}

void add_mesh(const MeshObject& object, std::string& xml) {
    auto out = std::back_inserter(xml);
    xml += "<mesh><vertices>\n";
    for (const auto& [x, y, z] : object.mesh.points) {
        fmt::format_to(out, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", x, y, z);
    }
    xml += "</vertices><triangles>\n";
    for (std::size_t i = 0; i < object.mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = object.mesh.triangles[i];
        fmt::format_to(out, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"", a, b, c);
        if (!object.colours.empty() && object.colours[i] >= 0) {
            fmt::format_to(out, " pid=\"1\" p1=\"{}\"", object.colours[i]);
        }
        xml += "/>\n";
    }
    xml += "</triangles></mesh>";
}

bool is_empty(const MeshObject& object) {
    return object.mesh.triangles.empty() && object.children.empty();
}

std::string model_xml(const MeshTree& tree) {
    std::string xml =
        R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources>
)";
    auto out = std::back_inserter(xml);
    if (!tree.colours.empty()) {
        xml += "<basematerials id=\"1\">";
        for (const auto& colour : tree.colours) {
            fmt::format_to(out, "<base name=\"{0}\" displaycolor=\"{0}\"/>", hex_of(colour));
        }
        xml += "</basematerials>\n";
    }
    for (std::size_t i = 0; i < tree.objects.size(); ++i) {
        const MeshObject& object = tree.objects[i];
        if (is_empty(object)) {
            continue;
        }
        fmt::format_to(out, "<object id=\"{}\" type=\"model\" name=\"{}\">", id_of(i),
                       escape_markup(object.name));
        if (object.children.empty()) {
            add_mesh(object, xml);
        } else {
            xml += "<components>";
            for (const MeshInstance& child : object.children) {
                if (!is_empty(tree.objects[child.object])) {
                    fmt::format_to(out, "<component objectid=\"{}\" transform=\"{}\"/>",
                                   id_of(child.object), matrix_of(child.place));
                }
            }
            xml += "</components>";
        }
        xml += "</object>\n";
    }
    xml += "</resources>\n<build>";
    for (const MeshInstance& root : tree.roots) {
        if (!is_empty(tree.objects[root.object])) {
            fmt::format_to(out, "<item objectid=\"{}\" transform=\"{}\"/>", id_of(root.object),
                           matrix_of(root.place));
        }
    }
    return xml + "</build>\n</model>\n";
}

class ObjWriter {
  public:
    ObjWriter(const MeshTree& tree, std::ostream& stream) : tree_(tree), stream_(stream) {}

    void write(const MeshInstance& instance, const gp_Trsf& outer) {
        const MeshObject& object = tree_.objects[instance.object];
        const gp_Trsf place = outer * instance.place;
        for (const MeshInstance& child : object.children) {
            write(child, place);
        }
        if (object.mesh.triangles.empty()) {
            return;
        }
        const std::string& name = object.name.empty() ? instance.name : object.name;
        fmt::print(stream_, "o {}\n", visible(name));
        for (const auto& [x, y, z] : object.mesh.points) {
            gp_XYZ point(x, y, z);
            place.Transforms(point);
            fmt::print(stream_, "v {} {} {}\n", point.X(), point.Y(), point.Z());
        }
        // A material holds until the next one, in other objects too.
        std::optional<int> material;
        for (std::size_t i = 0; i < object.mesh.triangles.size(); ++i) {
            const int colour = object.colours.empty() ? -1 : object.colours[i];
            if (!tree_.colours.empty() && colour != material) {
                material = colour;
                fmt::print(stream_, "usemtl {}\n", material_name(colour));
            }
            const auto& [a, b, c] = object.mesh.triangles[i];
            fmt::print(stream_, "f {} {} {}\n", a + first_, b + first_, c + first_);
        }
        first_ += object.mesh.points.size();
    }

    static std::string material_name(int colour) {
        return colour < 0 ? "none" : fmt::format("colour{}", colour);
    }

  private:
    const MeshTree& tree_;
    std::ostream& stream_;
    std::size_t first_ = 1;
};

}  // namespace

Result<void> write_3mf(const MeshTree& tree, std::ostream& stream) {
    const Result<std::tm> time = time_of_writing();
    if (!time) {
        return tl::unexpected(time.error());
    }
    const std::string model = model_xml(tree);
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

Result<void> write_obj(const MeshTree& tree, const std::string& material_file,
                       std::ostream& stream) {
    fmt::print(stream, "# Suture {}, millimetres\n", SUTURE_VERSION);
    if (!material_file.empty()) {
        fmt::print(stream, "mtllib {}\n", material_file);
    }
    ObjWriter writer(tree, stream);
    for (const MeshInstance& root : tree.roots) {
        writer.write(root, {});
    }
    return {};
}

Result<void> write_mtl(const MeshTree& tree, std::ostream& stream) {
    fmt::print(stream, "# Suture {}\n", SUTURE_VERSION);
    for (std::size_t i = 0; i < tree.colours.size(); ++i) {
        const auto& [red, green, blue, opacity] = tree.colours[i];
        fmt::print(stream, "newmtl {}\nKd {:.6g} {:.6g} {:.6g}\nd {:.6g}\n",
                   ObjWriter::material_name(static_cast<int>(i)), red, green, blue, opacity);
    }
    fmt::print(stream, "newmtl none\nKd 0.8 0.8 0.8\n");
    return {};
}

}  // namespace suture::io
