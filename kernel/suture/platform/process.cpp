#include "suture/platform/process.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace suture {

const char* const kOwnProgram = "/proc/self/exe";

void end_with_parent(int signal) {
    prctl(PR_SET_PDEATHSIG, signal);
}

std::uint64_t memory_of_machine() {
    std::uint64_t most = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    for (const char* file :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::uint64_t allowed = 0;
        if (std::ifstream(file) >> allowed && allowed > 0) {
            most = std::min(most, allowed);
        }
    }
    return most;
}

}  // namespace suture
