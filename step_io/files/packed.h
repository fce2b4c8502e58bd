#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace suture::io {

/// Whether a file begins as gzip or zip do: .step.gz, .stpz, .FCStd, .zip.
[[nodiscard]] bool is_packed(std::string_view bytes);

/// Whether unpacked bytes are still a zip archive: FreeCAD's document, which is read as it is.
[[nodiscard]] bool is_freecad_document(std::string_view bytes);

/// What a packed file holds: of gzip the content, of a zip archive its only STEP, IGES or BREP
/// file; FreeCAD's document stays an archive.
///
/// Refuses  (Unreadable) a damaged archive, one that holds no model or several, by name, and more
///          than 4 GB of content.
[[nodiscard]] Result<std::string> unpack(std::string bytes, const std::filesystem::path& file);

/// Bytes under a name that OCCT's readers can open, as long as this lives: they take no others.
class NamedBytes {
  public:
    explicit NamedBytes(std::string_view bytes);
    ~NamedBytes();
    NamedBytes(const NamedBytes&) = delete;
    NamedBytes& operator=(const NamedBytes&) = delete;

    /// Empty if the system has no room for them.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    int file_;
    std::filesystem::path path_;
};

/// One file of an archive.
///
/// Refuses  (Unreadable) what is not there or damaged.
[[nodiscard]] Result<std::string> unpack_entry(std::string_view archive, const std::string& entry,
                                               const std::filesystem::path& file);

}  // namespace suture::io
