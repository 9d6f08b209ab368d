#include "tests/soak/ChildProcess.h"
#include "tests/soak/NewProcess.h"
#include "tests/soak/Shrink.h"
#include "tests/support/ProgramOptions.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <numeric>
#include <set>

namespace {

using namespace rubble::soak;
using rubble::Result;
using rubble::test::failWith;
using rubble::test::ProgramOptions;

constexpr const char* kUsage =
    R"(usage: soak [--seed S] [--scenes N] [--minutes M] [--jobs J] [--only INVARIANT] [--keep FOLDER] [--shrink N]
            [--corpus FOLDER] [--known FILE] [--show SEED|FILE]

Plays random scenes with random inputs, and checks after every step what must always hold. Prints what does not, with
the seed. Exits with 1 if anything did not hold.

  --seed S        The seed of the first scene; the others follow (default: 1)
  --scenes N      So many scenes (default: 200)
  --minutes M     For so long instead
  --jobs J        Processes at a time (default: 1)
  --only NAME     Check this invariant only
  --keep FOLDER   Shrink the first failure of each invariant, and save it in FOLDER
  --shrink N      So many of each invariant instead of one
  --corpus FOLDER First play what was saved in FOLDER
  --known FILE    Failures to be mended, which FILE lists with how many scenes have them, are no error
  --show WHAT     Play the scene of a seed, or a *.soak file, in this process, and print all that fails
  --play-on FILE  Load a *.soak file and the state beside it, and print the hashes of each step: what this program
                  itself calls to compare them
  --threads N     With so many threads (default: 1)
)";

struct Options {
    std::uint64_t seed = 1;
    std::uint64_t scenes = 200;
    double minutes = 0.0;
    std::size_t jobs = 1;
    std::string only;
    std::filesystem::path keep;
    std::uint64_t shrunk = 1;
    std::filesystem::path corpus;
    std::filesystem::path known;
    std::string show;
    std::filesystem::path playedOn;
    int threads = 1;
};

Options optionsOf(int argumentCount, char** arguments) {
    Options options;
    ProgramOptions(kUsage)
        .value("--seed", options.seed)
        .value("--scenes", options.scenes)
        .value("--minutes", options.minutes)
        .value("--jobs", options.jobs)
        .value("--only", options.only)
        .value("--keep", options.keep)
        .value("--shrink", options.shrunk)
        .value("--corpus", options.corpus)
        .value("--known", options.known)
        .value("--show", options.show)
        .value(kPlayOnOption, options.playedOn)
        .value(kThreadsOption, options.threads)
        .read(argumentCount, arguments);
    options.jobs = std::max<std::size_t>(1, options.jobs);
    return options;
}

void print(const std::string& what, const Failure& one) {
    std::printf("%s: %s, step %llu%s%s: %s\n", what.c_str(), one.invariant.c_str(),
                static_cast<unsigned long long>(one.step), one.body.empty() ? "" : ", ", one.body.c_str(),
                one.text.c_str());
    std::fflush(stdout);
}

SoakCase loaded(const std::filesystem::path& file) {
    Result<SoakCase> one = loadCase(file);
    if (!one) failWith(one.error().message);
    return std::move(*one);
}

/// Plays one case in this process, for a debugger.
int show(const std::string& what, const std::string& only) {
    const bool isFile = what.ends_with(".soak");
    const SoakCase one = isFile ? loaded(what) : generatedCase(std::strtoull(what.c_str(), nullptr, 10));
    const Outcome outcome = playedCase(one, only);
    for (const Failure& failure : outcome.failures) print(what, failure);
    if (outcome.agreement) std::printf("%.3f of the bonds break at 60 and at 240 steps a second\n", *outcome.agreement);
    std::printf("%llu steps of %g s, %llu breaks, %llu splits\n", static_cast<unsigned long long>(outcome.steps),
                one.dt, static_cast<unsigned long long>(outcome.breaks),
                static_cast<unsigned long long>(outcome.splits));
    return outcome.failures.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// Failures that are known: how many of the scenes have each, by invariant, and which saved scenes fail.
struct KnownFailures {
    std::map<std::string, std::uint64_t> scenes;
    std::set<std::string> saved;
};

/// Reads lines of "scenes COUNT INVARIANT" and "saved NAME"; others are comments.
KnownFailures knownFailures(const std::filesystem::path& path) {
    KnownFailures known;
    std::ifstream file(path);
    if (!path.empty() && !file) failWith("Cannot read " + path.string() + ".");
    for (std::string word; file >> word;) {
        if (word == "scenes") {
            std::uint64_t count = 0;
            file >> count >> std::ws;
            std::getline(file, word);
            known.scenes[word] = count;
        } else if (word == "saved") {
            file >> word;
            known.saved.insert(word);
        } else {
            std::getline(file, word);
        }
    }
    return known;
}

/// Plays what was saved. Returns the number of those that fail, less those that are known to.
int brokenOfCorpus(const Options& options, const KnownFailures& known) {
    int failed = 0;
    int broken = 0;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(options.corpus)) {
        if (entry.path().extension() == ".soak") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
        const SoakCase one = loaded(file);
        const Outcome outcome = ChildRun(one, options.only).finished();
        for (const Failure& failure : outcome.failures) print(file.string(), failure);
        if (outcome.failures.empty()) continue;
        ++failed;
        broken += known.saved.contains(file.filename().string()) ? 0 : 1;
    }
    std::printf("%zu saved scenes, %d fail, %d of them are not known to\n", files.size(), failed, broken);
    return broken;
}

/// Plays the scenes of many seeds, several at a time.
class Campaign {
public:
    explicit Campaign(const Options& options) : m_options(options), m_next(options.seed) {}

    /// Returns whether no more scenes fail in any way than are known to.
    bool run(const KnownFailures& known) {
        m_start = std::chrono::steady_clock::now();
        while (startMore() || !m_running.empty()) {
            std::erase_if(m_running, [&](Running& one) { return collect(one); });
            ::poll(nullptr, 0, 2);  // ms
        }
        printFigures();
        bool isAsKnown = isFrameRateIndependent();
        for (const auto& [name, count] : m_found) {
            const auto most = known.scenes.find(name);
            if (count <= (most != known.scenes.end() ? most->second : 0)) continue;
            isAsKnown = false;
            std::printf("More scenes than are known to fail: %s\n", name.c_str());
        }
        return isAsKnown;
    }

private:
    struct Running {
        std::uint64_t seed = 0;
        SoakCase one;
        std::unique_ptr<ChildRun> child;
    };

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }
    bool isOver() const {
        return m_options.minutes > 0.0 ? seconds() > 60.0 * m_options.minutes
                                       : m_next >= m_options.seed + m_options.scenes;
    }
    /// Whether another one was started.
    bool startMore() {
        if (isOver() || m_running.size() >= m_options.jobs) return false;
        Running next{m_next, generatedCase(m_next), nullptr};
        next.child = std::make_unique<ChildRun>(next.one, m_options.only);
        m_running.push_back(std::move(next));
        ++m_next;
        return true;
    }

    /// Whether it has ended.
    bool collect(Running& one) {
        const std::optional<Outcome> outcome = one.child->ended();
        if (!outcome) return false;
        m_steps += outcome->steps;
        m_breaks += outcome->breaks;
        m_splits += outcome->splits;
        m_failed += outcome->failures.empty() ? 0 : 1;
        if (outcome->agreement) m_agreements.push_back(*outcome->agreement);
        for (const Failure& failure : outcome->failures) {
            print("--show " + std::to_string(one.seed), failure);
            const std::uint64_t count = ++m_found[failure.invariant];
            if (!m_options.keep.empty() && count <= m_options.shrunk) keep(one, failure);
        }
        return true;
    }

    void keep(const Running& one, const Failure& failure) {
        const ShrunkCase shrunk = shrunkCase(one.one, failure);
        std::string name = failure.invariant + "-" + std::to_string(one.seed);
        std::ranges::replace(name, ' ', '-');
        std::filesystem::create_directories(m_options.keep);
        const std::filesystem::path file = m_options.keep / (name + ".soak");
        const rubble::Status saved = saveCase(file, shrunk.one, shrunk.failure.invariant + ": " + shrunk.failure.text);
        if (!saved) std::printf("  %s\n", saved.error().message.c_str());
        print("  saved as --show " + file.string(), shrunk.failure);
    }

    /// Prints how often throws break the same bonds at two frame rates. True if often enough, or too few were thrown.
    bool isFrameRateIndependent() const {
        constexpr double kEqual = 0.95, kMinFraction = 0.95, kMinMean = 0.97;
        constexpr std::size_t kFewest = 50;
        if (m_agreements.empty()) return true;
        const auto throws = static_cast<double>(m_agreements.size());
        const auto isEqual = [&](double agreement) { return agreement >= kEqual; };
        const double fraction = static_cast<double>(std::ranges::count_if(m_agreements, isEqual)) / throws;
        const double mean = std::accumulate(m_agreements.begin(), m_agreements.end(), 0.0) / throws;
        std::printf(
            "%.1f %% of %.0f throws break the same bonds at 60 and at 240 steps a second, %.3f of them in the "
            "mean\n",
            100.0 * fraction, throws, mean);
        return m_agreements.size() < kFewest || (fraction >= kMinFraction && mean >= kMinMean);
    }

    void printFigures() const {
        std::printf("%llu scenes, %llu steps, %llu breaks, %llu splits in %.0f s; %llu scenes fail\n",
                    static_cast<unsigned long long>(m_next - m_options.seed), static_cast<unsigned long long>(m_steps),
                    static_cast<unsigned long long>(m_breaks), static_cast<unsigned long long>(m_splits), seconds(),
                    static_cast<unsigned long long>(m_failed));
        for (const auto& [name, count] : m_found) {
            std::printf("  %s: %llu\n", name.c_str(), static_cast<unsigned long long>(count));
        }
    }

    const Options& m_options;
    std::uint64_t m_next;
    std::vector<Running> m_running;
    std::chrono::steady_clock::time_point m_start;
    std::uint64_t m_steps = 0;
    std::uint64_t m_breaks = 0;
    std::uint64_t m_splits = 0;
    std::uint64_t m_failed = 0;
    std::vector<double> m_agreements;              // of the throws at two frame rates
    std::map<std::string, std::uint64_t> m_found;  // by invariant
};

}  // namespace

int main(int argumentCount, char** arguments) {
    const Options options = optionsOf(argumentCount, arguments);
    if (!options.playedOn.empty()) return playOn(options.playedOn, options.threads);
    if (!options.show.empty()) return show(options.show, options.only);
    const KnownFailures known = knownFailures(options.known);
    const int broken = options.corpus.empty() ? 0 : brokenOfCorpus(options, known);
    const bool isAsKnown = Campaign(options).run(known);
    return broken == 0 && isAsKnown ? EXIT_SUCCESS : EXIT_FAILURE;
}
