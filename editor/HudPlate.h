#pragma once

#include <QColor>
#include <QPainter>

namespace rubble {

/// What is written over the 3D view stands on dark plates, which can be read over anything, in light and dark alike.
inline const QColor kPlatePaper(20, 22, 26, 150);
inline const QColor kPlateInk(245, 246, 248);
inline const QColor kPlateFaintInk(245, 246, 248, 190);
inline constexpr int kPlatePadding = 7;  // points

/// Paints a plate, and gives the room on it.
QRect paintPlate(QPainter& painter, const QRect& plate);

}  // namespace rubble
