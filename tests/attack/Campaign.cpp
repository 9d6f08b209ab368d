#include "tests/attack/Campaign.h"

#include "core/base/Hash.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <set>

namespace rubble::attack {
namespace {

constexpr std::uint64_t kMaxBatch = 2000;    // inputs for a process
constexpr std::uint64_t kBatchesPerJob = 8;  // at least, so that all end at about the same time
constexpr int kSeconds = 10;
constexpr rlim_t kMemory = rlim_t{2} << 30;
constexpr std::uint64_t kMaxSaved = 100;
constexpr int kOutOfMemory = 77;
constexpr int kFaulty = 78;

/// What a child process reports to its parent: in shared memory, since it may crash.
struct Progress {
    std::uint64_t next = 0;  // number of the input being checked, or the end
    std::uint64_t accepted = 0;
    std::uint64_t played = 0;
    ImporterFigures importer;
    std::array<char, 1024> fault{};
};

struct Batch {
    pid_t process = 0;  // 0: none
    std::uint64_t start = 0;
    std::uint64_t end = 0;
    Progress* progress = nullptr;
    std::uint64_t seen = 0;  // the input being checked when the parent last looked
    std::chrono::steady_clock::time_point since;
};

Random randomOf(const Format& format, std::uint64_t seed, std::uint64_t number) {
    return Random(mixSeeds(mixSeeds(seed, contentHash(format.name).low), number));
}

void limitProcess() {
#ifndef __SANITIZE_ADDRESS__
    const rlimit memory{kMemory, kMemory};
    ::setrlimit(RLIMIT_AS, &memory);
#endif
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    std::set_new_handler([] { std::_Exit(kOutOfMemory); });
}

/// Ends this process by SIGPROF if it computes longer on one input.
void restartTimer() {
    const itimerval limit{{0, 0}, {kSeconds, 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Prints how the input can be made again.
void printInput(const char* what, const Format& format, std::uint64_t seed, std::uint64_t number) {
    std::printf("  %s: --format %s --seed %llu --first %llu: ", what, format.name.c_str(),
                static_cast<unsigned long long>(seed), static_cast<unsigned long long>(number));
}

void printFailure(const ImporterFigures& importer) {
    std::puts(importer.crashed > 0 ? "crash" : importer.timedOut > 0 ? "time-out" : "out of memory");
    std::fflush(stdout);
}

[[noreturn]] void runBatch(const Format& format, const CampaignOptions& options, const Batch& batch) {
    limitProcess();
    Progress& progress = *batch.progress;
    for (std::uint64_t number = batch.start; number < batch.end; ++number) {
        progress.next = number;
        restartTimer();
        Random random = randomOf(format, options.seed, number);
        const std::string bytes = format.mutated(random);
        const Verdict verdict = format.check(bytes, random);
        progress.accepted += verdict.isAccepted ? 1 : 0;
        progress.played += verdict.isPlayed ? 1 : 0;
        progress.importer += verdict.importer;
        if (options.isVerbose && verdict.importer.failed() > 0) {
            printInput("contained", format, options.seed, number);
            printFailure(verdict.importer);
        }
        if (verdict.fault) {
            const std::size_t size = std::min(verdict.fault->size(), progress.fault.size() - 1);
            std::memcpy(progress.fault.data(), verdict.fault->data(), size);
            progress.fault[size] = '\0';
            std::_Exit(kFaulty);
        }
    }
    progress.next = batch.end;
    std::_Exit(0);
}

Finding findingOf(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) return Finding::Memory;
    if (WIFEXITED(status) && WEXITSTATUS(status) == kFaulty) return Finding::Fault;
    const bool isTimeout = WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGKILL);
    return isTimeout ? Finding::Hang : Finding::Crash;
}

std::string reasonOf(Finding finding, int status, const Progress& progress) {
    switch (finding) {
        case Finding::Crash:
            return WIFSIGNALED(status) ? std::string("signal ") + ::strsignal(WTERMSIG(status))
                                       : "exit status " + std::to_string(WEXITSTATUS(status));
        case Finding::Hang: return "more than " + std::to_string(kSeconds) + " s";
        case Finding::Memory: return "more than 2 GiB";
        case Finding::Fault: return progress.fault.data();
    }
    return {};
}

/// A campaign against one format.
class Attack {
public:
    Attack(const Format& format, const CampaignOptions& options)
        : m_format(format), m_options(options), m_next(options.first), m_end(options.first + options.count) {
        const auto jobs = static_cast<std::uint64_t>(std::max(1, options.jobs));
        m_batches.resize(jobs);
        m_batchSize = std::clamp<std::uint64_t>(options.count / (kBatchesPerJob * jobs), 1, kMaxBatch);
        for (Batch& batch : m_batches) {
            void* shared = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
            if (shared == MAP_FAILED) std::exit(2);
            batch.progress = new (shared) Progress;
        }
    }
    ~Attack() {
        for (const Batch& batch : m_batches) ::munmap(batch.progress, sizeof(Progress));
    }
    Attack(const Attack&) = delete;
    Attack& operator=(const Attack&) = delete;

    Figures run() {
        const auto start = std::chrono::steady_clock::now();
        for (Batch& batch : m_batches) startNext(batch);
        const auto isRunning = [](const Batch& batch) { return batch.process != 0; };
        while (std::ranges::any_of(m_batches, isRunning)) {
            for (Batch& batch : m_batches) look(batch);
            ::poll(nullptr, 0, 2);  // ms
        }
        m_figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return m_figures;
    }

private:
    void startNext(Batch& batch) {
        batch.process = 0;
        if (batch.start == batch.end) {
            batch.start = m_next;
            batch.end = m_next = std::min(m_end, m_next + m_batchSize);
        }
        if (batch.start == batch.end || m_figures.broken() >= kMaxSaved) return;
        *batch.progress = {.next = batch.start};
        batch.seen = batch.start;
        batch.since = std::chrono::steady_clock::now();
        std::fflush(nullptr);
        batch.process = ::fork();
        if (batch.process == 0) runBatch(m_format, m_options, batch);
        if (batch.process < 0) std::exit(2);
    }

    /// Collects a process that ended; ends one that waits for something that does not come.
    void look(Batch& batch) {
        constexpr std::chrono::seconds kLongestWait(120);  // on the clock: the machine may be busy
        if (batch.process == 0) return;
        int status = 0;
        if (::waitpid(batch.process, &status, WNOHANG) == 0) {
            const auto now = std::chrono::steady_clock::now();
            if (batch.progress->next != batch.seen) {
                batch.seen = batch.progress->next;
                batch.since = now;
            }
            if (now - batch.since > kLongestWait) ::kill(batch.process, SIGKILL);
            return;
        }
        const Progress& progress = *batch.progress;
        m_figures.accepted += progress.accepted;
        m_figures.played += progress.played;
        m_figures.importer += progress.importer;
        m_figures.inputs += progress.next - batch.start;
        batch.start = progress.next;
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
            report(findingOf(status), status, progress);
            ++m_figures.inputs;
            ++batch.start;
        }
        startNext(batch);
    }

    /// Prints a finding, and saves its input unless one of the same reason was saved.
    void report(Finding finding, int status, const Progress& progress) {
        ++m_figures.findings[static_cast<std::size_t>(finding)];
        const std::string reason = reasonOf(finding, status, progress);
        printInput("found", m_format, m_options.seed, progress.next);
        std::printf("%s: %s\n", kFindings[static_cast<std::size_t>(finding)], reason.c_str());
        if (m_options.findings.empty()) return;
        if (finding == Finding::Fault && !m_reasons.insert(reason.substr(0, 40)).second) return;
        const std::string bytes = inputOf(m_format, m_options.seed, progress.next);
        const std::filesystem::path folder = m_options.findings / m_format.name;
        std::filesystem::create_directories(folder);
        std::ofstream(folder / ("found-" + contentHash(bytes).hex().substr(16) + m_format.ending), std::ios::binary)
            << bytes;
    }

    const Format& m_format;
    const CampaignOptions& m_options;
    std::uint64_t m_next;
    std::uint64_t m_end;
    std::vector<Batch> m_batches;
    std::uint64_t m_batchSize = 1;
    Figures m_figures;
    std::set<std::string> m_reasons;
};

}  // namespace

ImporterFigures& ImporterFigures::operator+=(const ImporterFigures& other) {
    crashed += other.crashed;
    timedOut += other.timedOut;
    outOfMemory += other.outOfMemory;
    opened += other.opened;
    refused += other.refused;
    return *this;
}

std::string inputOf(const Format& format, std::uint64_t seed, std::uint64_t number) {
    Random random = randomOf(format, seed, number);
    return format.mutated(random);
}

Figures attacked(const Format& format, const CampaignOptions& options) { return Attack(format, options).run(); }

}  // namespace rubble::attack
