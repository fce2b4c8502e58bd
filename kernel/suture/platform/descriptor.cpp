#include "suture/platform/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

namespace suture {

namespace {

constexpr const char* kDescriptors = "/proc/self/fd";

}  // namespace

int make_memory_file(const char* name) {
    return memfd_create(name, MFD_CLOEXEC);
}

int make_nameless_file(const std::filesystem::path& folder) {
    if (access(kDescriptors, X_OK) != 0) {
        return -1;
    }
    return open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

int give_name(int descriptor, const std::filesystem::path& name) {
    return linkat(AT_FDCWD, path_of(descriptor).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
}

std::filesystem::path path_of(int descriptor) {
    return fmt::format("{}/{}", kDescriptors, descriptor);
}

}  // namespace suture
