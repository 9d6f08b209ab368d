#pragma once

#include "core/play/session/SavedSession.h"

#include <string>
#include <vector>

namespace rubble {

/// The result of an expectation.
struct ExpectationOutcome {
    bool isMet = false;
    std::string expected;    // "front 4.1" breaks
    std::string seen;        // it broke at step 47 (0.783 s)
    std::uint64_t step = 0;  // after which it was decided
};

struct PlayTestOutcome {
    Id test = 0;
    std::string name;
    std::uint64_t steps = 0;                       // played
    std::vector<ExpectationOutcome> expectations;  // in the test's order
    ContentHash hash;                              // after the last step
    bool isPassed() const;
    /// The step after which the first of the failed expectations, in the test's order, was decided; 0 if none failed.
    std::uint64_t failedAt() const;
};

/// What a test does, from `first` steps on in steps of dt seconds: removals, then shots. Ascending step.
std::vector<TimedInput> inputsOf(const Project& project, const PlayTest& test, std::uint64_t first, double dt);

/// A session at the start of a test, with its shots pending: at the scene's own, or at a saved moment, from which the
/// times of the shots count then.
///
/// Errors: those of Session::start(), resumedSession() and Session::add().
Result<Session> sessionOf(std::shared_ptr<const PlayScene> scene, const PlayTest& test,
                          const SessionSettings& settings = {}, const SavedSession* start = nullptr);

/// Plays a test of the scene's project, one step at least, and evaluates its expectations. With a saved moment it
/// starts there, and what happened before does not count; steps are those of the session.
///
/// A bonded instance breaks where its first bonds break, and each body that comes off it counts as a fragment.
/// StandsUntouched: within `value` seconds the instance, or any instance, neither moves more than 1 cm nor breaks; not
/// met by a test that ends before.
/// Breaks, DoesNotBreak: the instance, or any instance. BreaksIntoAtLeast: its fragments at the end, removed ones
/// included; without an instance, those of the one with the most. NothingAbove, NothingFaster: at the end, of all
/// bodies that are not fixed, or of the instance and its fragments. StaysUp: how much of the mass that stood at the
/// start, removed parts not counted, does not stand at the end, see standingParts(); without an instance, of the one
/// that lost most; not met where nothing stood. HoleAtMost: see holeWidth(), at the end; without an instance, the
/// widest; not met without an instance that breaks along bonds.
///
/// Errors: those of sessionOf(); Cancelled.
Result<PlayTestOutcome> runPlayTest(std::shared_ptr<const PlayScene> scene, const PlayTest& test,
                                    const SessionSettings& settings = {}, const TaskContext& task = {},
                                    const SavedSession* start = nullptr);

}  // namespace rubble
