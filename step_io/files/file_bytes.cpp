#include "files/file_bytes.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace suture::io {

namespace fs = std::filesystem;

namespace {

struct OpenFile {
    std::ifstream stream;
    std::size_t size = 0;
};

Result<OpenFile> open_file(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) {
        return fail(ErrorCode::Unreadable, "{} does not exist", file.string());
    }
    if (fs::is_directory(status)) {
        return fail(ErrorCode::Unreadable, "{} is a folder, not a file", file.string());
    }
    if (!fs::is_regular_file(status)) {
        return fail(ErrorCode::Unreadable, "{} is no ordinary file", file.string());
    }
    errno = 0;
    OpenFile opened{std::ifstream(file, std::ios::binary), fs::file_size(file, error)};
    if (!opened.stream || error) {
        return fail(ErrorCode::Unreadable, "{} cannot be opened: {}", file.string(),
                    error ? error.message() : std::generic_category().message(errno));
    }
    if (opened.size == 0) {
        return fail(ErrorCode::Unreadable, "{} is empty", file.string());
    }
    return opened;
}

Result<std::string> read_some(OpenFile& file, const fs::path& path, std::size_t head,
                              std::size_t tail) {
    std::string bytes(head + tail, '\0');
    file.stream.read(bytes.data(), static_cast<std::streamsize>(head));
    if (tail > 0) {
        file.stream.seekg(-static_cast<std::streamoff>(tail), std::ios::end);
        file.stream.read(bytes.data() + head, static_cast<std::streamsize>(tail));
    }
    if (!file.stream) {
        return fail(ErrorCode::Unreadable, "{} cannot be read: {}", path.string(),
                    std::generic_category().message(errno));
    }
    return bytes;
}

Result<std::string> read_standard_input(std::size_t most) {
    constexpr std::size_t kStep = std::size_t{1} << 20U;
    lseek(STDIN_FILENO, 0, SEEK_SET);  // fails of a pipe, which stands at its beginning
    std::string bytes;
    while (bytes.size() <= most) {
        const std::size_t filled = bytes.size();
        bytes.resize(filled + kStep);
        const ssize_t n = read(STDIN_FILENO, bytes.data() + filled, kStep);
        bytes.resize(filled + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
        if (n < 0 && errno != EINTR) {
            return fail(ErrorCode::Unreadable, "standard input cannot be read: {}",
                        std::generic_category().message(errno));
        }
        if (n == 0) {
            return bytes.empty() ? fail(ErrorCode::Unreadable, "standard input is empty")
                                 : Result<std::string>(std::move(bytes));
        }
    }
    return fail(ErrorCode::Unreadable, "standard input has more than the {} bytes allowed", most);
}

}  // namespace

fs::path shown_name(const fs::path& file) {
    return file == kStandardInput ? fs::path("standard input") : file;
}

Result<std::string> read_bytes(const fs::path& file, std::size_t most) {
    if (file == kStandardInput) {
        return read_standard_input(most);
    }
    return open_file(file).and_then([&](OpenFile opened) -> Result<std::string> {
        if (opened.size > most) {
            return fail(ErrorCode::Unreadable, "{} has {} bytes, more than the {} allowed",
                        file.string(), opened.size, most);
        }
        return read_some(opened, file, opened.size, 0);
    });
}

Result<std::string> read_ends(const fs::path& file, std::size_t ends) {
    if (file == kStandardInput) {
        return read_bytes(file);
    }
    return open_file(file).and_then([&](OpenFile opened) {
        const bool whole = opened.size <= 2 * ends;
        return read_some(opened, file, whole ? opened.size : ends, whole ? 0 : ends);
    });
}

}  // namespace suture::io
