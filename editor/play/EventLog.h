#pragma once

#include "core/play/session/Session.h"
#include "editor/play/EventCourse.h"

#include <map>
#include <optional>

namespace rubble {

/// 200,000 events take about 80 MB.
inline constexpr std::size_t kMaxLoggedEvents = 200'000;

/// Records the events of one course of a session: what the session reports, all breaks, and impacts that a body
/// withstood with a tenth of its threshold or more, such as blows of a hammer, which the session does not report.
///
/// Beyond `maxEvents` only breaks are recorded; the rest is counted and summed.
class EventLog {
public:
    explicit EventLog(std::size_t maxEvents = kMaxLoggedEvents) : m_maxEvents(maxEvents) {}

    /// The number of steps recorded.
    std::uint64_t steps() const { return m_steps; }
    const EventCourse& course() const { return m_course; }

    /// Records the session's last step, which must be the next one. Returns what happened; null: nothing.
    std::shared_ptr<const LoggedStep> record(const Session& session);
    /// Discards what happened after this step.
    void discardAfter(std::uint64_t step);

private:
    /// The strongest recent impact that a body withstood.
    struct Withstood {
        std::uint64_t step = 0;
        double impact = 0.0;  // N·s
    };
    void addWithstood(const Session& session, const PlayImpact& impact, LoggedStep& events);

    std::size_t m_maxEvents;
    std::uint64_t m_steps = 0;
    EventCourse m_course;
    std::map<std::uint32_t, Withstood> m_lastWithstood;  // by body
};

}  // namespace rubble
