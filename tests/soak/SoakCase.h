#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Result.h"
#include "core/play/scene/PlayInput.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rubble::soak {

/// A snapshot that is restored after some steps, which are then played again.
struct Rewind {
    std::uint64_t step = 0;   // after which the snapshot is taken
    std::uint64_t steps = 0;  // that are played twice
    bool operator==(const Rewind&) const = default;
};

/// A scene, how it is played and what is done to it.
///
/// The inputs name bodies by a place among those that are there, see withPresentBody(): so they mean something whatever
/// is left out of the scene.
struct SoakCase {
    Project project;
    double dt = 1.0 / 60.0;  // s
    bool isSleeping = true;
    std::uint64_t steps = 120;
    std::vector<TimedInput> inputs;    // ascending step
    std::vector<Rewind> rewinds;       // ascending, apart
    std::vector<std::uint64_t> saves;  // steps after which the state is saved, for a new process to play on
    bool isCompared = false;           // also played with other threads and lanes from the start
    bool operator==(const SoakCase&) const = default;
};

/// The case of a seed: the same on every machine.
SoakCase generatedCase(std::uint64_t seed);

/// Saves a case as NAME.rubble, its project, and NAME.soak, the rest; `note` says what it shows.
///
/// Errors: those of saveProject() and writeFileAtomically().
Status saveCase(const std::filesystem::path& soakFile, const SoakCase& one, const std::string& note);
/// Loads what saveCase() wrote, by the path of the *.soak file.
///
/// Errors: those of loadProject() and JsonDocument.
Result<SoakCase> loadCase(const std::filesystem::path& soakFile);

}  // namespace rubble::soak
