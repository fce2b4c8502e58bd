#pragma once

#include <filesystem>

namespace suture {

// Files without a name. Descriptors are closed when another program is run; -1: errno says why.

/// An empty file in memory. The name is for those who list this process's files.
[[nodiscard]] int make_memory_file(const char* name);

/// An empty file in a folder, of which nothing is left when it is closed without a name. -1 too
/// where the file system has no such files, or they could not be named later on.
[[nodiscard]] int make_nameless_file(const std::filesystem::path& folder);

/// Gives such a file a name, which must be new. Returns 0 or -1.
[[nodiscard]] int give_name(int descriptor, const std::filesystem::path& name);

/// A name under which this process can open the file of a descriptor once more.
[[nodiscard]] std::filesystem::path path_of(int descriptor);

}  // namespace suture
