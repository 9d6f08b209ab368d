#pragma once

#include "tests/attack/Format.h"

#include <array>
#include <cstdint>

namespace rubble::attack {

struct CampaignOptions {
    std::uint64_t seed = 1;
    std::uint64_t first = 0;  // number of the first input
    std::uint64_t count = 10000;
    int jobs = 1;                    // processes at a time
    bool isVerbose = false;          // also prints the inputs on which an importer failed
    std::filesystem::path findings;  // the folder for inputs that break a promise; in a sub-folder for each format
};

/// How an input broke a promise.
enum class Finding { Crash, Hang, Memory, Fault };
inline constexpr std::array kFindings = {"crash", "hang", "memory", "fault"};

/// The figures of one format.
struct Figures {
    std::uint64_t inputs = 0;
    std::uint64_t accepted = 0;
    std::uint64_t played = 0;
    ImporterFigures importer;
    std::array<std::uint64_t, kFindings.size()> findings{};
    double seconds = 0.0;

    std::uint64_t broken() const { return findings[0] + findings[1] + findings[2] + findings[3]; }
};

/// The text of an input, which depends on its format, the seed and its number only.
std::string inputOf(const Format& format, std::uint64_t seed, std::uint64_t number);

/// Checks the inputs of a format in child processes, each limited to 2 GiB, and to 10 s for an input. Prints and saves
/// those that break a promise, at most 100.
Figures attacked(const Format& format, const CampaignOptions& options);

}  // namespace rubble::attack
