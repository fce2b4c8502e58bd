#include "files/atomic_file.h"

#include "suture/platform/descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <streambuf>
#include <system_error>
#include <tuple>

namespace suture::io {

namespace fs = std::filesystem;

namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// A new file without a name where the file system has such, so that nothing is left of it even
/// when the process is killed; else with a name of its own. Gone at the end unless it was moved.
/// Its stream keeps the first error, which std::ofstream forgets.
class TemporaryFile : public std::streambuf {
  public:
    explicit TemporaryFile(const fs::path& beside) {
        static std::atomic<int> count = 0;
        path_ =
            beside.parent_path() / fmt::format(".suture-{}-{}.tmp", ::getpid(), count.fetch_add(1));
        file_ = make_nameless_file(beside.parent_path());
        if (file_ < 0) {
            file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            named_ = file_ >= 0;
        }
        error_ = file_ < 0 ? errno : 0;
        setp(buffer_.data(), buffer_.data() + buffer_.size());
    }
    ~TemporaryFile() override {
        if (file_ >= 0) {
            ::close(file_);
        }
        if (named_) {
            ::unlink(path_.c_str());
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] int error() const { return error_; }

    /// Flushes to the disk and takes the place of `target`.
    void move_to(const fs::path& target) {
        sync();
        struct stat old {};
        if (error_ == 0 && ::stat(target.c_str(), &old) == 0) {
            check(::fchmod(file_, old.st_mode & 07777));
        }
        check(::fsync(file_));
        if (error_ == 0 && !named_) {
            check(give_name(file_, path_));
            named_ = error_ == 0;
        }
        check(::close(file_));
        file_ = -1;
        if (error_ == 0) {
            check(::rename(path_.c_str(), target.c_str()));
            named_ = error_ != 0;
        }
        // Until the folder is on the disk, a power cut may bring the old name back.
        const int folder = ::open(target.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder >= 0) {
            if (error_ == 0 && ::fsync(folder) != 0 && errno != EINVAL) {
                error_ = errno;
            }
            ::close(folder);
        }
    }

    /// Where the content can be read from while it has no place yet; all of it once flushed.
    [[nodiscard]] fs::path readable() {
        sync();
        return named_ ? path_ : path_of(file_);
    }

  private:
    int overflow(int character) override {
        sync();
        if (error_ != 0) {
            return traits_type::eof();
        }
        if (character != traits_type::eof()) {
            *pptr() = static_cast<char>(character);
            pbump(1);
        }
        return traits_type::not_eof(character);
    }
    int sync() override {
        for (const char* from = pbase(); from < pptr() && error_ == 0;) {
            const ssize_t written = ::write(file_, from, static_cast<size_t>(pptr() - from));
            if (written > 0) {
                from += written;
            } else if (errno != EINTR) {
                error_ = errno;
            }
        }
        setp(buffer_.data(), buffer_.data() + buffer_.size());
        return error_ == 0 ? 0 : -1;
    }
    void check(int result) {
        if (result != 0 && error_ == 0) {
            error_ = errno;
        }
    }

    fs::path path_;
    int file_ = -1;
    bool named_ = false;
    int error_ = 0;
    std::array<char, 1 << 16> buffer_;
};

/// The file that is to be replaced, with links followed, if writing there makes sense at all.
Result<fs::path> target_of(const fs::path& file) {
    std::error_code error;
    const fs::path target = followed(file);
    std::ignore = fs::absolute(file, error);
    if (error) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: {}", file.string(),
                    error.message());
    }
    const fs::path folder = target.parent_path();
    if (!fs::is_directory(folder, error)) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: there is no folder {}",
                    file.string(), folder.string());
    }
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: it is a folder", file.string());
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: it is no ordinary file",
                    file.string());
    }
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: {}", file.string(),
                    reason(errno));
    }
    return target;
}

}  // namespace

fs::path followed(const fs::path& file) {
    std::error_code ignored;
    fs::path target = fs::weakly_canonical(fs::absolute(file, ignored), ignored);
    // A link whose target is missing stays a link, and its target is made.
    constexpr int kMostLinks = 40;
    for (int i = 0; i < kMostLinks && fs::is_symlink(target, ignored); ++i) {
        target =
            fs::weakly_canonical(target.parent_path() / fs::read_symlink(target, ignored), ignored);
    }
    return target;
}

Result<void> write_atomically(const fs::path& file,
                              const std::function<Result<void>(std::ostream&)>& content,
                              const std::function<Result<void>(const fs::path&)>& verify) {
    const Result<fs::path> target = target_of(file);
    if (!target) {
        return tl::unexpected(target.error());
    }
    TemporaryFile temporary(*target);
    if (temporary.error() == 0) {
        std::ostream stream(&temporary);
        if (Result<void> done = content(stream); !done && temporary.error() == 0) {
            return done;
        }
        if (verify) {
            const fs::path written = temporary.readable();
            if (temporary.error() == 0) {
                if (Result<void> good = verify(written); !good) {
                    return good;
                }
            }
        }
        temporary.move_to(*target);
    }
    if (temporary.error() != 0) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: {}", file.string(),
                    reason(temporary.error()));
    }
    return {};
}

}  // namespace suture::io
