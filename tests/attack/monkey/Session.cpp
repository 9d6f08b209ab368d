#include "tests/attack/monkey/Session.h"

#include "core/base/Hash.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/attack/monkey/Loss.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace rubble::attack {
namespace {

constexpr std::uint64_t kMaxEvents = 400;  // before a kill
constexpr double kLongestDelay = 0.05;     // s from the event before the kill
constexpr std::uint64_t kForever = std::uint64_t{1} << 40U;
// Without a line in the journal, which has 50 a second: the editor hangs.
constexpr double kLongestComputation = 120.0;  // s of processor time
constexpr double kLongestSilence = 1200.0;     // s on the clock: the machine may be busy
constexpr int kAutosaveSeconds = 1;
constexpr std::size_t kShownEvents = 15;
constexpr std::size_t kShownOutput = 4000;  // bytes

const std::string kSource = RUBBLE_SOURCE_DIR;

/// Waits between two looks at the journal, or until a random moment for a kill.
void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));  // between two looks
}

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The environment of an editor that keeps everything in its folder.
std::vector<std::string> environmentIn(const SessionFolder& folder) {
    const std::map<std::string, std::string> set = {{"HOME", folder.root / "home"},
                                                    {"XDG_CONFIG_HOME", folder.root / "config"},
                                                    {"XDG_DATA_HOME", folder.root / "data"},
                                                    {"XDG_CACHE_HOME", folder.root / "cache"},
                                                    {"XDG_RUNTIME_DIR", folder.root / "run"},
                                                    {"TMPDIR", folder.root / "tmp"},
                                                    {"LC_ALL", "C.UTF-8"},
                                                    {"DBUS_SESSION_BUS_ADDRESS", "disabled:"}};
    std::vector<std::string> environment;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string text = *variable;
        if (!set.contains(text.substr(0, text.find('=')))) environment.push_back(text);
    }
    for (const auto& [name, value] : set) environment.push_back(name + '=' + value);
    return environment;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Every content that a project file may have: it was there before, was saved, or was just being saved.
bool isKnownContent(const std::string& path, const std::string& hash, const Journal& journal,
                    const std::map<std::string, std::string>& before) {
    if (const auto found = before.find(path); found != before.end() && found->second == hash) return true;
    return std::ranges::any_of(journal.documents, [&](const auto& entry) {
        const std::vector<DocumentState>& states = entry.second.states;
        const auto wasSaved = [&](const DocumentState& state) {
            return !state.isModified && state.path == path && state.hash == hash;
        };
        return std::ranges::any_of(states, wasSaved) || (!states.empty() && states.back().hash == hash);
    });
}

std::set<std::string> hashesOf(const std::map<std::string, std::string>& files) {
    std::set<std::string> hashes;
    for (const auto& [path, hash] : files) hashes.insert(hash);
    return hashes;
}

bool wasEver(const DocumentState& wanted, const Journal& journal) {
    return std::ranges::any_of(journal.documents, [&](const auto& entry) {
        return std::ranges::any_of(entry.second.states, [&](const DocumentState& state) {
            return state.hash == wanted.hash && state.path == wanted.path;
        });
    });
}

/// Of a process, in all of its threads, s.
double processorTime(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How long an editor has written nothing to its journal.
class Silence {
public:
    bool isTooLong(pid_t process, const std::filesystem::path& journal) {
        std::error_code ignored;
        const std::uintmax_t size = std::filesystem::file_size(journal, ignored);
        if (std::exchange(m_size, size) != size) {
            m_since = monotonicTime();
            m_computedBefore = processorTime(process);
        }
        return monotonicTime() - m_since > kLongestSilence ||
               processorTime(process) - m_computedBefore > kLongestComputation;
    }

private:
    std::uintmax_t m_size = 0;
    double m_since = monotonicTime();
    double m_computedBefore = 0.0;
};

std::string endText(int status) {
    if (WIFSIGNALED(status)) return std::string("The editor crashed: ") + ::strsignal(WTERMSIG(status)) + '.';
    return "The editor ended with exit code " + std::to_string(WEXITSTATUS(status)) + '.';
}

}  // namespace

Session::Session(const SessionOptions& options, const std::filesystem::path& folder, MonkeyFigures& figures)
    : m_options(options), m_folder{folder}, m_figures(figures), m_random(mixSeeds(options.seed, options.number)) {
    prepareFolder();
}

void Session::prepareFolder() {
    namespace fs = std::filesystem;
    for (const char* name : {"home", "config/Rubble", "data", "cache", "run", "tmp", "files"}) {
        fs::create_directories(m_folder.root / name);
    }
    fs::permissions(m_folder.root / "run", fs::perms::owner_all);
    const char* const projects[] = {"wall-with-openings.rubble", "pane.rubble", "house.rubble"};
    const fs::path drawn = fs::path(kSource) / "projects" / projects[m_random.below(std::size(projects))];
    fs::copy_file(m_options.project.empty() ? drawn : m_options.project, m_folder.project());
    for (const char* name : {"projects/pane.rubble", "tests/data/meshes/wall.obj", "tests/data/meshes/wall.mtl",
                             "tests/data/meshes/gable.ply", "resources/linux/icons/io.github.rubble.Rubble-64.png"}) {
        const fs::path file = fs::path(kSource) / name;
        fs::copy_file(file, m_folder.files() / file.filename());
    }
    // What draws fast, since most of the time is spent with drawing.
    std::ofstream(m_folder.settings()) << "[preferences]\nautosaveSeconds=" << kAutosaveSeconds
                                       << "\nsoftLight=never\nmsaa=1\n";
}

Session::Run Session::start(bool opensProject, std::uint64_t events) {
    const std::string name = "run-" + std::to_string(++m_runs);
    Run run{.journal = m_folder.root / (name + ".journal"), .before = projectHashes()};
    const std::filesystem::path output = m_folder.root / (name + ".txt");
    const std::uint64_t seed = mixSeeds(mixSeeds(m_options.seed, m_options.number), static_cast<std::uint64_t>(m_runs));
    std::vector<std::string> arguments = {"monkey",
                                          "--editor",
                                          m_folder.root,
                                          run.journal,
                                          opensProject ? "1" : "0",
                                          std::to_string(seed),
                                          std::to_string(events)};
    std::vector<std::string> environment = environmentIn(m_folder);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    const int error = ::posix_spawn(&run.process, program.c_str(), &actions, nullptr, pointersTo(arguments).data(),
                                    pointersTo(environment).data());
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        std::fprintf(stderr, "Cannot start the editor: %s\n", std::strerror(error));
        std::exit(2);
    }
    return run;
}

/// Waits until the journal is ready or done and has so many events; false if the editor ended otherwise or hangs.
bool Session::waitFor(const Run& run, bool Journal::*goal, std::size_t events) {
    Silence silence;
    while (true) {
        int status = 0;
        const bool hasEnded = ::waitpid(run.process, &status, WNOHANG) == run.process;
        const Journal journal = readJournal(run.journal);
        if (hasEnded && status == 0 && journal.isDone && journal.*goal) return true;
        if (hasEnded && WIFEXITED(status) && WEXITSTATUS(status) == kCannotConfine) {
            std::puts("This kernel lacks Landlock, without which random input is not let near the files of a user.");
            std::exit(kCannotConfine);
        }
        if (hasEnded) return fail(endText(status), run.journal);
        if (goal == &Journal::isReady && journal.isReady && journal.events.size() >= events) return true;
        if (silence.isTooLong(run.process, run.journal)) {
            end(run);
            return fail("The editor hangs.", run.journal);
        }
        wait(goal == &Journal::isReady ? 0.01 : 0.2);
    }
}

void Session::end(const Run& run) {
    ::kill(run.process, SIGKILL);
    ::waitpid(run.process, nullptr, 0);
}

bool Session::runToTheEnd() {
    const Run run = start(true, m_options.events);
    if (!waitFor(run, &Journal::isDone)) return false;
    const Journal journal = readJournal(run.journal);
    m_figures.events += journal.events.size();
    m_figures.changes += journal.changes;
    m_figures.longestPause = std::max(m_figures.longestPause, longestPause(journal));
    if (!std::filesystem::is_empty(m_folder.backups())) return fail("The editor left a backup behind.", run.journal);
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.files())) {
        if (entry.path().extension() == ".lock") return fail("The editor left a lock behind.", run.journal);
    }
    return true;
}

/// Each kill is followed by a start in one way, which is killed at once, and one in the other way, in which the monkey
/// goes on.
bool Session::runWithKills() {
    bool opensProject = true;
    for (std::uint64_t kill = 0; kill <= m_options.kills; ++kill) {
        const bool isLast = kill == m_options.kills;
        const Run run = start(opensProject, isLast ? 0 : kForever);
        if (!waitFor(run, &Journal::isReady)) return false;
        if (kill > 0 && !checkRestored(run, opensProject)) return false;
        if (isLast) {
            end(run);
            return true;
        }
        if (!killWhileEditing(run)) return false;
        opensProject = m_random.below(2) == 0;
        const Run other = start(!opensProject, 0);
        if (!waitFor(other, &Journal::isReady) || !checkRestored(other, !opensProject)) return false;
        end(other);
    }
    return true;
}

/// The moment is drawn in events rather than seconds, so that a busy machine edits as much as an idle one.
bool Session::killWhileEditing(const Run& run) {
    if (!waitFor(run, &Journal::isReady, m_random.below(kMaxEvents))) return false;
    wait(m_random.between(0.0, kLongestDelay));
    const double time = monotonicTime();
    end(run);
    m_killed = {.path = run.journal, .journal = readJournal(run.journal), .time = time, .files = projectHashes()};
    const Journal& journal = m_killed.journal;
    ++m_figures.kills;
    m_figures.events += journal.events.size();
    m_figures.changes += journal.changes;
    m_figures.longestPause = std::max(m_figures.longestPause, longestPause(journal));
    const std::set<std::string> saved = hashesOf(m_killed.files);
    const auto isUnsaved = [](const auto& entry) { return hasUnsavedWork(entry.second); };
    const auto needsBackup = [&](const auto& entry) {
        const std::optional<Loss> loss = lossOf(m_killed.journal, entry.second, saved);
        return loss && loss->isDue;
    };
    m_figures.unsaved += std::ranges::any_of(m_killed.journal.documents, isUnsaved) ? 1 : 0;
    m_figures.due += std::ranges::any_of(m_killed.journal.documents, needsBackup) ? 1 : 0;
    return checkFiles(run);
}

/// Every project is whole and has a content that it may have.
bool Session::checkFiles(const Run& run) const {
    for (const auto& [path, hash] : run.before) {
        if (!m_killed.files.contains(path)) return fail(path + " is gone.", run.journal);
    }
    for (const auto& [path, hash] : m_killed.files) {
        const Result<Project> project = loadProject(path);
        if (!project) return fail(project.error().message, run.journal);
        if (!isKnownContent(path, hash, m_killed.journal, run.before)) {
            return fail(path + " has a content that was never saved to it.", run.journal);
        }
    }
    return true;
}

/// What was restored was edited before the kill, and nothing that had to be in a backup is missing.
bool Session::checkRestored(const Run& run, bool opensProject) {
    const Journal restored = readJournal(run.journal);
    std::set<std::string> recovered = hashesOf(m_killed.files);
    for (const auto& [number, document] : restored.documents) {
        if (document.restored == 0) continue;
        const DocumentState& state = document.states[document.restored - 1];
        recovered.insert(state.hash);
        if (state.isModified && !wasEver(state, m_killed.journal)) {
            return fail("A backup was restored that is no state of \"" + state.path + "\".", run.journal);
        }
    }
    auto& offered = opensProject ? m_figures.offeredWithProject : m_figures.offeredWithStartPage;
    offered += restored.offers.empty() ? 0 : 1;
    double oldest = 0.0;
    for (const auto& [number, document] : m_killed.journal.documents) {
        const std::optional<Loss> loss = lossOf(m_killed.journal, document, recovered);
        if (!loss) continue;
        const double age = m_killed.time - loss->since;
        oldest = std::max(oldest, age);
        if (loss->isDue) {
            return fail("Document " + std::to_string(number) + " lost work of " + std::to_string(age) +
                            " s, which had to be in a backup.",
                        run.journal);
        }
    }
    m_figures.oldestLost = std::max(m_figures.oldestLost, oldest);
    std::printf("  session %llu, %s: %zu events, %zu changes, %zu backups offered %s, oldest lost work %.2f s\n",
                static_cast<unsigned long long>(m_options.number), m_killed.path.stem().c_str(),
                m_killed.journal.events.size(), m_killed.journal.changes, restored.offers.size(),
                opensProject ? "with the project" : "with the start page", oldest);
    std::fflush(stdout);
    return true;
}

Session::Hashes Session::projectHashes() const {
    Hashes hashes;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.files())) {
        if (entry.path().extension() != ".rubble" || entry.path().filename().string().starts_with('.')) continue;
        const Result<std::string> bytes = readFile(entry.path());
        hashes[entry.path()] = bytes ? contentHash(*bytes).hex() : std::string();
    }
    return hashes;
}

/// Prints a broken promise with what was done and printed last, and how to do it again. Returns false.
bool Session::fail(const std::string& fault, const std::filesystem::path& journal) const {
    const Journal last = readJournal(journal);
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    const bool isKilled = m_options.kills > 0;
    std::printf("  found: --%s %llu --seed %llu --session %llu: %s\n", isKilled ? "kills" : "events",
                number(isKilled ? m_options.kills : m_options.events), number(m_options.seed), number(m_options.number),
                last.fault.empty() ? fault.c_str() : last.fault.c_str());
    const std::size_t count = std::min(kShownEvents, last.events.size());
    for (auto event = last.events.end() - static_cast<std::ptrdiff_t>(count); event != last.events.end(); ++event) {
        std::printf("    %s\n", event->c_str());
    }
    const std::string output = textOf(std::filesystem::path(journal).replace_extension(".txt"));
    std::printf("%s\n  journal: %s\n", output.substr(output.size() - std::min(output.size(), kShownOutput)).c_str(),
                journal.c_str());
    std::fflush(stdout);
    return false;
}

}  // namespace rubble::attack
