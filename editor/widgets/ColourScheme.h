#pragma once

#include <QPalette>

namespace rubble {

/// Which palette all windows have; System follows the desktop.
enum class ColourScheme { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();

/// True if the palette's text is lighter than its background.
bool isDark(const QPalette& palette);

/// The palette of a scheme. System: that of the desktop, such as one of high contrast, which is the default palette and
/// stays so when the desktop changes; where the desktop has none, so that it is the style's own, the light or the dark
/// one.
QPalette paletteOf(ColourScheme scheme, const QPalette& desktop, const QPalette& ofStyle);

/// Sets Qt's Fusion style and the scheme's palette for the whole program, open windows included.
void applyTheme(ColourScheme scheme);

}  // namespace rubble
