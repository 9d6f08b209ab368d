#pragma once

#include "editor/workspace/Preferences.h"
#include "viewport/render/RenderSettings.h"

namespace rubble {

class ViewportWidget;

/// Applies the user's preferences for navigation and rendering.
void applyPreferences(ViewportWidget& viewport, const Preferences& preferences);
/// Returns the theme that matches a palette.
Theme themeOf(const QPalette& palette);
/// Gives the view the theme of its palette, now and whenever that changes.
void followPalette(ViewportWidget& viewport);

}  // namespace rubble
