#include "tests/attack/monkey/Confinement.h"

#include "core/io/system/OpenFile.h"

#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cstdint>

namespace rubble::attack {
namespace {

// Headers of older kernels lack the newer flags.
constexpr std::uint64_t kWriteFile = 1U << 1U;
constexpr std::uint64_t kMakeAndRemove = 0x1ff0;  // files, folders, links, pipes, sockets and devices
constexpr std::uint64_t kRefer = 1U << 13U;       // to move between folders; without it that is forbidden; version 2
constexpr std::uint64_t kTruncate = 1U << 14U;    // version 3

bool allow(const OpenFile& rules, const std::filesystem::path& folder, std::uint64_t access) {
    const OpenFile below(folder, O_PATH | O_DIRECTORY);
    const landlock_path_beneath_attr rule{.allowed_access = access, .parent_fd = below.descriptor()};
    return below.isOpen() &&
           ::syscall(SYS_landlock_add_rule, rules.descriptor(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

bool confineWrites(const std::filesystem::path& folder) {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    std::uint64_t access = kWriteFile | kMakeAndRemove;
    if (version >= 2) access |= kRefer;
    if (version >= 3) access |= kTruncate;
    const landlock_ruleset_attr attributes{.handled_access_fs = access};
    const OpenFile rules(
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0)));
    return rules.isOpen() && allow(rules, folder, access) && allow(rules, "/dev", access & (kWriteFile | kTruncate)) &&
           ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::syscall(SYS_landlock_restrict_self, rules.descriptor(), 0) == 0;
}

}  // namespace rubble::attack
