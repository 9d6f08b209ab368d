#pragma once

#include "core/play/session/Session.h"
#include "tests/soak/SoakCase.h"

#include <string>
#include <vector>

namespace rubble::soak {

/// What two simulations of the same moments have in common after a step.
struct Trace {
    ContentHash state;
    std::uint64_t events = 0;
    bool operator==(const Trace&) const = default;
};
Trace traceOf(const Session& session);

/// The option with which this program plays on, see playOn(), and that for its number of threads.
inline constexpr const char* kPlayOnOption = "--play-on";
inline constexpr const char* kThreadsOption = "--threads";

/// What each step gives in a new process, which loads a project and a state from files: no addresses, caches or threads
/// are those of the process that saved them. `state`: as stateBytes() gives it; `one` has the steps from there on, and
/// inputs whose bodies are there.
///
/// Errors: Io if the files cannot be written or the process cannot be started; BadInput, with its message, if it fails.
Result<std::vector<Trace>> tracesOfNewProcess(const SoakCase& one, const std::string& state, int threads);

/// The main function of that process: loads the case and the state beside it, and prints the traces.
int playOn(const std::filesystem::path& soakFile, int threads);

}  // namespace rubble::soak
