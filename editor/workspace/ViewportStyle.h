#pragma once

#include "editor/workspace/Preferences.h"

namespace rubble {

class ViewportWidget;

/// Applies the user's preferences for navigation and rendering.
void applyPreferences(ViewportWidget& viewport, const Preferences& preferences);
/// Applies the theme of the widget's palette.
void applyTheme(ViewportWidget& viewport);

}  // namespace rubble
