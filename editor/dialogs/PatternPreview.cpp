#include "editor/dialogs/PatternPreview.h"

#include "core/asset/bake/FractureResult.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "editor/widgets/ColourConversion.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kWallWidth = 2.0;      // m
constexpr double kWallHeight = 1.5;     // m
constexpr double kWallDepth = 0.2;      // m
constexpr double kPreviewMargin = 6.0;  // pixels around it

void addRing(const Ring& ring, const QTransform& pixels, QPainterPath& path) {
    QPolygonF points;
    for (const Vec2 point : ring) points.append(pixels.map(QPointF(point.x, point.y)));
    path.addPolygon(points);
    path.closeSubpath();
}

}  // namespace

PatternPreview::PatternPreview(QWidget* parent) : QWidget(parent) {
    setMinimumSize(160, 120);
    setAccessibleName(tr("Fracture preview"));
    setToolTip(tr("Fracture of a wall of 2 × 1.5 m"));
}

void PatternPreview::setPreset(const MaterialPreset& preset) {
    m_outside = preset.outside;
    m_inside = preset.inside;
    const Prism wall{rectangleOutline(kWallWidth, kWallHeight), kWallDepth};
    Recipe recipe;
    recipe.pattern = patternWithin(preset, boundsOf(wall.outline.outer));
    const Result<PlanarFracture> fracture = planarFracture(recipe, wall, {});
    m_partition = fracture ? fracture->partition : Partition{};
    update();
}

void PatternPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale =
        std::min((width() - 2.0 * kPreviewMargin) / kWallWidth, (height() - 2.0 * kPreviewMargin) / kWallHeight);
    QTransform pixels;
    pixels.translate(width() / 2.0, height() / 2.0);
    pixels.scale(scale, -scale);
    pixels.translate(m_partition.origin.x, m_partition.origin.y);
    const QColor inside = toQColor(m_inside);
    painter.setPen(QPen(inside.lightnessF() > 0.5F ? inside.darker(220) : inside.darker(160), 1.0));
    painter.setBrush(toQColor(m_outside));
    for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
        const Polygon outline = pieceOutline(m_partition, piece);
        QPainterPath path;
        addRing(outline.outer, pixels, path);
        for (const Ring& hole : outline.holes) addRing(hole, pixels, path);
        painter.drawPath(path);
    }
}

}  // namespace rubble

#include "moc_PatternPreview.cpp"
