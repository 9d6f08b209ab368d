#include "core/io/ChildProcess.h"

#include <fcntl.h>
#include <poll.h>
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

constexpr std::size_t kMostError = 4096;  // bytes kept of what the child says
constexpr int kPollMilliseconds = 50;     // how soon a cancel is seen

/// One end of a pipe that closes itself.
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
    /// False where the system has none left.
    bool make() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
        read.open(ends[0]);
        write.open(ends[1]);
        return true;
    }
};

void limit(decltype(RLIMIT_AS) resource, std::size_t most) {
    const rlimit value{most, most};
    ::setrlimit(resource, &value);
}

/// What the child does before it is the other program. Only calls that are safe between fork and exec.
[[noreturn]] void becomeProgram(const char* program, char* const* arguments, const ChildLimits& limits, int output,
                                int error, int failure) {
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(error, STDERR_FILENO);
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_CPU, static_cast<std::size_t>(std::ceil(limits.seconds)));
    limit(RLIMIT_CORE, 0);
    ::signal(SIGPIPE, SIG_DFL);
    ::execv(program, arguments);
    const int code = errno;
    static_cast<void>(!::write(failure, &code, sizeof code));
    ::_exit(127);
}

/// Takes what is there to be read; closes the end of a pipe that will give no more.
void readSome(PipeEnd& from, std::string& to, std::size_t most) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(from.descriptor(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) return from.close();
    to.append(buffer.data(), std::min(static_cast<std::size_t>(count), most - std::min(most, to.size())));
}

/// Listens until both pipes are closed or there is a reason to kill the child.
enum class Listening { Ended, TimedOut, TooMuchOutput, Cancelled };
Listening listen(PipeEnd& output, PipeEnd& error, ChildOutcome& outcome, const ChildLimits& limits,
                 const TaskContext& context) {
    const auto end = Clock::now() + std::chrono::duration<double>(limits.seconds);
    while (output.isOpen() || error.isOpen()) {
        if (context.isCancelled()) return Listening::Cancelled;
        if (Clock::now() >= end) return Listening::TimedOut;
        std::array<pollfd, 2> polled{pollfd{output.descriptor(), POLLIN, 0}, pollfd{error.descriptor(), POLLIN, 0}};
        if (::poll(polled.data(), polled.size(), kPollMilliseconds) <= 0) continue;
        if (polled[0].revents != 0) readSome(output, outcome.output, limits.output + 1);
        if (polled[1].revents != 0) readSome(error, outcome.error, kMostError);
        if (outcome.output.size() > limits.output) return Listening::TooMuchOutput;
    }
    return Listening::Ended;
}

/// Waits for the child, which has closed its pipes or was killed; one that goes on without them is killed in time.
int statusOf(pid_t child, const ChildLimits& limits) {
    const auto end = Clock::now() + std::chrono::duration<double>(limits.seconds);
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return status;
        if (Clock::now() >= end) ::kill(child, SIGKILL);
        ::poll(nullptr, 0, 1);
    }
}

void tellEnd(ChildOutcome& outcome, Listening listening, int status) {
    if (listening == Listening::TimedOut || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) {
        outcome.end = ChildEnd::TimedOut;
    } else if (listening == Listening::TooMuchOutput) {
        outcome.end = ChildEnd::TooMuchOutput;
    } else if (WIFEXITED(status)) {
        outcome.exitCode = WEXITSTATUS(status);
    } else {
        outcome.end = ChildEnd::Crashed;
    }
}

Error cannotStart(const std::filesystem::path& program, int code) {
    return {ErrorCode::Io, "Cannot start \"" + program.string() + "\": " + std::generic_category().message(code) + "."};
}

}  // namespace

Result<ChildOutcome> runChild(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                              const ChildLimits& limits, const TaskContext& context) {
    Pipe output, error, failure;
    if (!output.make() || !error.make() || !failure.make()) return cannotStart(program, errno);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const pid_t child = ::fork();
    if (child < 0) return cannotStart(program, errno);
    if (child == 0)
        becomeProgram(words[0].c_str(), pointers.data(), limits, output.write.descriptor(), error.write.descriptor(),
                      failure.write.descriptor());
    output.write.close();
    error.write.close();
    failure.write.close();

    int code = 0;  // closed by a successful exec, else it holds the reason
    const bool hasFailed = ::read(failure.read.descriptor(), &code, sizeof code) == sizeof code;
    ChildOutcome outcome;
    const Listening listening = listen(output.read, error.read, outcome, limits, context);
    if (listening != Listening::Ended) ::kill(child, SIGKILL);
    const int status = statusOf(child, limits);
    if (hasFailed) return cannotStart(program, code);
    if (listening == Listening::Cancelled) return TaskContext::cancelled();
    tellEnd(outcome, listening, status);
    return outcome;
}

std::optional<std::filesystem::path> programInPath(const std::string& name) {
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
