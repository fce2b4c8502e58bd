#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string_view>

namespace suture::io {

enum class Format {
    Step,
    Iges,
    BrepText,  ///< OCCT's own, as BRepTools and BinTools write it
    BrepBinary,
    BrepFreecad,      ///< FreeCAD's exportBinary: OCCT's binary shape set with its own ending
    FreecadDocument,  ///< .FCStd, for reading only
    Stl,
    Off,
    Obj,
    ThreeMf,
    Gltf,  ///< .glb; meshes, for writing only
};

/// What some editors put in front of UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

[[nodiscard]] std::string_view to_string(Format format);

/// Whether a format holds triangles only; files of such are not read again.
[[nodiscard]] bool is_mesh(Format format);

/// The type of a file by its content, that of a packed file by what it holds.
///
/// Refuses  (Unreadable) a missing file, a directory, an empty file, an unknown type: each with its
///          own sentence, which for a known foreign format says what to give instead.
[[nodiscard]] Result<Format> format_of_content(const std::filesystem::path& file);

/// The same of bytes that were read already, and unpacked; `file` is for the sentence.
[[nodiscard]] Result<Format> format_of_bytes(std::string_view bytes,
                                             const std::filesystem::path& file);

/// The type that an output file's extension asks for.
///
/// Refuses  (Usage) an unknown extension, listing those that are known.
[[nodiscard]] Result<Format> format_of_extension(const std::filesystem::path& file);

}  // namespace suture::io
