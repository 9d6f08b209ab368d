#include "editor/play/EventExport.h"

#include "core/io/play/EventStreamFile.h"

namespace rubble {

Result<std::string> eventsText(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                               const TaskContext& task) {
    Result<Session> session = startOf(scene, script);
    if (!session) return session.error();
    return eventStream(std::move(*session), std::move(script.inputs), script.steps, task);
}

Result<std::string> eventsText(const EventCourse& course, EventsFormat format, const TaskContext& task) {
    EventsText text(format);
    for (const std::shared_ptr<const LoggedStep>& step : course.steps()) {
        if (task.isCancelled()) return TaskContext::cancelled();
        text.add(step->step, EventCourse::reportOf(*step));
    }
    return std::move(text).finished();
}

Result<std::string> eventsText(std::span<const EventRef> events, EventsFormat format, const TaskContext& task) {
    EventsText text(format);
    for (const EventRef& event : events) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (event->isReported) text.add(event->record.step, EventReport{.records = {event->record}});
    }
    return std::move(text).finished();
}

}  // namespace rubble
