#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rubble::attack {

/// The folder of a session: the only one that the editor may write to.
struct SessionFolder {
    std::filesystem::path root;

    std::filesystem::path files() const { return root / "files"; }
    std::filesystem::path project() const { return files() / "original.rubble"; }
    std::filesystem::path backups() const { return root / "data/Rubble/Rubble/backups"; }
    std::filesystem::path settings() const { return root / "config/Rubble/Rubble.conf"; }
};

/// How the editor is started and used in a process of its own.
struct EditorRun {
    SessionFolder folder;
    std::filesystem::path journal;
    bool opensProject = false;  // as "rubble FILE"; otherwise it shows the start page
    std::uint64_t seed = 1;
    std::uint64_t events = 0;  // then it closes; 0: it waits until it is killed
};

/// The exit code of an editor that cannot be confined to its folder.
inline constexpr int kCannotConfine = 77;

/// Runs the editor as its program does, restores all backups that it offers, and lets the monkey use it. Returns the
/// exit code of the process.
int runEditor(const EditorRun& run);

}  // namespace rubble::attack
