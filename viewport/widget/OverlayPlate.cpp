#include "viewport/widget/OverlayPlate.h"

namespace rubble {

QRect paintPlate(QPainter& painter, const QRect& plate) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlateColour);
    painter.drawRoundedRect(plate, 4, 4);
    return plate.adjusted(kPlatePadding, kPlatePadding - 2, -kPlatePadding, -kPlatePadding + 2);
}

}  // namespace rubble
