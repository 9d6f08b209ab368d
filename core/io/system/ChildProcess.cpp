#include "core/io/system/ChildProcess.h"

#include "core/base/MessageText.h"
#include "core/io/system/OpenFile.h"

#include <fcntl.h>
#include <poll.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace rubble {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMilliseconds = 50;  // latency of a cancellation

/// Owns one end of a pipe.
class PipeEnd {
public:
    PipeEnd() = default;
    ~PipeEnd() { close(); }
    PipeEnd(const PipeEnd&) = delete;
    PipeEnd& operator=(const PipeEnd&) = delete;

    void open(int descriptor) { m_descriptor = descriptor; }
    void close() {
        if (m_descriptor >= 0) ::close(m_descriptor);
        m_descriptor = -1;
    }
    int descriptor() const { return m_descriptor; }
    bool isOpen() const { return m_descriptor >= 0; }

private:
    int m_descriptor = -1;
};

struct Pipe {
    PipeEnd read;
    PipeEnd write;
    /// Returns false if the system has no file descriptors left.
    bool open() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
        read.open(ends[0]);
        write.open(ends[1]);
        return true;
    }
};

void setLimit(decltype(RLIMIT_AS) resource, std::size_t soft, std::size_t hard) {
    const rlimit value{soft, hard};
    ::setrlimit(resource, &value);
}

void setLimit(decltype(RLIMIT_AS) resource, std::size_t max) { setLimit(resource, max, max); }

/// Returns a descriptor that dup2() to a standard stream neither closes nor takes for the stream itself, as it would if
/// the standard streams of this process were closed.
int aboveStreams(int descriptor) {
    return descriptor > STDERR_FILENO ? descriptor : ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
}

/// Leaves the standard streams only to the program that is executed next.
void closeOthersAtExec() {
    constexpr unsigned kFirst = STDERR_FILENO + 1;
#ifdef CLOSE_RANGE_CLOEXEC
    if (::close_range(kFirst, ~0U, CLOSE_RANGE_CLOEXEC) == 0) return;
#endif
    const long count = ::sysconf(_SC_OPEN_MAX);  // the kernel is older than 5.11
    for (int i = kFirst; i < count; ++i) ::fcntl(i, F_SETFD, FD_CLOEXEC);
}

/// Runs in the child: redirects its streams, sets its limits and executes the program. Makes only calls that are safe
/// between fork and exec. If exec fails, writes errno to `failure`.
[[noreturn]] void executeProgram(const char* program, char* const* arguments, const ChildLimits& limits, int output,
                                 int error, int failure) {
    output = aboveStreams(output);
    error = aboveStreams(error);
    failure = aboveStreams(failure);
    const int null = aboveStreams(::open("/dev/null", O_RDONLY));
    ::dup2(null, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(error, STDERR_FILENO);
    setLimit(RLIMIT_AS, limits.memory);
    const auto seconds = static_cast<std::size_t>(std::ceil(limits.seconds));
    setLimit(RLIMIT_CPU, seconds, seconds + 1);  // SIGXCPU, then SIGKILL; with equal limits only the latter
    setLimit(RLIMIT_CORE, 0);
    if (limits.fileSize != ChildLimits::kUnlimited) setLimit(RLIMIT_FSIZE, limits.fileSize);
    closeOthersAtExec();  // before the limit on descriptors, which the highest one may exceed
    setLimit(RLIMIT_NOFILE, limits.descriptors);
    ::signal(SIGPIPE, SIG_DFL);
#ifdef __linux__
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
    char* const empty[] = {nullptr};
    ::execve(program, arguments, limits.environment == ChildEnvironment::Empty ? empty : environ);
    const int code = errno;
    static_cast<void>(!::write(failure, &code, sizeof code));
    ::_exit(127);
}

/// Appends the bytes available in a pipe to `to`, up to `max` in total; closes the pipe at its end.
void readAvailable(PipeEnd& from, std::string& to, std::size_t max) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(from.descriptor(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) return from.close();
    to.append(buffer.data(), std::min(static_cast<std::size_t>(count), max - std::min(max, to.size())));
}

enum class ReadEnd { Closed, TimedOut, TooMuchOutput, Cancelled };

using Deadline = std::chrono::time_point<Clock, std::chrono::duration<double>>;

/// Reads both pipes until they are closed or the child has to be killed.
ReadEnd readPipes(PipeEnd& output, PipeEnd& error, ChildResult& result, const ChildLimits& limits, Deadline end,
                  const TaskContext& context) {
    while (output.isOpen() || error.isOpen()) {
        if (context.isCancelled()) return ReadEnd::Cancelled;
        if (Clock::now() >= end) return ReadEnd::TimedOut;
        std::array<pollfd, 2> polled{pollfd{output.descriptor(), POLLIN, 0}, pollfd{error.descriptor(), POLLIN, 0}};
        if (::poll(polled.data(), polled.size(), kPollMilliseconds) <= 0) continue;
        if (polled[0].revents != 0) readAvailable(output, result.output, limits.output + 1);
        if (polled[1].revents != 0) readAvailable(error, result.error, limits.error);
        if (result.output.size() > limits.output) return ReadEnd::TooMuchOutput;
    }
    return ReadEnd::Closed;
}

/// Returns a descriptor that is readable once the child has ended; -1 where the kernel has none.
int endOf([[maybe_unused]] pid_t child) {
#ifdef SYS_pidfd_open
    return static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
#else
    return -1;
#endif
}

/// Waits for the child to end and returns its wait status. A child that closed its pipes and runs on is killed at its
/// time limit or when the task is cancelled, which changes `readEnd`.
int waitFor(pid_t child, Deadline end, const TaskContext& context, ReadEnd& readEnd) {
    const OpenFile ending(endOf(child));
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return status;
        if (readEnd == ReadEnd::Closed && context.isCancelled()) readEnd = ReadEnd::Cancelled;
        if (readEnd == ReadEnd::Closed && Clock::now() >= end) readEnd = ReadEnd::TimedOut;
        if (readEnd != ReadEnd::Closed) ::kill(child, SIGKILL);
        pollfd polled{ending.descriptor(), POLLIN, 0};  // poll ignores -1
        ::poll(&polled, 1, ending.isOpen() ? kPollMilliseconds : 1);
    }
}

void setExit(ChildResult& result, ReadEnd readEnd, int status) {
    if (readEnd == ReadEnd::TimedOut || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) {
        result.exit = ChildExit::TimedOut;
    } else if (readEnd == ReadEnd::TooMuchOutput) {
        result.exit = ChildExit::TooMuchOutput;
    } else if (WIFEXITED(status)) {
        result.exitCode = WEXITSTATUS(status);
    } else {
        result.exit = ChildExit::Crashed;
        result.signal = WTERMSIG(status);
    }
}

Error cannotStart(const std::filesystem::path& program, int code) {
    return {ErrorCode::Io, "Cannot start " + quotedPath(program) + ": " + std::generic_category().message(code) + "."};
}

}  // namespace

Result<ChildResult> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                             const ChildLimits& limits, const TaskContext& context) {
    Pipe output, error, failure;
    if (!output.open() || !error.open() || !failure.open()) return cannotStart(program, errno);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const Deadline deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
    const pid_t child = ::fork();
    if (child < 0) return cannotStart(program, errno);
    if (child == 0)
        executeProgram(words[0].c_str(), pointers.data(), limits, output.write.descriptor(), error.write.descriptor(),
                       failure.write.descriptor());
    output.write.close();
    error.write.close();
    failure.write.close();

    int code = 0;  // errno of a failed exec; a successful one closes the pipe
    ssize_t count = 0;
    do {
        count = ::read(failure.read.descriptor(), &code, sizeof code);
    } while (count < 0 && errno == EINTR);
    const bool hasFailed = count == sizeof code;
    ChildResult result;
    ReadEnd readEnd = readPipes(output.read, error.read, result, limits, deadline, context);
    const int status = waitFor(child, deadline, context, readEnd);
    if (hasFailed) return cannotStart(program, code);
    if (readEnd == ReadEnd::Cancelled) return TaskContext::cancelled();
    setExit(result, readEnd, status);
    return result;
}

void occupyStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0)  // open() returns the lowest free number
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    }
}

std::optional<std::filesystem::path> findExecutable(const std::string& name) {
    const char* folders = std::getenv("PATH");
    std::istringstream list(folders != nullptr ? folders : "");
    for (std::string folder; std::getline(list, folder, ':');) {
        std::error_code ignored;
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        if (std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0) return path;
    }
    return std::nullopt;
}

}  // namespace rubble
