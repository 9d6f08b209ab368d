#pragma once

#include "editor/panels/Units.h"
#include "viewport/Refining.h"

#include <QSettings>

namespace rubble {

enum class ThemeChoice { System, Light, Dark };
enum class NavigationChoice { Blender, Maya };

/// What a user prefers in every window; kept by QSettings.
struct Preferences {
    ThemeChoice theme = ThemeChoice::System;
    NavigationChoice navigation = NavigationChoice::Blender;
    LengthUnit unit = LengthUnit::Metre;
    int autosaveSeconds = 60;                // 0: no backups
    int msaa = 0;                            // samples a pixel of the 3D view: 1, 2, 4 or 8; 0: as suits the machine
    Refining refining = Refining::WithCard;  // of the 3D view while nothing moves
    bool isSmooth = true;                    // the 3D view moves to a new place instead of jumping
    bool operator==(const Preferences&) const = default;
};

/// What is kept; the usual value for whatever is not kept or cannot be understood.
Preferences readPreferences(const QSettings& settings);
void writePreferences(const Preferences& preferences, QSettings& settings);

}  // namespace rubble
