#pragma once

#include "core/base/TaskContext.h"
#include "core/io/play/EventsFile.h"
#include "editor/play/EventCourse.h"
#include "editor/play/PlayEngine.h"

namespace rubble {

/// The text of a file of events of version 2: a script is played again. The bytes that `rubble-cli simulate --events`
/// writes for the same inputs.
///
/// Errors: those of startOf() and eventStream().
Result<std::string> eventsText(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                               const TaskContext& task = {});
/// The text of a file of version 1 with all that the session reported in a course: the bytes that `rubble-cli simulate
/// --events --events-version 1` writes for the same inputs, up to the step at which EventLog is full.
///
/// Errors: Cancelled.
Result<std::string> eventsText(const EventCourse& course, EventsFormat format, const TaskContext& task = {});
/// The same for some events of a course, by ascending step, without the sums of the others.
Result<std::string> eventsText(std::span<const EventRef> events, EventsFormat format, const TaskContext& task = {});

}  // namespace rubble
