#pragma once

#include "editor/play/PlayEvent.h"

#include <QString>

namespace rubble {

/// Selects events by kind, bodies, energy and material.
struct EventFilter {
    std::array<bool, kEventKinds> kinds = allKinds();
    QString text;              // in the name of the body or of the other one, in any case; empty: all
    double leastEnergy = 0.0;  // J; above 0, events without an energy are not selected
    Id material = 0;           // of one of both; 0: all

    bool accepts(const PlayEvent& event) const;
    /// Whether there can be an event that it does not select.
    bool isActive() const { return *this != EventFilter{}; }
    bool operator==(const EventFilter&) const = default;

private:
    static constexpr std::array<bool, kEventKinds> allKinds() {
        std::array<bool, kEventKinds> kinds{};
        kinds.fill(true);
        return kinds;
    }
};

}  // namespace rubble
