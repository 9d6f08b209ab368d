// Enters the importer's sandbox and attempts what it forbids: what a mesh could do that takes the importer over.
#include "app/importer/files/Descriptor.h"
#include "app/importer/files/Sandbox.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <string>

namespace {

constexpr int kPrevented = 0;
constexpr int kDone = 1;
constexpr int kUsage = 2;
constexpr int kNotSupported = 3;

enum class Needs { Seccomp, Landlock };

struct Attempt {
    Needs needs;
    std::function<long()> act;  // returns -1 and sets errno if it is prevented, as system calls do
};

long openBeneath(int folder, const char* name, unsigned long long flags) {
    const open_how how{.flags = flags, .mode = flags & O_CREAT ? 0600ULL : 0ULL, .resolve = 0};
    return ::syscall(SYS_openat2, folder, name, &how, sizeof how);
}

long execute() {
    char program[] = "/bin/true";
    char* const arguments[] = {program, nullptr};
    return ::execv(program, arguments);
}

long readParent() {
    char byte = 0;
    const iovec local{&byte, 1}, remote{&byte, 1};
    return ::process_vm_readv(::getppid(), &local, 1, &remote, 1, 0);
}

long map(int protection) {
    void* memory = ::mmap(nullptr, 4096, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? -1 : 0;
}

long makeExecutable() {
    void* memory = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return ::mprotect(memory, 4096, PROT_READ | PROT_EXEC);
}

/// The attempts by name; `folder` holds the files "inside" and "link", which leads to the file "outside" above it.
std::map<std::string, Attempt> attempts(int folder) {
    using enum Needs;
    constexpr int kNew = O_WRONLY | O_CREAT;
    return {
        {"read-password-file", {Landlock, [] { return ::open("/etc/passwd", O_RDONLY); }}},
        {"read-above", {Landlock, [=] { return ::openat(folder, "../outside", O_RDONLY); }}},
        {"read-through-link", {Landlock, [=] { return ::openat(folder, "link", O_RDONLY); }}},
        {"read-environment", {Landlock, [] { return ::open("/proc/self/environ", O_RDONLY); }}},
        {"list-folder", {Landlock, [] { return ::open("/", O_RDONLY | O_DIRECTORY); }}},
        {"write-new", {Seccomp, [=] { return ::openat(folder, "new", kNew, 0600); }}},
        {"write-old", {Seccomp, [=] { return ::openat(folder, "inside", O_RDWR); }}},
        {"write-elsewhere", {Seccomp, [] { return ::open(P_tmpdir "/rubble-attempt", kNew, 0600); }}},
        {"write-nameless", {Seccomp, [] { return ::open(P_tmpdir, O_TMPFILE | O_WRONLY, 0600); }}},
        {"write-through-openat2", {Seccomp, [=] { return openBeneath(folder, "new", kNew); }}},
        {"truncate", {Seccomp, [=] { return ::openat(folder, "inside", O_RDONLY | O_TRUNC); }}},
        {"truncate-through-openat2", {Seccomp, [=] { return openBeneath(folder, "inside", O_RDONLY | O_TRUNC); }}},
        {"delete", {Seccomp, [=] { return ::unlinkat(folder, "inside", 0); }}},
        {"rename", {Seccomp, [=] { return ::renameat(folder, "inside", folder, "new"); }}},
        {"make-folder", {Seccomp, [=] { return ::mkdirat(folder, "new", 0700); }}},
        {"make-link", {Seccomp, [=] { return ::symlinkat("/etc/passwd", folder, "new"); }}},
        {"change-mode", {Seccomp, [=] { return ::fchmodat(folder, "inside", 0777, 0); }}},
        {"connect-internet", {Seccomp, [] { return ::socket(AF_INET, SOCK_STREAM, 0); }}},
        {"connect-local", {Seccomp, [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }}},
        {"fork", {Seccomp, [] { return ::fork(); }}},
        {"clone", {Seccomp, [] { return ::syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0); }}},
        {"execute", {Seccomp, execute}},
        {"trace-parent", {Seccomp, [] { return ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr); }}},
        {"read-parent", {Seccomp, readParent}},
        {"signal-parent", {Seccomp, [] { return ::kill(::getppid(), 0); }}},
        {"signal-parent-thread", {Seccomp, [] { return ::syscall(SYS_tgkill, ::getppid(), ::getppid(), 0); }}},
        {"map-code", {Seccomp, [] { return map(PROT_READ | PROT_EXEC); }}},
        {"make-executable", {Seccomp, makeExecutable}},
        {"memory-file", {Seccomp, [] { return ::syscall(SYS_memfd_create, "code", 0); }}},
        {"io-uring", {Seccomp, [] { return ::syscall(425, 1, nullptr); }}},
        {"change-folder", {Seccomp, [] { return ::chdir("/"); }}},
        // What must work, to show that the others can.
        {"read-inside", {Seccomp, [=] { return ::openat(folder, "inside", O_RDONLY); }}},
        {"allocate", {Seccomp, [] { return map(PROT_READ | PROT_WRITE); }}},
    };
}

}  // namespace

/// importer_attempts FOLDER ATTEMPT prints how the attempt ended.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 3) return kUsage;
    const rubble::Descriptor folder(::open(arguments[1], O_PATH | O_DIRECTORY));
    const auto all = attempts(folder.number());
    const auto attempt = all.find(arguments[2]);
    if (!folder.isOpen() || attempt == all.end()) return kUsage;

    const rubble::Sandbox sandbox = rubble::enterSandbox(folder.number());
    const bool isSupported = attempt->second.needs == Needs::Seccomp ? sandbox.hasSeccomp : sandbox.landlock > 0;
    if (!isSupported) {
        std::puts(attempt->second.needs == Needs::Seccomp ? "This kernel has no seccomp."
                                                          : "This kernel has no Landlock.");
        return kNotSupported;
    }
    const bool isPrevented = attempt->second.act() < 0;
    std::puts(isPrevented ? std::strerror(errno) : "done");
    return isPrevented ? kPrevented : kDone;
}
