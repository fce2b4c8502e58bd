#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <functional>
#include <ostream>

namespace suture::io {

/// The file that a path leads to, links followed, also one to a file that is not there yet.
[[nodiscard]] std::filesystem::path followed(const std::filesystem::path& file);

/// Writes a file whole or not at all: into a temporary file beside it, flushed to the disk, then
/// renamed over it. A new file gets the permissions of any new file, an old one keeps its own; of a
/// symbolic link the file that it points to is replaced.
///
/// Input    content writes everything to the stream, or says why it cannot; verify looks at what is
///          written, at a path that is good for reading as long as it runs, before it takes the
///          place of the old file.
/// Refuses  what content and verify refuse; (WriteFailed) a missing folder, a folder or a device in
///          the file's place, no permission, a full disk; the old file is then intact and nothing
///          new is left behind.
[[nodiscard]] Result<void> write_atomically(
    const std::filesystem::path& file, const std::function<Result<void>(std::ostream&)>& content,
    const std::function<Result<void>(const std::filesystem::path& written)>& verify = {});

}  // namespace suture::io
