#include "app/importer/files/Sandbox.h"

#ifdef __linux__

#include "app/importer/files/Descriptor.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <initializer_list>
#include <system_error>

namespace rubble {
namespace {

// The kernel's structures and flags of Landlock 7; headers of older kernels lack the newer ones.
struct LandlockRules {
    std::uint64_t files = 0;
    std::uint64_t network = 0;  // since version 4
    std::uint64_t scopes = 0;   // since version 6
};
constexpr std::uint64_t kConnectAndBind = 3;
constexpr std::uint64_t kSocketsAndSignals = 3;
/// The number of rights to files in each version, the first at index 0.
constexpr std::array kFileRights = {13, 14, 15, 15, 16};
/// From this version on no flag of openat2 can change a file, which seccomp cannot check.
constexpr int kForbidsTruncation = 3;

/// Returns 0 where the kernel lacks Landlock or was started without it, -1 with errno on another error.
int landlockVersion() {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version < 0 && (errno == ENOSYS || errno == EOPNOTSUPP) ? 0 : static_cast<int>(version);
}

std::string failureOf(const char* part, int code) {
    return std::string(part) + " cannot be put in force: " + std::generic_category().message(code);
}

LandlockRules rulesOf(int version) {
    const auto index = static_cast<std::size_t>(std::min<int>(version, kFileRights.size()) - 1);
    LandlockRules rules{.files = (std::uint64_t{1} << kFileRights[index]) - 1};
    if (version >= 4) rules.network = kConnectAndBind;
    if (version >= 6) rules.scopes = kSocketsAndSignals;
    return rules;
}

/// Forbids all access to files but reading below the folder.
void restrictFiles(int folder, Sandbox& sandbox) {
    const int version = landlockVersion();
    if (version < 0) sandbox.failure = failureOf("Landlock", errno);
    if (version <= 0) return;
    const LandlockRules rules = rulesOf(version);
    const std::size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
    const Descriptor set(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rules, size, 0)));
    const landlock_path_beneath_attr below{.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE, .parent_fd = folder};
    const bool isRestricted =
        set.isOpen() && ::syscall(SYS_landlock_add_rule, set.number(), LANDLOCK_RULE_PATH_BENEATH, &below, 0) == 0 &&
        ::syscall(SYS_landlock_restrict_self, set.number(), 0) == 0;
    if (!isRestricted) sandbox.failure = failureOf("Landlock", errno);
    if (isRestricted) sandbox.landlock = version;
}

// What a program without threads needs that allocates, reads, throws, aborts and exits.
constexpr std::array kAllowedCalls = {
    SCMP_SYS(read),          SCMP_SYS(pread64),        SCMP_SYS(close),
    SCMP_SYS(lseek),         SCMP_SYS(fstat),          SCMP_SYS(brk),
    SCMP_SYS(munmap),        SCMP_SYS(mremap),         SCMP_SYS(madvise),
    SCMP_SYS(futex),         SCMP_SYS(getpid),         SCMP_SYS(gettid),
    SCMP_SYS(rt_sigaction),  SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn),
    SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday),   SCMP_SYS(getrandom),
    SCMP_SYS(exit),          SCMP_SYS(exit_group),
};

/// The filter of system calls.
class CallFilter {
public:
    CallFilter() : m_filter(seccomp_init(SCMP_ACT_ERRNO(EPERM))) {
        // The kernel's own errors, which show whether it lacks seccomp: otherwise all are ECANCELED.
        m_isComplete = m_filter != nullptr && seccomp_attr_set(m_filter, SCMP_FLTATR_API_SYSRAWRC, 1) == 0;
    }
    CallFilter(const CallFilter&) = delete;
    CallFilter& operator=(const CallFilter&) = delete;
    ~CallFilter() {
        if (m_filter != nullptr) seccomp_release(m_filter);
    }

    void allow(int call) { allow(call, {}); }
    void allowIfEqual(int call, unsigned argument, std::uint64_t value) {
        allow(call, {{.arg = argument, .op = SCMP_CMP_EQ, .datum_a = value, .datum_b = 0}});
    }
    /// Allows a call in which the bits of `mask` in an argument have this value.
    void allowIfBits(int call, unsigned argument, std::uint64_t mask, std::uint64_t value) {
        allow(call, {{.arg = argument, .op = SCMP_CMP_MASKED_EQ, .datum_a = mask, .datum_b = value}});
    }
    /// Returns 0 or errno: EINVAL if the kernel lacks seccomp.
    int apply() { return m_isComplete ? -seccomp_load(m_filter) : ENOMEM; }

private:
    void allow(int call, std::initializer_list<scmp_arg_cmp> conditions) {
        m_isComplete =
            m_isComplete && seccomp_rule_add_array(m_filter, SCMP_ACT_ALLOW, call,
                                                   static_cast<unsigned>(conditions.size()), conditions.begin()) == 0;
    }

    scmp_filter_ctx m_filter;
    bool m_isComplete = false;
};

int filterCalls(int landlock) {
    constexpr std::uint64_t kTemporary = O_TMPFILE & ~O_DIRECTORY;
    constexpr std::uint64_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | kTemporary;
    CallFilter filter;
    for (const int call : kAllowedCalls) filter.allow(call);
    for (const int call : {SCMP_SYS(write), SCMP_SYS(writev)}) {
        filter.allowIfEqual(call, 0, STDOUT_FILENO);
        filter.allowIfEqual(call, 0, STDERR_FILENO);
    }
    filter.allowIfBits(SCMP_SYS(openat), 2, kWriting, O_RDONLY);
    if (landlock >= kForbidsTruncation) filter.allow(SCMP_SYS(openat2));
    filter.allowIfBits(SCMP_SYS(newfstatat), 3, AT_EMPTY_PATH, AT_EMPTY_PATH);  // fstat() of the C library
    filter.allowIfBits(SCMP_SYS(mmap), 2, PROT_EXEC, 0);
    filter.allowIfBits(SCMP_SYS(mprotect), 2, PROT_EXEC, 0);
    filter.allowIfEqual(SCMP_SYS(tgkill), 0, static_cast<std::uint64_t>(::getpid()));  // abort()
    return filter.apply();
}

}  // namespace

Sandbox enterSandbox(int folder) {
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    Sandbox sandbox;
    restrictFiles(folder, sandbox);
    const int code = filterCalls(sandbox.landlock);
    sandbox.hasSeccomp = code == 0;
    if (code != 0 && code != EINVAL && code != ENOSYS) sandbox.failure = failureOf("seccomp", code);
    return sandbox;
}

}  // namespace rubble

#else

namespace rubble {

Sandbox enterSandbox(int) { return {}; }

}  // namespace rubble

#endif

namespace rubble {

std::string sandboxText(const Sandbox& sandbox) {
    const std::string landlock = sandbox.landlock == 0 ? "none" : "version " + std::to_string(sandbox.landlock);
    return std::string("seccomp: ") + (sandbox.hasSeccomp ? "on" : "none") + "\nLandlock: " + landlock + "\n";
}

}  // namespace rubble
