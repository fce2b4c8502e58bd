#include "report/picture.h"

#include "suture/platform/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>
#include <vector>

namespace suture::report {
namespace {

namespace fs = std::filesystem;

/// Removed with all that is in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "suture-picture-XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr) {
            path_ = name;
        }
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) {
            fs::remove_all(path_, ignored);
        }
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Runs a program without input and output; its exit code, or none if it had to be ended.
std::optional<int> run_quietly(const std::vector<std::string>& words, std::chrono::seconds limit,
                               const Progress& progress) {
    std::vector<char*> argv;
    for (const std::string& word : words) {
        argv.push_back(const_cast<char*>(word.c_str()));  // NOLINT: exec's type
    }
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        setpgid(0, 0);  // the browser's own processes end with it
        end_with_parent(SIGKILL);
        const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
            dup2(nothing, stream);
        }
        execv(argv[0], argv.data());
        _exit(127);
    }
    if (child < 0) {
        return std::nullopt;
    }
    const auto deadline = std::chrono::steady_clock::now() + limit;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (progress.cancelled() || std::chrono::steady_clock::now() > deadline) {
            kill(-child, SIGKILL);
            waitpid(child, &status, 0);
            return std::nullopt;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return WIFEXITED(status) ? std::optional(WEXITSTATUS(status)) : std::nullopt;
}

std::string address_of(const fs::path& page, const PictureWish& wish) {
    std::string address =
        "file://" + page.string() + "#picture&view=" + wish.view + "&shade=" + wish.shading;
    address += wish.edges ? "" : "&edges=0";
    return address + (wish.before ? "&before=1" : "");
}

}  // namespace

namespace {

/// A program by its path, or by its name on the PATH; empty if there is none.
fs::path find_program(const std::string& name) {
    if (name.find('/') != name.npos) {
        return access(name.c_str(), X_OK) == 0 ? fs::path(name) : fs::path();
    }
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        fs::path program = fs::path(folder) / name;
        if (access(program.c_str(), X_OK) == 0) {
            return program;
        }
    }
    return {};
}

}  // namespace

Result<fs::path> find_browser() {
    if (const char* named = std::getenv("SUTURE_BROWSER"); named != nullptr) {
        const fs::path program = find_program(named);
        if (program.empty()) {
            return fail(ErrorCode::Usage,
                        "SUTURE_BROWSER names {}, and there is no such program: name a browser of "
                        "the chromium family",
                        named);
        }
        return program;
    }
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
        if (fs::path program = find_program(name); !program.empty()) {
            return program;
        }
    }
    return fail(ErrorCode::Usage,
                "pictures are drawn by a browser, and there is none: install chromium, or name one "
                "in SUTURE_BROWSER");
}

Result<void> take_picture(const std::string& page, const PictureWish& wish, const fs::path& png,
                          std::chrono::seconds limit, const Progress& progress) {
    const Result<fs::path> browser = find_browser();
    if (!browser) {
        return tl::unexpected(browser.error());
    }
    const TemporaryFolder folder;
    if (folder.path().empty()) {
        return fail(ErrorCode::WriteFailed, "there is no room for temporary files in {}",
                    fs::temp_directory_path().string());
    }
    const fs::path html = folder.path() / "page.html";
    const fs::path shot = folder.path() / "shot.png";
    std::ofstream(html, std::ios::binary) << page;
    std::vector<std::string> words{browser->string(),
                                   "--headless",
                                   "--disable-quic",
                                   "--no-first-run",
                                   "--disable-background-networking",
                                   "--disable-component-update",
                                   "--disable-sync",
                                   "--disable-dev-shm-usage",
                                   "--hide-scrollbars",
                                   "--use-angle=swiftshader",
                                   "--enable-unsafe-swiftshader",
                                   "--force-device-scale-factor=1",
                                   "--user-data-dir=" + (folder.path() / "profile").string(),
                                   fmt::format("--window-size={},{}", wish.width, wish.height),
                                   "--virtual-time-budget=10000",
                                   "--screenshot=" + shot.string(),
                                   address_of(html, wish)};
    std::optional<int> ended;
    if (geteuid() != 0) {  // Chromium has no sandbox for root
        ended = run_quietly(words, limit, progress);
    }
    if (ended != 0 && !progress.cancelled()) {  // nor where users have no name spaces
        words.insert(words.begin() + 2, "--no-sandbox");
        ended = run_quietly(words, limit, progress);
    }
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "taking the picture was stopped");
    }
    std::error_code error;
    if (ended != 0 || fs::file_size(shot, error) == 0 || error) {
        return fail(ErrorCode::Internal, "{} took no picture{}", browser->string(),
                    ended ? fmt::format(" (exit code {})", *ended)
                          : fmt::format(" within {} s", limit.count()));
    }
    fs::copy_file(shot, png, fs::copy_options::overwrite_existing, error);
    if (error) {
        return fail(ErrorCode::WriteFailed, "{} cannot be written: {}", png.string(),
                    error.message());
    }
    return {};
}

}  // namespace suture::report
