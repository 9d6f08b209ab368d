#pragma once

#include "tests/soak/SoakCase.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rubble::soak {

/// A promise that was broken first in this step.
struct Failure {
    std::string invariant;
    std::uint64_t step = 0;  // steps done
    std::string body;        // its name; empty: none
    std::string text;
};

/// What playing a case showed.
struct Outcome {
    std::vector<Failure> failures;  // the first of each invariant
    std::uint64_t steps = 0;
    std::uint64_t breaks = 0;
    std::uint64_t splits = 0;
    std::optional<double> agreement{};  // frameRateAgreement(); only where all invariants are checked
};

/// Plays a case and checks everything that must hold. `progress` is called before each step, with what was found so
/// far. Only for `invariant` if one is named, and no longer than until that fails.
Outcome playedCase(const SoakCase& one, const std::string& invariant = {},
                   const std::function<void(const Outcome&)>& progress = {});

/// The names of the promises that playing checks beside invariants().
inline constexpr const char* kSameState = "same state";    // on other threads and lanes, after loading and rewinding
inline constexpr const char* kSavedState = "saved state";  // what was saved can be loaded
inline constexpr const char* kPlayable = "playable";       // the scene can be played

}  // namespace rubble::soak
