#pragma once

#include "editor/play/PlayToolSettings.h"

#include <QSettings>

namespace rubble {

/// Returns the stored settings of the play tools; a missing or invalid value gets its default. A projectile that is an
/// asset of a project is not kept, nor whether a click throws.
PlayToolSettings readPlayTools(const QSettings& settings);
void writePlayTools(const PlayToolSettings& tools, QSettings& settings);

}  // namespace rubble
