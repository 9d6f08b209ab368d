#include "tests/soak/ChildProcess.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sstream>
#include <string>
#include <string_view>

namespace rubble::soak {
namespace {

constexpr int kSeconds = 60;  // of the processor, for a case
constexpr std::size_t kTextSize = 1 << 15;

/// Failures as lines of four fields.
std::string linesOf(const std::vector<Failure>& failures) {
    std::string text;
    for (const Failure& one : failures) {
        text += one.invariant + '\t' + std::to_string(one.step) + '\t' + one.body + '\t' + one.text + '\n';
    }
    return text;
}

std::vector<Failure> failuresOf(const std::string& text) {
    std::vector<Failure> failures;
    std::istringstream lines(text);
    std::string step;
    for (Failure one; std::getline(lines, one.invariant, '\t') && std::getline(lines, step, '\t') &&
                      std::getline(lines, one.body, '\t') && std::getline(lines, one.text);) {
        one.step = std::strtoull(step.c_str(), nullptr, 10);
        failures.push_back(one);
    }
    return failures;
}

/// Ends this process by SIGPROF if it computes too long.
void limitProcess() {
    const itimerval limit{{0, 0}, {kSeconds, 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
}

/// A text without the folder of the sources, which assertions print: saved cases are the same wherever they were found.
std::string withoutSourceFolder(std::string text) {
    constexpr std::string_view kFile = __FILE__, kName = "tests/soak/ChildProcess.cpp";
    static_assert(kFile.ends_with(kName));
    constexpr std::string_view kFolder = kFile.substr(0, kFile.size() - kName.size());
    if (kFolder.empty()) return text;
    for (std::size_t at = 0; (at = text.find(kFolder, at)) != std::string::npos;) text.erase(at, kFolder.size());
    return text;
}

}  // namespace

/// What the child reports while it runs.
struct ChildRun::Shared {
    std::uint64_t steps = 0;
    std::uint64_t breaks = 0;
    std::uint64_t splits = 0;
    std::optional<double> agreement{};
    std::array<char, kTextSize> failures{};

    void set(const Outcome& outcome) {
        steps = outcome.steps;
        breaks = outcome.breaks;
        splits = outcome.splits;
        agreement = outcome.agreement;
        const std::string text = linesOf(outcome.failures);
        std::memcpy(failures.data(), text.data(), std::min(text.size(), failures.size() - 1));
    }
};

ChildRun::ChildRun(const SoakCase& one, const std::string& invariant) {
    void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::exit(2);
    m_shared = new (memory) Shared;
    m_errors = ::memfd_create("errors", 0);
    std::fflush(nullptr);
    m_process = ::fork();
    if (m_process < 0) std::exit(2);
    if (m_process != 0) return;
    limitProcess();
    ::dup2(m_errors, STDERR_FILENO);
    m_shared->set(playedCase(one, invariant, [&](const Outcome& soFar) { m_shared->set(soFar); }));
    std::_Exit(0);
}

ChildRun::~ChildRun() {
    if (!m_hasEnded) {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
    ::close(m_errors);
    ::munmap(m_shared, sizeof(Shared));
}

std::optional<Outcome> ChildRun::ended() {
    int status = 0;
    if (::waitpid(m_process, &status, WNOHANG) == 0) return std::nullopt;
    m_hasEnded = true;
    return outcomeOf(status);
}

Outcome ChildRun::finished() {
    int status = 0;
    ::waitpid(m_process, &status, 0);
    m_hasEnded = true;
    return outcomeOf(status);
}

Outcome ChildRun::outcomeOf(int status) const {
    Outcome outcome{failuresOf(m_shared->failures.data()), m_shared->steps, m_shared->breaks, m_shared->splits,
                    m_shared->agreement};
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return outcome;
    const bool isHang = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
    std::array<char, 512> errors{};
    const ssize_t size = ::pread(m_errors, errors.data(), errors.size() - 1, 0);
    std::string text = isHang ? "more than " + std::to_string(kSeconds) + " s"
                              : std::string(WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status)) : "it exits");
    if (size > 0) text += ": " + withoutSourceFolder({errors.data(), std::strcspn(errors.data(), "\n")});
    outcome.failures.push_back({isHang ? kHang : kCrash, outcome.steps + 1, "", text});
    return outcome;
}

}  // namespace rubble::soak
