#pragma once

#include "editor/play/EventCourse.h"
#include "editor/play/EventFilter.h"

namespace rubble {

/// The events of a course that a filter selects, by ascending step. Kept up to date step by step: the filter sees each
/// event once.
class ShownEvents {
public:
    const std::vector<EventRef>& events() const { return m_events; }
    const EventFilter& filter() const { return m_filter; }

    void append(const std::shared_ptr<const LoggedStep>& step);
    void discardAfter(std::uint64_t step);
    void clear() { m_events.clear(); }
    void setFilter(const EventFilter& filter, const EventCourse& course);

private:
    EventFilter m_filter;
    std::vector<EventRef> m_events;
};

}  // namespace rubble
