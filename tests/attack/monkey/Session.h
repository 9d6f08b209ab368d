#pragma once

#include "core/base/Random.h"
#include "tests/attack/monkey/Editor.h"
#include "tests/attack/monkey/Journal.h"

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <string>

namespace rubble::attack {

struct MonkeyFigures {
    std::uint64_t kills = 0;
    std::uint64_t events = 0;
    std::uint64_t changes = 0;
    std::uint64_t unsaved = 0;               // kills while there were unsaved changes
    std::uint64_t due = 0;                   // kills while changes had to be in a backup
    std::uint64_t offeredWithStartPage = 0;  // kills after which a backup was offered
    std::uint64_t offeredWithProject = 0;
    double oldestLost = 0.0;    // s, from the oldest change that was lost to the kill
    double longestPause = 0.0;  // s, between two runs of the event loop
};

struct SessionOptions {
    std::filesystem::path project;
    std::uint64_t seed = 1;
    std::uint64_t number = 0;
    std::uint64_t kills = 5;
    std::uint64_t events = 0;  // without kills
};

/// A project that the monkey edits. The editor is killed again and again, and each time started in both ways: with the
/// project and with the start page. It must offer what was not saved, and keep offering it until it is saved.
class Session {
public:
    Session(const SessionOptions& options, const std::filesystem::path& folder, MonkeyFigures& figures);

    /// Kills the editor at random moments. Returns false after the first broken promise, which is printed.
    bool runWithKills();
    /// Lets the editor make its events and close. Returns false after the first broken promise.
    bool runToTheEnd();

private:
    using Hashes = std::map<std::string, std::string>;  // of the projects in the folder, by path

    /// A process with an editor.
    struct Run {
        pid_t process = 0;
        std::filesystem::path journal;
        Hashes before;
    };
    /// An editor that was killed, and what it left.
    struct Killed {
        std::filesystem::path path;  // of the journal
        Journal journal;
        double time = 0.0;
        Hashes files;
    };

    void prepareFolder();
    Run start(bool opensProject, std::uint64_t events);
    bool waitFor(const Run& run, bool Journal::*goal, std::size_t events = 0);
    static void end(const Run& run);
    bool killWhileEditing(const Run& run);
    bool checkFiles(const Run& run) const;
    bool checkRestored(const Run& run, bool opensProject);
    Hashes projectHashes() const;
    bool fail(const std::string& fault, const std::filesystem::path& journal) const;

    const SessionOptions& m_options;
    SessionFolder m_folder;
    MonkeyFigures& m_figures;
    Random m_random;
    int m_runs = 0;
    Killed m_killed;  // the last editor that was killed while it was used
};

}  // namespace rubble::attack
