#pragma once

#include "core/play/state/EventRecord.h"

#include <memory>
#include <optional>

namespace rubble {

/// How near a body came to breaking in an impact.
struct ImpactStrength {
    std::string name;        // of the body
    double impact = 0.0;     // N·s
    double threshold = 0.0;  // N·s
    Id asset = 0;            // that the body is made of
    double scale = 1.0;      // its threshold relative to that of the whole asset; 0: it has its own
    double ratio() const { return impact / threshold; }
};

/// An event of a session as the editor lists it.
struct PlayEvent {
    EventRecord record;
    std::string name;       // of its body
    std::string otherName;  // of the body that it touched; empty: none
    std::optional<ImpactStrength> strength;
    double milliseconds = 0.0;  // of a break: the wall-clock time of the swap
    bool isReported =
        true;  // false: in the session it is in the sums at most; its energy, mass and materials are unknown

    bool isBreak() const { return record.kind == EventKind::Broken || record.kind == EventKind::Bonds; }
    /// Whether it has an energy: what settles or is removed has none.
    bool hasEnergy() const { return isReported && (record.kind == EventKind::Impact || isBreak()); }
};

/// What happened in a step.
struct LoggedStep {
    std::uint64_t step = 0;
    std::vector<PlayEvent> events;                     // by kind, then body, then other
    std::array<OmittedEvents, kEventKinds> omitted{};  // by kind
    double restEnergy = 0.0;                           // J, see EventReport
};

/// An event that keeps its step in memory.
using EventRef = std::shared_ptr<const PlayEvent>;
inline std::uint64_t stepOfEvent(const EventRef& event) { return event->record.step; }

}  // namespace rubble
