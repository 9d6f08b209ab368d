#pragma once

#include "viewport/render/RenderSettings.h"

#include <QColor>
#include <QPainter>

namespace rubble {

// Texts over the 3D view are written on dark plates, which are readable over any background in both themes.
inline const QColor kPlateColour(20, 22, 26, 190);
inline const QColor kPlateText(245, 246, 248);
inline const QColor kPlateSecondaryText(245, 246, 248, 215);
inline constexpr int kPlatePadding = 7;  // points

/// What is written without a plate has a halo, with which it is readable over any background, too.
struct OverlayInk {
    QColor ink, halo;
};
OverlayInk overlayInk(Theme theme);

/// Paints a plate and returns the rectangle for its content.
QRect paintPlate(QPainter& painter, const QRect& plate);

}  // namespace rubble
