#pragma once

#include "core/play/PlayTestRun.h"

#include <span>
#include <string>

namespace rubble {

/// A play-test as it was run, and how long that took.
struct TimedPlayTest {
    PlayTestOutcome outcome;
    double seconds = 0.0;
};

/// Play-tests of one project as JUnit XML, as build servers read it: a case a test, of which a failure lists the expectations
/// that were not met. `suite` is the project's name.
std::string junitXml(const std::string& suite, std::span<const TimedPlayTest> tests);

}  // namespace rubble
