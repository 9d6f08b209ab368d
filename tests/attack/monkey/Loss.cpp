#include "tests/attack/monkey/Loss.h"

#include <algorithm>

namespace rubble::attack {
namespace {

constexpr double kTimerTolerance = 1.05;  // of Qt::CoarseTimer
constexpr std::ptrdiff_t kBeatsToWrite = 2;

/// The longest interval from a change to its backup that was set at a time or later; none if backups were disabled.
std::optional<int> longestIntervalFrom(const Journal& journal, double time) {
    int longest = 0;
    for (std::size_t k = 0; k < journal.intervals.size(); ++k) {
        const bool isReplaced = k + 1 < journal.intervals.size() && journal.intervals[k + 1].time < time;
        if (isReplaced) continue;
        if (journal.intervals[k].seconds == 0) return std::nullopt;
        longest = std::max(longest, journal.intervals[k].seconds);
    }
    return longest;
}

bool isBackupDue(const Journal& journal, double change) {
    const std::optional<int> interval = longestIntervalFrom(journal, change);
    if (!interval) return false;
    const auto after = std::ranges::lower_bound(journal.idleBeats, change + kTimerTolerance * *interval);
    return journal.idleBeats.end() - after >= kBeatsToWrite;
}

}  // namespace

std::optional<Loss> lossOf(const Journal& journal, const JournaledDocument& document,
                           const std::set<std::string>& recovered) {
    if (document.isClosed || document.isReplaced) return std::nullopt;
    const std::vector<DocumentState>& states = document.states;
    const auto isKept = [&](const DocumentState& state) {
        return recovered.contains(state.hash) || (!state.isModified && state.path.empty());
    };
    const auto firstLost = std::find_if(states.rbegin(), states.rend(), isKept).base();
    if (firstLost == states.end()) return std::nullopt;
    const bool wasRestored = static_cast<std::size_t>(firstLost - states.begin()) < document.restored;
    return Loss{.since = firstLost->time, .isDue = wasRestored || isBackupDue(journal, firstLost->time)};
}

bool hasUnsavedWork(const JournaledDocument& document) {
    return !document.isClosed && !document.states.empty() && document.states.back().isModified;
}

double longestPause(const Journal& journal) {
    double longest = 0.0;
    for (std::size_t k = 1; k < journal.beats.size(); ++k) {
        longest = std::max(longest, journal.beats[k] - journal.beats[k - 1]);
    }
    return longest;
}

}  // namespace rubble::attack
