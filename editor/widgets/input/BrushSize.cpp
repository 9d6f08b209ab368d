#include "editor/widgets/input/BrushSize.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kMinRadius = 3.0;  // pixels
constexpr double kMaxRadius = 400.0;
constexpr double kFactorPerStep = 1.25;

}  // namespace

void BrushSize::setRadiusPixels(double radius) { m_radiusPixels = std::clamp(radius, kMinRadius, kMaxRadius); }

void BrushSize::step(double steps) { setRadiusPixels(m_radiusPixels * std::pow(kFactorPerStep, steps)); }

void BrushSize::paintRing(QPainter& painter, QPointF centre, double part, const QColor& colour, const QColor& halo,
                          bool isErasing) const {
    const double radius = part * m_radiusPixels;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(halo, 3.0));
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(QPen(colour, 1.5, isErasing ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(centre, radius, radius);
}

}  // namespace rubble
