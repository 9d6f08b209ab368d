#include "viewport/widget/OverlayPlate.h"

namespace rubble {

OverlayInk overlayInk(Theme theme) {
    if (theme == Theme::Dark) return {.ink = QColor(235, 235, 235), .halo = QColor(13, 13, 13, 190)};
    return {.ink = QColor(30, 30, 30), .halo = QColor(255, 255, 255, 190)};
}

QRect paintPlate(QPainter& painter, const QRect& plate) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlateColour);
    painter.drawRoundedRect(plate, 4, 4);
    return plate.adjusted(kPlatePadding, kPlatePadding - 2, -kPlatePadding, -kPlatePadding + 2);
}

}  // namespace rubble
