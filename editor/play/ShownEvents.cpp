#include "editor/play/ShownEvents.h"

namespace rubble {

void ShownEvents::append(const std::shared_ptr<const LoggedStep>& step) {
    for (const PlayEvent& event : step->events) {
        if (m_filter.accepts(event)) m_events.emplace_back(step, &event);
    }
}

void ShownEvents::discardAfter(std::uint64_t step) {
    while (!m_events.empty() && m_events.back()->record.step > step) m_events.pop_back();
}

void ShownEvents::setFilter(const EventFilter& filter, const EventCourse& course) {
    m_filter = filter;
    m_events.clear();
    for (const std::shared_ptr<const LoggedStep>& step : course.steps()) append(step);
}

}  // namespace rubble
