#pragma once

#include "editor/play/PlayEvent.h"

#include <span>

namespace rubble {

/// What has broken in some events.
struct BreakCounts {
    std::uint64_t breaks = 0;     // of bodies into fragments
    std::uint64_t fragments = 0;  // of these
    std::uint64_t bonds = 0;      // of bonded bodies
    bool operator==(const BreakCounts&) const = default;
};
BreakCounts countsOf(std::span<const EventRef> breaks);

/// The events of one course of a session, by ascending step. Copies share the steps: branches cost little.
class EventCourse {
public:
    /// Steps in which something happened.
    const std::vector<std::shared_ptr<const LoggedStep>>& steps() const { return m_steps; }
    std::size_t size() const { return m_size; }
    /// The breaks up to a step, all by default.
    std::span<const EventRef> breaks() const { return m_breaks; }
    std::span<const EventRef> breaks(std::uint64_t last) const;
    /// What is not listed one by one, by kind.
    const std::array<OmittedEvents, kEventKinds>& omitted() const { return m_omitted; }
    /// J: what contacts took without an impact that is listed or counted.
    double restEnergy() const { return m_restEnergy; }
    /// What the session reported of a step.
    static EventReport reportOf(const LoggedStep& step);

    /// Appends a later step.
    void append(std::shared_ptr<const LoggedStep> step);
    /// Discards what happened after this step.
    void discardAfter(std::uint64_t step);

private:
    void count(const LoggedStep& step);

    std::vector<std::shared_ptr<const LoggedStep>> m_steps;
    std::vector<EventRef> m_breaks;
    std::size_t m_size = 0;
    std::array<OmittedEvents, kEventKinds> m_omitted{};
    double m_restEnergy = 0.0;
};

}  // namespace rubble
