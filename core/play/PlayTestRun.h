#pragma once

#include "core/play/Session.h"

#include <string>
#include <vector>

namespace rubble {

/// What became of an expectation.
struct ExpectationOutcome {
    bool isMet = false;
    std::string expected;    // "front 4.1" breaks
    std::string seen;        // it broke at step 47 (0.783 s)
    std::uint64_t step = 0;  // after which it was decided: the moment to look at
};

struct PlayTestOutcome {
    Id test = 0;
    std::string name;
    std::uint64_t steps = 0;
    std::vector<ExpectationOutcome> expectations;  // in the test's order
    ContentHash hash;                              // after the last step
    bool isPassed() const;
    /// The moment to look at: after which step the first expectation failed; 0 where none did.
    std::uint64_t failedAt() const;
};

/// A session at its start, with the test's shots waiting.
///
/// Errors: those of Session::start() and Session::add().
Result<Session> sessionOf(std::shared_ptr<const PlayScene> scene, const PlayTest& test,
                          const SessionSettings& settings = {});

/// Plays a test of the scene's project with its shots, and says of each expectation whether it was met.
///
/// StandsUntouched: for `value` seconds no whole, or not the one named, moves more than 1 cm or breaks.
/// Breaks, DoesNotBreak: the instance, or any of them.
/// BreaksIntoAtLeast: the pieces that it is in at the end, those taken away included; of any, the one in the most.
/// NothingAbove, NothingFaster: at the end, of what is not fixed; with an instance, of it and its pieces.
///
/// Errors: those of sessionOf(); Cancelled.
Result<PlayTestOutcome> runPlayTest(std::shared_ptr<const PlayScene> scene, const PlayTest& test,
                                    const SessionSettings& settings = {}, const TaskContext& task = {});

}  // namespace rubble
