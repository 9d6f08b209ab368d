#pragma once

#include "core/play/session/PlayTestRun.h"

#include <span>
#include <string>

namespace rubble {

/// The outcome of a play-test and the time it took to run.
struct TimedPlayTest {
    PlayTestOutcome outcome;
    double seconds = 0.0;
};

/// Returns the play-tests of a project as JUnit XML for build servers: a test case for each, whose failure lists the
/// expectations that were not met. `suite` is the project's name.
std::string junitXml(const std::string& suite, std::span<const TimedPlayTest> tests);

}  // namespace rubble
