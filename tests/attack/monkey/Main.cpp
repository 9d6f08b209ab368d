// The editor under random input, and killed at random moments: see docs/security.md.
#include "tests/attack/monkey/Session.h"
#include "tests/support/ProgramOptions.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace rubble::attack;
using rubble::test::failWith;
using rubble::test::ProgramOptions;

constexpr const char* kUsage = R"(usage: monkey --kills N   [--seed N] [--session N] [--project FILE] [--folder FOLDER]
       monkey --events N  [--seed N] [--session N] [--project FILE] [--folder FOLDER]

Uses the editor at random on a copy of a project, in a folder of its own, the only one that it can write to.
With --kills
it is killed (SIGKILL) at N random moments, five a session. Each time the projects must be whole, both ways of starting
the editor must offer what was not saved, and nothing older than the interval of the backups may be lost. With --events
it ends after N events, and must leave nothing behind. Exits with 1 if a promise is broken, and with 77 where the kernel
lacks Landlock. Needs a display.

  --session N        Begin with session N, to repeat a finding
  --project FILE     The project (default: one of the examples)
  --folder FOLDER    Keep the files and journals of the sessions there
)";
constexpr std::uint64_t kKillsInSession = 5;

struct MonkeyOptions {
    SessionOptions session;
    std::uint64_t kills = 0;
    std::filesystem::path folder;
};

MonkeyOptions optionsOf(int argumentCount, char** arguments) {
    MonkeyOptions options;
    ProgramOptions(kUsage)
        .value("--kills", options.kills)
        .value("--events", options.session.events)
        .value("--seed", options.session.seed)
        .value("--session", options.session.number)
        .value("--project", options.session.project)
        .value("--folder", options.folder)
        .read(argumentCount, arguments);
    if ((options.kills == 0) == (options.session.events == 0)) failWith(kUsage);
    if (!options.folder.empty()) options.folder = std::filesystem::absolute(options.folder);
    return options;
}

/// The arguments of Session::start(). The editor does not outlive this program's parent.
int runEditorWith(char** arguments) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return runEditor({.folder = {arguments[2]},
                      .journal = arguments[3],
                      .opensProject = arguments[4] == std::string("1"),
                      .seed = std::strtoull(arguments[5], nullptr, 10),
                      .events = std::strtoull(arguments[6], nullptr, 10)});
}

void print(const MonkeyFigures& figures) {
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::printf("%llu kills, %llu events, %llu changes, longest pause of the event loop %.2f s\n",
                number(figures.kills), number(figures.events), number(figures.changes), figures.longestPause);
    if (figures.kills == 0) return;
    std::printf(
        "unsaved work at %llu kills, older than the interval at %llu; a backup was offered with the start page after "
        "%llu, with the project after %llu; oldest lost work %.2f s\n",
        number(figures.unsaved), number(figures.due), number(figures.offeredWithStartPage),
        number(figures.offeredWithProject), figures.oldestLost);
}

}  // namespace

int main(int argumentCount, char** arguments) {
    constexpr int kEditorArguments = 7;
    if (argumentCount == kEditorArguments && arguments[1] == std::string("--editor")) return runEditorWith(arguments);
    MonkeyOptions options = optionsOf(argumentCount, arguments);
    const std::filesystem::path folder = options.folder.empty() ? std::filesystem::temp_directory_path() /
                                                                      ("rubble-monkey-" + std::to_string(::getpid()))
                                                                : options.folder;
    std::printf("seed %llu\n", static_cast<unsigned long long>(options.session.seed));
    std::fflush(stdout);
    MonkeyFigures figures;
    bool isWhole = true;
    do {
        options.session.kills = std::min(kKillsInSession, options.kills - figures.kills);
        Session session(options.session, folder / std::to_string(options.session.number), figures);
        isWhole = options.kills == 0 ? session.runToTheEnd() : session.runWithKills();
        ++options.session.number;
    } while (isWhole && figures.kills < options.kills);
    print(figures);
    if (isWhole && options.folder.empty()) std::filesystem::remove_all(folder);
    return isWhole ? EXIT_SUCCESS : EXIT_FAILURE;
}
