#include "editor/play/EventCourse.h"

#include <algorithm>

namespace rubble {

BreakCounts countsOf(std::span<const EventRef> breaks) {
    BreakCounts counts;
    for (const EventRef& broken : breaks) {
        if (broken->record.kind == EventKind::Bonds) {
            counts.bonds += broken->record.count;
        } else {
            ++counts.breaks;
            counts.fragments += broken->record.count;
        }
    }
    return counts;
}

std::span<const EventRef> EventCourse::breaks(std::uint64_t last) const {
    return {m_breaks.begin(), std::ranges::upper_bound(m_breaks, last, {}, stepOfEvent)};
}

EventReport EventCourse::reportOf(const LoggedStep& step) {
    EventReport report{.omitted = step.omitted, .restEnergy = step.restEnergy};
    for (const PlayEvent& event : step.events) {
        if (event.isReported) report.records.push_back(event.record);
    }
    return report;
}

void EventCourse::count(const LoggedStep& step) {
    m_size += step.events.size();
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        m_omitted[kind].count += step.omitted[kind].count;
        m_omitted[kind].energy += step.omitted[kind].energy;
    }
    m_restEnergy += step.restEnergy;
}

void EventCourse::append(std::shared_ptr<const LoggedStep> step) {
    count(*step);
    for (const PlayEvent& event : step->events) {
        if (event.isBreak()) m_breaks.emplace_back(step, &event);
    }
    m_steps.push_back(std::move(step));
}

void EventCourse::discardAfter(std::uint64_t step) {
    while (!m_steps.empty() && m_steps.back()->step > step) m_steps.pop_back();
    while (!m_breaks.empty() && m_breaks.back()->record.step > step) m_breaks.pop_back();
    m_size = 0;
    m_omitted = {};
    m_restEnergy = 0.0;
    for (const std::shared_ptr<const LoggedStep>& kept : m_steps) count(*kept);
}

}  // namespace rubble
