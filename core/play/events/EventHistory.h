#pragma once

#include "core/play/state/PlayEvents.h"

#include <span>
#include <vector>

namespace rubble {

/// A blast that was set off before a step.
struct BlastRecord {
    std::uint64_t step = 0;  // after which its effects hold
    Blast blast;
    bool operator==(const BlastRecord&) const = default;
};

/// The impacts and breaks that the steps of a session have reported, and the blasts set off before them: for what is
/// seen for a while after it happened. A step may be added again, as after a seek; one that reports something else than
/// before begins another course, and the steps after it are forgotten.
class EventHistory {
public:
    /// Keeps 20 s of steps that report 16 events each, in less than 6 MB.
    EventHistory() = default;
    explicit EventHistory(std::size_t mostRecords) : m_mostRecords(mostRecords) {}

    /// Adds what a step reported. A step that neither is known nor follows the last one begins the history anew. The
    /// oldest steps are forgotten where there are more than the most records.
    void add(std::uint64_t step, std::span<const EventRecord> reported, std::span<const BlastRecord> blasts = {});
    /// Adds what happened in a step.
    void add(std::uint64_t step, const PlayEvents& events);
    /// The records of the steps from `first` to `last`, by step, in the order in which they were reported.
    std::span<const EventRecord> between(std::uint64_t first, std::uint64_t last) const;
    /// The blasts before the same steps, likewise.
    std::span<const BlastRecord> blastsBetween(std::uint64_t first, std::uint64_t last) const;

private:
    std::size_t m_mostRecords = 20'000;
    std::uint64_t m_first = 1, m_last = 0;  // the steps that are known; none if m_first > m_last
    std::vector<EventRecord> m_records;
    std::vector<BlastRecord> m_blasts;
};

}  // namespace rubble
