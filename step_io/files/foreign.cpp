#include "files/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace suture::io {

namespace {

enum class Kind { Mesh, Cad, Script, Drawing, Picture, Document, Packed, WebPage, LfsPointer };

struct Magic {
    std::string_view begin;
    Kind kind;
    std::string_view name;
};

struct Extension {
    std::string_view extension;
    Kind kind;
    std::string_view name;
};

using std::string_view_literals::operator""sv;

constexpr std::array kMagics = std::to_array<Magic>({
    {"glTF", Kind::Mesh, "glTF"},
    {"ply\n", Kind::Mesh, "PLY"},
    {"ply\r", Kind::Mesh, "PLY"},
    {"OFF\n", Kind::Mesh, "OFF"},
    {"OFF\r", Kind::Mesh, "OFF"},
    {"OFF ", Kind::Mesh, "OFF"},
    {"#VRML", Kind::Mesh, "VRML"},
    {"BLENDER", Kind::Mesh, "Blender"},
    {"3D Geometry File Format", Kind::Cad, "Rhino"},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", Kind::Cad, "Parasolid"},
    {"PS\0\0"sv, Kind::Cad, "Parasolid"},
    {"ACIS BinaryFile", Kind::Cad, "ACIS"},
    {"ASM BinaryFile", Kind::Cad, "ACIS"},
    {"V5_CFV2", Kind::Cad, "CATIA"},
    {"\xD0\xCF\x11\xE0", Kind::Cad, "SolidWorks, Inventor or the like"},
    {"AC10", Kind::Drawing, "DWG"},
    {"AutoCAD Binary DXF", Kind::Drawing, "DXF"},
    {"\x89PNG", Kind::Picture, "PNG"},
    {"\xFF\xD8\xFF", Kind::Picture, "JPEG"},
    {"GIF8", Kind::Picture, "GIF"},
    {"RIFF", Kind::Picture, "WebP"},
    {"II*\0"sv, Kind::Picture, "TIFF"},
    {"MM\0*"sv, Kind::Picture, "TIFF"},
    {"%PDF", Kind::Document, "PDF"},
    {"7z\xBC\xAF", Kind::Packed, "7-Zip"},
    {"Rar!", Kind::Packed, "RAR"},
    {"BZh", Kind::Packed, "bzip2"},
    {"\xFD"
     "7zXZ",
     Kind::Packed, "xz"},
    {"\x28\xB5\x2F\xFD", Kind::Packed, "Zstandard"},
    {"version https://git-lfs", Kind::LfsPointer, ""},
});

/// Formats without a certain beginning.
constexpr std::array kForeignExtensions = std::to_array<Extension>({
    {".stl", Kind::Mesh, "STL"},          {".obj", Kind::Mesh, "OBJ"},
    {".off", Kind::Mesh, "OFF"},          {".ply", Kind::Mesh, "PLY"},
    {".3mf", Kind::Mesh, "3MF"},          {".amf", Kind::Mesh, "AMF"},
    {".gltf", Kind::Mesh, "glTF"},        {".dae", Kind::Mesh, "COLLADA"},
    {".fbx", Kind::Mesh, "FBX"},          {".wrl", Kind::Mesh, "VRML"},
    {".x_t", Kind::Cad, "Parasolid"},     {".x_b", Kind::Cad, "Parasolid"},
    {".sat", Kind::Cad, "ACIS"},          {".sab", Kind::Cad, "ACIS"},
    {".sldprt", Kind::Cad, "SolidWorks"}, {".sldasm", Kind::Cad, "SolidWorks"},
    {".ipt", Kind::Cad, "Inventor"},      {".iam", Kind::Cad, "Inventor"},
    {".prt", Kind::Cad, "NX or Creo"},    {".asm", Kind::Cad, "Creo or Solid Edge"},
    {".catpart", Kind::Cad, "CATIA"},     {".catproduct", Kind::Cad, "CATIA"},
    {".f3d", Kind::Cad, "Fusion"},        {".jt", Kind::Cad, "JT"},
    {".skp", Kind::Cad, "SketchUp"},      {".3dm", Kind::Cad, "Rhino"},
    {".scad", Kind::Script, ""},          {".csg", Kind::Script, ""},
    {".dxf", Kind::Drawing, "DXF"},       {".dwg", Kind::Drawing, "DWG"},
    {".svg", Kind::Drawing, "SVG"},       {".bmp", Kind::Picture, "BMP"},
});

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Binary: 80 free bytes, the number of triangles, 50 bytes for each.
bool is_stl(const std::filesystem::path& file, std::string_view ends) {
    constexpr std::size_t kHead = 84;
    constexpr std::uintmax_t kTriangle = 50;
    if (ends.starts_with("solid") && ends.find("facet") != ends.npos) {
        return true;
    }
    std::uint32_t count = 0;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || ends.size() < kHead) {
        return false;
    }
    static_assert(std::endian::native == std::endian::little, "STL is little-endian, as read here");
    std::memcpy(&count, ends.data() + kHead - sizeof count, sizeof count);
    return size == kHead + kTriangle * count;
}

bool is_web_page(std::string_view ends) {
    constexpr std::size_t kLook = 512;
    const std::string begin = lower(ends.substr(0, kLook));
    return begin.find("<!doctype html") != begin.npos || begin.find("<html") != begin.npos;
}

std::string sentence(Kind kind, std::string_view name) {
    switch (kind) {
        case Kind::Mesh:
            return fmt::format(
                "is a mesh ({}): facets have no smooth surfaces to join; give the STEP file that "
                "it was made from, or make a solid of it in FreeCAD (Part > Create shape from "
                "mesh) and export that as STEP",
                name);
        case Kind::Cad:
            return fmt::format(
                "is a file of {}, which Suture does not read: export it there as STEP", name);
        case Kind::Script:
            return "is an OpenSCAD script: FreeCAD's OpenSCAD workbench makes STEP of it "
                   "(docs/openscad.md)";
        case Kind::Drawing:
            return fmt::format("is a drawing ({}): Suture needs a 3D model, as STEP, IGES or BREP",
                               name);
        case Kind::Picture:
            return fmt::format("is a picture ({}): Suture needs a 3D model, as STEP, IGES or BREP",
                               name);
        case Kind::Document:
            return fmt::format("is a document ({}): Suture needs a 3D model, as STEP, IGES or BREP",
                               name);
        case Kind::Packed:
            return fmt::format("is packed ({}): unpack it first; Suture reads .gz, .stpz and .zip",
                               name);
        case Kind::WebPage:
            return "is a web page, perhaps one with a link to the model: download the model itself";
        case Kind::LfsPointer:
            return "is a pointer of Git LFS, not the model: run `git lfs pull` where it lies";
    }
    return {};
}

}  // namespace

std::string describe_foreign(const std::filesystem::path& file, std::string_view ends) {
    for (const Magic& magic : kMagics) {
        if (ends.starts_with(magic.begin)) {
            return sentence(magic.kind, magic.name);
        }
    }
    if (is_web_page(ends)) {
        return sentence(Kind::WebPage, "");
    }
    if (is_stl(file, ends)) {
        return sentence(Kind::Mesh, "STL");
    }
    const std::string extension = lower(file.extension().string());
    for (const Extension& known : kForeignExtensions) {
        if (extension == known.extension) {
            return sentence(known.kind, known.name);
        }
    }
    return {};
}

}  // namespace suture::io
