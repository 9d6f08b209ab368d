#pragma once

#include "editor/Preferences.h"

namespace rubble {

class ViewportWidget;

/// Has a 3D view move and draw as the user prefers.
void takePreferences(ViewportWidget& viewport, const Preferences& preferences);
/// Has it draw in the theme of its palette.
void takeTheme(ViewportWidget& viewport);

}  // namespace rubble
