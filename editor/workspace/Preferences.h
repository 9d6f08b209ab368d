#pragma once

#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/numbers/Units.h"
#include "viewport/render/RenderSettings.h"
#include "viewport/widget/Navigation.h"
#include "viewport/widget/ProgressiveRendering.h"

#include <QSettings>
#include <QString>
#include <QStringList>

namespace rubble {

constexpr int kMaxAutosaveSeconds = 3600;
constexpr int kMaxVolume = 100;  // %
constexpr int kMaxSkyFiles = 6;

/// The user's preferences, the same in all windows.
struct Preferences {
    ColourScheme theme = ColourScheme::System;
    NavigationStyle navigation = NavigationStyle::Blender;
    LengthUnit unit = LengthUnit::Metre;
    int autosaveSeconds = 60;  // from a change to the backup; 0: no backups
    int msaa = 0;              // samples per pixel of the 3D view: 1, 2, 4 or 8; 0: automatic
    ProgressiveRendering refining = ProgressiveRendering::Always;  // of the 3D view while nothing moves
    RenderQuality quality = RenderQuality::Good;                   // what it is refined to
    SkyPreset sky = SkyPreset::Studio;                             // of the 3D view
    QString skyFile;                                               // in place of `sky`; empty: that
    QStringList recentSkyFiles;                                    // newest first, at most kMaxSkyFiles
    double exposure = 0.0;                                         // of the 3D view, stops
    bool isSmooth = true;                                          // the camera moves smoothly to a new view
    bool hasStatistics = false;                                    // frame rate, bodies and times in play
    bool hasSound = false;                                         // of impacts and breaks in play
    int volume = 75;                                               // of the sound, %: in [0, 100]
    bool operator==(const Preferences&) const = default;
};

/// The preferences with a sky of the 3D view and its exposure. `file`: in place of the preset; empty: that.
Preferences withLight(Preferences preferences, SkyPreset sky, const QString& file, double exposure);

/// Returns the stored preferences; a missing or invalid value gets its default.
Preferences readPreferences(const QSettings& settings);
void writePreferences(const Preferences& preferences, QSettings& settings);

}  // namespace rubble
