#include "files/atomic_file.h"

#include "step_io/files/assembly.h"
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace suture::io::test {

namespace {

ModelFile box() {
    return model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box");
}

std::string refusal(const std::filesystem::path& file, Format format = Format::Step) {
    const auto done = write_model(box(), file, format, {});
    if (done) {
        return "was written";
    }
    EXPECT_EQ(done.error().code, ErrorCode::WriteFailed);
    EXPECT_EQ(done.error().message.rfind(file.string() + " cannot be written: ", 0), 0U)
        << done.error().message;
    return done.error().message.substr(
        std::min(done.error().message.size(), file.string().size() + 20));
}

unsigned permissions(const std::filesystem::path& file) {
    struct stat status {};
    ::stat(file.c_str(), &status);
    return status.st_mode & 0777U;
}

/// Files may not grow beyond so many bytes while this lives.
class SizeLimit {
  public:
    explicit SizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~SizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;

  private:
    rlimit old_{};
    void (*handler_)(int);
};

}  // namespace

TEST(WriteFailure, LeavesTheOldFileIntactWhenTheFileGrowsTooLarge) {
    const Folder folder;
    for (const Format format : {Format::Step, Format::Iges, Format::BrepText, Format::BrepBinary,
                                Format::BrepFreecad, Format::Off}) {
        save(folder / "old", "precious");
        {
            const SizeLimit limit(100);
            EXPECT_EQ(refusal(folder / "old", format), "File too large") << to_string(format);
        }
        EXPECT_EQ(content(folder / "old"), "precious");
        EXPECT_EQ(folder.files(), 1);
    }
}

TEST(WriteFailure, LeavesTheOldFileIntactOnAFullDisk) {
    const Folder folder;
    std::filesystem::create_directory(folder / "disk");
    if (::mount("none", (folder / "disk").c_str(), "tmpfs", 0, "size=8k") != 0) {
        GTEST_SKIP() << "may not mount a small disk here";
    }
    save(folder / "disk" / "old.step", "precious");
    EXPECT_EQ(refusal(folder / "disk" / "old.step"), "No space left on device");
    EXPECT_EQ(content(folder / "disk" / "old.step"), "precious");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "disk"), {}), 1);
    ::umount((folder / "disk").c_str());
}

TEST(WriteFailure, NamesTheReason) {
    const Folder folder;
    EXPECT_EQ(refusal(folder / "no" / "box.step"),
              "there is no folder " + (folder / "no").string());
    std::filesystem::create_directory(folder / "box.step");
    EXPECT_EQ(refusal(folder / "box.step"), "it is a folder");
    EXPECT_EQ(refusal("/dev/full"), "it is no ordinary file");
    if (::geteuid() != 0) {
        save(folder / "fixed.step", "precious");
        ::chmod((folder / "fixed.step").c_str(), 0444);
        EXPECT_EQ(refusal(folder / "fixed.step"), "Permission denied");
    }
}

TEST(Write, GivesANewFileTheUsualPermissionsAndAnOldOneItsOwn) {
    const Folder folder;
    const mode_t mask = ::umask(027);
    write(box(), folder / "new.step", Format::Step);
    ::umask(mask);
    EXPECT_EQ(permissions(folder / "new.step"), 0640U);
    ::chmod((folder / "new.step").c_str(), 0604);
    write(box(), folder / "new.step", Format::Step);
    EXPECT_EQ(permissions(folder / "new.step"), 0604U);
    EXPECT_EQ(folder.files(), 1);
}

TEST(Write, FollowsASymbolicLink) {
    const Folder folder;
    save(folder / "target.step", "old");
    std::filesystem::create_symlink("target.step", folder / "link.step");
    write(box(), folder / "link.step", Format::Step);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.step"));
    EXPECT_EQ(content(folder / "target.step").rfind("ISO-10303-21;", 0), 0U);
}

TEST(Write, LeavesNothingBehindWhenKilled) {
    const Folder folder;
    save(folder / "old", "precious");
    const int probe = ::open((folder / "").c_str(), O_WRONLY | O_TMPFILE, 0600);
    if (probe < 0) {
        GTEST_SKIP() << "this file system has no files without a name";
    }
    ::close(probe);
    const pid_t child = ::fork();
    if (child == 0) {
        static_cast<void>(write_atomically(folder / "old", [](std::ostream& stream) {
            stream << "half" << std::flush;
            ::raise(SIGKILL);
            return Result<void>();
        }));
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(content(folder / "old"), "precious");
    EXPECT_EQ(folder.files(), 1);
}

TEST(Write, IsAbandonedWhenTheContentRefuses) {
    const Folder folder;
    save(folder / "old", "precious");
    const Result<void> done = write_atomically(folder / "old", [](std::ostream& stream) {
        stream << "half";
        return Result<void>(fail(ErrorCode::Internal, "no more"));
    });
    EXPECT_EQ(done.error().message, "no more");
    EXPECT_EQ(content(folder / "old"), "precious");
    EXPECT_EQ(folder.files(), 1);
}

}  // namespace suture::io::test
