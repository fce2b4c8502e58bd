#include "suture/platform/signal_file.h"

#include <sys/signalfd.h>
#include <unistd.h>

namespace suture {

int open_signal_file(const sigset_t& signals) {
    return signalfd(-1, &signals, SFD_CLOEXEC);
}

int take_signal(int file) {
    signalfd_siginfo info{};
    return read(file, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
}

}  // namespace suture
