#pragma once

#include "core/base/TaskContext.h"
#include "core/io/play/EventsFile.h"
#include "editor/play/EventCourse.h"

namespace rubble {

/// The text of a file with all that the session told in a course: the bytes that `rubble-cli simulate --events` writes
/// for the same inputs, up to the step at which EventLog is full.
///
/// Errors: Cancelled.
Result<std::string> eventsText(const EventCourse& course, EventsFormat format, const TaskContext& task = {});
/// The same for some events of a course, by ascending step, without the sums of the others.
Result<std::string> eventsText(std::span<const EventRef> events, EventsFormat format, const TaskContext& task = {});

}  // namespace rubble
