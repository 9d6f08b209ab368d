#pragma once

#include <QPalette>

namespace rubble {

/// Which palette all windows have; System follows the desktop.
enum class ColourScheme { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();

/// True if the palette's text is lighter than its background.
bool isDark(const QPalette& palette);

/// Sets Qt's Fusion style and the scheme's palette for the whole program, open windows included.
void applyTheme(ColourScheme scheme);

}  // namespace rubble
