#pragma once

#include "core/play/state/EventRecord.h"

#include <string>

namespace rubble {

/// What a step tells as JSON lines: one for each record, and one of the kind "sums" where anything is only counted or
/// summed. All members are described in docs/formats/events.md.
std::string eventLines(std::uint64_t step, const EventReport& report);

}  // namespace rubble
