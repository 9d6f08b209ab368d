// A library for LD_PRELOAD that makes one call to the file system fail, or kills the process just before it. Counts the
// calls that open, create, write, flush, rename, link, change, close or remove something below a folder.
//
// RUBBLE_FAULT_FOLDER    the folder, an absolute path
// RUBBLE_FAULT_CALL      the number of the call, from 1
// RUBBLE_FAULT_CODE      the value of errno; 0 kills the process instead
// RUBBLE_FAULT_LASTING   if set, all later calls fail, too, as of a disk that is gone
// RUBBLE_FAULT_REPORT    a file outside the folder, which receives the name of the call that failed
// RUBBLE_FAULT_LOG       a file outside the folder, which receives the name of each call and the path that it is about
// RUBBLE_FAULT_SYSTEM_CALL and RUBBLE_FAULT_CODE alone: the number of a system call that always fails, where it is made
//                        by syscall()
// RUBBLE_FAULT_THREADS   how many threads can be started; no more after that, as where the system has a limit
// RUBBLE_FAULT_NO_FLAGS  if set, renameat2() knows no flags, as on network file systems
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> callCount{0};
thread_local char pathOfCall[8192];

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool isBelow(const char* path) {
    const char* folder = std::getenv("RUBBLE_FAULT_FOLDER");
    if (folder == nullptr || path == nullptr) return false;
    char current[4096];
    char whole[8192];
    if (path[0] != '/') {
        if (syscall(SYS_getcwd, current, sizeof current) <= 0) return false;
        std::snprintf(whole, sizeof whole, "%s/%s", current, path);
        path = whole;
    }
    if (std::strncmp(path, folder, std::strlen(folder)) != 0) return false;
    std::snprintf(pathOfCall, sizeof pathOfCall, "%s", path);
    return true;
}

bool isBelow(int descriptor) {
    char link[64];
    char path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0) return false;
    path[length] = '\0';
    return isBelow(path);
}

bool isBelow(int folder, const char* path) {
    if (path != nullptr && (path[0] == '/' || folder == AT_FDCWD)) return isBelow(path);
    return isBelow(folder);
}

/// Appends text to the file that a variable names, if there is one.
void append(const char* variable, const char* text) {
    const char* path = std::getenv(variable);
    if (path == nullptr) return;
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND, 0600);
    syscall(SYS_write, file, text, std::strlen(text));
    syscall(SYS_close, file);
}

/// Counts a call; returns whether it is to fail, with errno set. Does not return if the process is to be killed.
bool fails(const char* call) {
    char line[8300];
    std::snprintf(line, sizeof line, "%s %s\n", call, pathOfCall);
    append("RUBBLE_FAULT_LOG", line);
    const char* number = std::getenv("RUBBLE_FAULT_CALL");
    const char* code = std::getenv("RUBBLE_FAULT_CODE");
    if (number == nullptr || code == nullptr) return false;
    const long first = std::atol(number), now = ++callCount;
    const bool isLater = std::getenv("RUBBLE_FAULT_LASTING") != nullptr && first > 0 && now > first;
    if (now != first && !isLater) return false;
    if (!isLater) append("RUBBLE_FAULT_REPORT", call);
    errno = std::atoi(code);
    if (errno == 0) std::raise(SIGKILL);
    return true;
}

}  // namespace

extern "C" {

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) {
    static std::atomic<long> started{0};
    const char* most = std::getenv("RUBBLE_FAULT_THREADS");
    if (most != nullptr && started++ >= std::atol(most)) return EAGAIN;
    return next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create")(thread, attributes,
                                                                                                   work, argument);
}

#define RUBBLE_FAULTY_OPEN(name)                                           \
    int name(const char* path, int flags, ...) {                           \
        va_list arguments;                                                 \
        va_start(arguments, flags);                                        \
        const mode_t mode = va_arg(arguments, mode_t);                     \
        va_end(arguments);                                                 \
        if (isBelow(path) && fails(#name)) return -1;                      \
        return next<int(const char*, int, ...)>(#name)(path, flags, mode); \
    }
RUBBLE_FAULTY_OPEN(open)
RUBBLE_FAULTY_OPEN(open64)

#define RUBBLE_FAULTY_OPENAT(name)                                                      \
    int name(int folder, const char* path, int flags, ...) {                            \
        va_list arguments;                                                              \
        va_start(arguments, flags);                                                     \
        const mode_t mode = va_arg(arguments, mode_t);                                  \
        va_end(arguments);                                                              \
        if (isBelow(folder, path) && fails(#name)) return -1;                           \
        return next<int(int, const char*, int, ...)>(#name)(folder, path, flags, mode); \
    }
RUBBLE_FAULTY_OPENAT(openat)
RUBBLE_FAULTY_OPENAT(openat64)

ssize_t write(int file, const void* bytes, size_t count) {
    if (isBelow(file) && fails("write")) return -1;
    return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

#define RUBBLE_FAULTY_PWRITE(name)                                                                  \
    ssize_t name(int file, const void* bytes, size_t count, off_t position) {                       \
        if (isBelow(file) && fails(#name)) return -1;                                               \
        return next<ssize_t(int, const void*, size_t, off_t)>(#name)(file, bytes, count, position); \
    }
RUBBLE_FAULTY_PWRITE(pwrite)
RUBBLE_FAULTY_PWRITE(pwrite64)

ssize_t read(int file, void* bytes, size_t count) {
    if (isBelow(file) && fails("read")) return -1;
    return next<ssize_t(int, void*, size_t)>("read")(file, bytes, count);
}

int close(int file) {
    const bool isFailing = isBelow(file) && fails("close");
    const int code = errno;
    const int closed = next<int(int)>("close")(file);
    if (isFailing) errno = code;
    return isFailing ? -1 : closed;
}

int fsync(int file) {
    if (isBelow(file) && fails("fsync")) return -1;
    return next<int(int)>("fsync")(file);
}

int syncfs(int file) {
    if (isBelow(file) && fails("syncfs")) return -1;
    return next<int(int)>("syncfs")(file);
}

int ftruncate(int file, off_t size) {
    if (isBelow(file) && fails("ftruncate")) return -1;
    return next<int(int, off_t)>("ftruncate")(file, size);
}

int fchmod(int file, mode_t mode) {
    if (isBelow(file) && fails("fchmod")) return -1;
    return next<int(int, mode_t)>("fchmod")(file, mode);
}

long syscall(long number, ...) noexcept {
    va_list list;
    va_start(list, number);
    long argument[6];
    for (long& each : argument) each = va_arg(list, long);
    va_end(list);
    const char* failing = std::getenv("RUBBLE_FAULT_SYSTEM_CALL");
    const bool isProbe = number == SYS_seccomp && argument[2] == 0;  // of libseccomp: without a filter
    if (failing != nullptr && number == std::atol(failing) && !isProbe) {
        errno = std::atoi(std::getenv("RUBBLE_FAULT_CODE"));
        return -1;
    }
    return next<long(long, ...)>("syscall")(number, argument[0], argument[1], argument[2], argument[3], argument[4],
                                            argument[5]);
}

int mkdir(const char* path, mode_t mode) {
    if (isBelow(path) && fails("mkdir")) return -1;
    return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

int rename(const char* from, const char* to) {
    if (isBelow(to) && fails("rename")) return -1;
    return next<int(const char*, const char*)>("rename")(from, to);
}

int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
    if (isBelow(toFolder, to) && fails("renameat2")) return -1;
    if (flags != 0 && std::getenv("RUBBLE_FAULT_NO_FLAGS") != nullptr) {
        errno = EINVAL;
        return -1;
    }
    return next<int(int, const char*, int, const char*, unsigned)>("renameat2")(fromFolder, from, toFolder, to, flags);
}

int link(const char* from, const char* to) {
    if (isBelow(to) && fails("link")) return -1;
    return next<int(const char*, const char*)>("link")(from, to);
}

int unlink(const char* path) {
    if (isBelow(path) && fails("unlink")) return -1;
    return next<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) {
    if (isBelow(folder, path) && fails("unlinkat")) return -1;
    return next<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int rmdir(const char* path) {
    if (isBelow(path) && fails("rmdir")) return -1;
    return next<int(const char*)>("rmdir")(path);
}

int remove(const char* path) noexcept {
    if (isBelow(path) && fails("remove")) return -1;
    return next<int(const char*)>("remove")(path);
}

}  // extern "C"
