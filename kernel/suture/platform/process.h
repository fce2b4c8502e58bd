#pragma once

#include <cstdint>

namespace suture {

/// This program's own file: it can be run, and is a link to where the file stands.
extern const char* const kOwnProgram;

/// Has this process end by `signal` as soon as the one that started it has ended; from now on: what
/// has ended before is for the caller to see.
void end_with_parent(int signal);

/// Bytes that this process may have at most: of the machine, or of the container that it runs in.
[[nodiscard]] std::uint64_t memory_of_machine();

}  // namespace suture
