#include "suture/platform/sandbox.h"

#include "suture/platform/sanitized.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace suture {
namespace {

namespace fs = std::filesystem;

// Headers older than the kernel lack the later ones.
constexpr std::uint64_t kRefer = 1ULL << 13U;     // LANDLOCK_ACCESS_FS_REFER, version 2
constexpr std::uint64_t kTruncate = 1ULL << 14U;  // LANDLOCK_ACCESS_FS_TRUNCATE, version 3

constexpr std::uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t kRead = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kExecute = LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t kWriteFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr std::uint64_t kWrite = kWriteFile | LANDLOCK_ACCESS_FS_MAKE_REG |
                                 LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                 LANDLOCK_ACCESS_FS_REMOVE_DIR;
constexpr std::uint64_t kNever = LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_SOCK |
                                 LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
                                 LANDLOCK_ACCESS_FS_MAKE_SYM | kRefer;

/// Of a file, no rights make sense that folders have.
constexpr std::uint64_t kOfFiles = kReadFile | kExecute | kWriteFile;

/// The version, 0 if there is none.
int landlock_version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? static_cast<int>(version) : 0;
}

std::uint64_t rights_known(int version) {
    std::uint64_t rights = kRead | kExecute | kWrite | kNever;
    rights &= version >= 2 ? ~0ULL : ~kRefer;
    return rights & (version >= 3 ? ~0ULL : ~kTruncate);
}

class Ruleset {
  public:
    explicit Ruleset(int version) : known_(rights_known(version)) {
        landlock_ruleset_attr attributes{};
        attributes.handled_access_fs = known_;
        // The first field alone: later versions have more of them.
        file_ = static_cast<int>(
            syscall(SYS_landlock_create_ruleset, &attributes, sizeof(std::uint64_t), 0));
    }
    ~Ruleset() { close(file_); }
    Ruleset(const Ruleset&) = delete;
    Ruleset& operator=(const Ruleset&) = delete;

    /// A path that is not there needs no rule.
    void allow(const fs::path& path, std::uint64_t rights) const {
        const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
        struct stat status {};
        if (file < 0 || fstat(file, &status) != 0) {
            return;
        }
        landlock_path_beneath_attr rule{};
        rule.allowed_access = rights & known_ & (S_ISDIR(status.st_mode) ? ~0ULL : kOfFiles);
        rule.parent_fd = file;
        syscall(SYS_landlock_add_rule, file_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
        close(file);
    }

    void restrict_self() const { syscall(SYS_landlock_restrict_self, file_, 0); }

  private:
    std::uint64_t known_;
    int file_;
};

/// The folders of all libraries that are loaded: OCCT may stand anywhere.
std::vector<fs::path> folders_of_libraries() {
    std::vector<fs::path> folders;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t /*size*/, void* data) {
            const fs::path file = info->dlpi_name;
            if (file.has_parent_path()) {
                static_cast<std::vector<fs::path>*>(data)->push_back(file.parent_path());
            }
            return 0;
        },
        &folders);
    return folders;
}

void restrict_files(const SandboxPaths& paths, int version) {
    const Ruleset rules(version);
    for (const char* system :
         {"/usr", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/localtime", "/etc/fonts",
          "/var/cache/fontconfig", "/proc/self", "/proc/cpuinfo", "/proc/meminfo",
          "/sys/devices/system", "/sys/fs/cgroup", "/dev/urandom"}) {
        rules.allow(system, kRead);
    }
    if (kSanitized) {
        rules.allow("/proc", kRead);  // the entries of Suture's other programs
    }
    rules.allow("/dev/null", kReadFile | kWriteFile);
    for (const char* loader : {"/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1"}) {
        rules.allow(loader, kReadFile | kExecute);
    }
    for (const fs::path& folder : folders_of_libraries()) {
        rules.allow(folder, kRead);
    }
    for (const fs::path& path : paths.read) {
        rules.allow(path, kRead);
    }
    for (const fs::path& path : paths.write) {
        rules.allow(path, kRead | kWrite);
    }
    for (const fs::path& path : paths.execute) {
        rules.allow(path, kReadFile | kExecute);
    }
    rules.restrict_self();
}

bool has_seccomp() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    return syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#endif

/// What no work on a model needs.
constexpr std::array kForbidden = {SYS_socket,
                                   SYS_socketpair,
                                   SYS_connect,
                                   SYS_bind,
                                   SYS_ptrace,
                                   SYS_process_vm_readv,
                                   SYS_process_vm_writev,
                                   SYS_mount,
                                   SYS_umount2,
                                   SYS_pivot_root,
                                   SYS_chroot,
                                   SYS_setns,
                                   SYS_unshare,
                                   SYS_keyctl,
                                   SYS_add_key,
                                   SYS_request_key,
                                   SYS_bpf,
                                   SYS_perf_event_open,
                                   SYS_io_uring_setup,
                                   SYS_userfaultfd,
                                   SYS_init_module,
                                   SYS_finit_module,
                                   SYS_kexec_load,
                                   SYS_open_by_handle_at,
                                   SYS_reboot,
                                   SYS_swapon,
                                   SYS_quotactl,
                                   SYS_acct};

void restrict_calls() {
    constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;
    constexpr std::uint32_t kOtherTable = 0x40000000;  // of x86-64: the calls of x32
    std::vector<sock_filter> filter{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, kRefuse),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kOtherTable, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, kRefuse)};
    for (const long call : kForbidden) {
        filter.push_back(
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1));
        filter.push_back(BPF_STMT(BPF_RET | BPF_K, kRefuse));
    }
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program);
}

}  // namespace

std::string sandbox_support() {
    const int version = landlock_version();
    const std::string files = version > 0 ? fmt::format("Landlock {}", version) : "";
    const std::string calls = has_seccomp() ? "seccomp" : "";
    const std::string both = files + (files.empty() || calls.empty() ? "" : ", ") + calls;
    return both.empty() ? "none" : both;
}

void enter_sandbox(const SandboxPaths& paths) {
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return;  // the condition of both
    }
    if (const int version = landlock_version(); version > 0) {
        restrict_files(paths, version);
    }
    if (has_seccomp()) {
        restrict_calls();
    }
}

}  // namespace suture

/// OCCT asks for this machine's address when it writes AP203, and dies if there is no answer (7.6:
/// OSD_Host::InternetAddress copies from a null pointer). In the sandbox there is none, and no
/// file need tell where it was made: the program's own function, which goes before the C library's,
/// says that every host is this one.
extern "C" hostent* gethostbyname(const char* /*name*/) {
    static in_addr address{htonl(INADDR_LOOPBACK)};
    static char name[] = "localhost";
    static char* no_alias = nullptr;
    static std::array<char*, 2> addresses{reinterpret_cast<char*>(&address), nullptr};
    static hostent host{name, &no_alias, AF_INET, sizeof address, addresses.data()};
    return &host;
}
