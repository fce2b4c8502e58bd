#include "files/format.h"

#include "files/file_bytes.h"
#include "files/foreign.h"
#include "files/packed.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace suture::io {

namespace {

/// How many bytes of either end are looked at: room for a licence text in front of a STEP header.
constexpr std::size_t kEnds = 4096;

constexpr std::array<std::pair<std::string_view, Format>, 14> kExtensions{{
    {".step", Format::Step},
    {".stp", Format::Step},
    {".p21", Format::Step},
    {".iges", Format::Iges},
    {".igs", Format::Iges},
    {".brep", Format::BrepText},
    {".brp", Format::BrepText},
    {".bbrep", Format::BrepBinary},
    {".bin", Format::BrepFreecad},  // as FreeCAD calls it within its own files
    {".stl", Format::Stl},
    {".off", Format::Off},
    {".obj", Format::Obj},
    {".3mf", Format::ThreeMf},
    {".glb", Format::Gltf},
}};

std::string_view skip_blanks_and_comments(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    while (!text.empty()) {
        if (std::isspace(static_cast<unsigned char>(text.front()))) {
            text.remove_prefix(1);
        } else if (text.starts_with("/*")) {
            text.remove_prefix(std::min(text.size(), text.find("*/", 2) + 2));
        } else {
            break;
        }
    }
    return text;
}

/// Lines of 80 columns; column 73 names the section, S for start, then comes the line's number.
bool is_iges(std::string_view text) {
    constexpr std::size_t kSection = 72;
    return text.size() > kSection + 8 && text.substr(0, kSection).find('\n') == text.npos &&
           (text[kSection] == 'S' || text[kSection] == 'C' || text[kSection] == 'B') &&
           text.substr(kSection + 1, 7).find_first_not_of(" 0123456789") == text.npos;
}

/// The last list of sub-shapes ends in '*'. After it FreeCAD writes three integers of four bytes,
/// OCCT one byte and two integers. The reader looks again, when it knows where the list ends.
bool has_freecad_ending(std::string_view text) {
    constexpr std::size_t kFreecad = 13, kOcct = 10;
    return text.size() > kFreecad && text[text.size() - kFreecad] == '*' &&
           text[text.size() - kOcct] != '*';
}

}  // namespace

std::string_view to_string(Format format) {
    switch (format) {
        case Format::Step:
            return "STEP";
        case Format::Iges:
            return "IGES";
        case Format::BrepText:
            return "BREP";
        case Format::BrepBinary:
            return "binary BREP";
        case Format::BrepFreecad:
            return "FreeCAD BREP";
        case Format::FreecadDocument:
            return "FreeCAD";
        case Format::Stl:
            return "STL";
        case Format::Off:
            return "OFF";
        case Format::Obj:
            return "OBJ";
        case Format::ThreeMf:
            return "3MF";
        case Format::Gltf:
            return "glTF";
    }
    return "";
}

bool is_mesh(Format format) {
    return format == Format::Stl || format == Format::Off || format == Format::Obj ||
           format == Format::ThreeMf || format == Format::Gltf;
}

Result<Format> format_of_bytes(std::string_view bytes, const std::filesystem::path& file) {
    const std::string_view text = skip_blanks_and_comments(bytes);
    if (text.starts_with("ISO-10303-21")) {
        return Format::Step;
    }
    if (text.starts_with("Open CASCADE Topology V")) {
        return has_freecad_ending(bytes) ? Format::BrepFreecad : Format::BrepBinary;
    }
    if (text.starts_with("DBRep_DrawableShape") || text.starts_with("CASCADE Topology V")) {
        return Format::BrepText;
    }
    if (is_iges(bytes)) {
        return Format::Iges;
    }
    if (is_freecad_document(bytes)) {
        return Format::FreecadDocument;
    }
    const std::string foreign = describe_foreign(file, bytes);
    return fail(
        ErrorCode::Unreadable, "{} {}", file.string(),
        foreign.empty() ? "is of no known type: neither STEP, IGES, BREP nor FCStd" : foreign);
}

Result<Format> format_of_content(const std::filesystem::path& file) {
    Result<std::string> bytes = read_ends(file, kEnds);
    if (bytes && is_packed(*bytes)) {
        bytes = read_bytes(file).and_then(
            [&](std::string packed) { return unpack(std::move(packed), file); });
    }
    return bytes.and_then([&](const std::string& text) { return format_of_bytes(text, file); });
}

Result<Format> format_of_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::string known;
    for (const auto& [name, format] : kExtensions) {
        if (name == extension) {
            return format;
        }
        known += known.empty() ? "" : ", ";
        known += name;
    }
    return fail(ErrorCode::Usage, "{}: cannot tell the type to write from '{}'; known are {}",
                file.string(), extension, known);
}

}  // namespace suture::io
