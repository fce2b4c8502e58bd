#include "cli/standard_input.h"

#include "suture/platform/descriptor.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace suture::cli {
namespace {

Error unreadable(int error) {
    return {ErrorCode::Unreadable,
            "standard input cannot be read: " + std::generic_category().message(error)};
}

/// The errno that ended it, or 0.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = write(file, bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(n < 0 ? 0 : n));
    }
    return 0;
}

/// All that comes from standard input.
Result<void> copy_to(int file) {
    constexpr std::size_t kMost = std::size_t{4} << 30U;
    std::string block(std::size_t{1} << 20U, '\0');
    std::size_t size = 0;
    while (true) {
        const ssize_t n = read(STDIN_FILENO, block.data(), block.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            return tl::unexpected(unreadable(errno));
        }
        if (n == 0) {
            return {};
        }
        size += static_cast<std::size_t>(n);
        if (size > kMost) {
            return fail(ErrorCode::Unreadable, "standard input has more than {} bytes", kMost);
        }
        const int error =
            write_all(file, std::string_view(block).substr(0, static_cast<std::size_t>(n)));
        if (error != 0) {
            return tl::unexpected(unreadable(error));
        }
    }
}

}  // namespace

Result<void> keep_standard_input() {
    if (isatty(STDIN_FILENO) != 0) {
        return fail(ErrorCode::Usage,
                    "IN is -, standard input, and that is the terminal: pipe a model into it");
    }
    struct stat status {};
    if (fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode)) {
        return {};
    }
    const int file = make_memory_file("suture-stdin");
    if (file < 0) {
        return tl::unexpected(unreadable(errno));
    }
    Result<void> done = copy_to(file);
    if (done && dup2(file, STDIN_FILENO) < 0) {
        done = tl::unexpected(unreadable(errno));
    }
    close(file);
    return done;
}

}  // namespace suture::cli
