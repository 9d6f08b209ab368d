#pragma once

#include "editor/Preferences.h"

#include <QPalette>

namespace rubble {

/// The palettes of the two themes, in Qt's Fusion style, which looks alike on all systems.
QPalette lightPalette();
QPalette darkPalette();

/// True where text is lighter than what is behind it.
bool isDark(const QPalette& palette);

/// Dresses all windows, those that are open too. System takes the palette that the desktop gave the program.
void applyTheme(ThemeChoice choice);

}  // namespace rubble
