#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace suture {

/// What a job may reach in the file system, besides the system's libraries and the program's own.
struct SandboxPaths {
    std::vector<std::filesystem::path> read;   ///< files, and folders with all below them
    std::vector<std::filesystem::path> write;  ///< folders, for new files, and to read these again
    std::vector<std::filesystem::path> execute;  ///< programs
};

/// What this kernel has of it: "Landlock 3, seccomp", "seccomp", "none".
[[nodiscard]] std::string sandbox_support();

/// Shuts this process, and all that it starts, off from the rest of the system for ever: files
/// other than these cannot be opened (Landlock), sockets and what debuggers and administrators need
/// cannot be had (seccomp). Each part is left out by itself where the kernel has it not.
void enter_sandbox(const SandboxPaths& paths);

}  // namespace suture
