#pragma once

#include <csignal>

namespace suture {

/// Signals, which the caller has blocked, as a file that can be polled for. -1: errno says why.
[[nodiscard]] int open_signal_file(const sigset_t& signals);

/// The next signal of such a file; 0 if it cannot be read.
[[nodiscard]] int take_signal(int file);

}  // namespace suture
