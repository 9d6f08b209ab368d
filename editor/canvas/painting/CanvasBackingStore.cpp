#include "editor/canvas/painting/CanvasBackingStore.h"

#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kInvalidationMargin = 10.0;  // pixels, for markers and lines beyond the invalidated box
constexpr double kPixelTolerance = 1e-3;      // pixels by which a pan may differ from whole pixels

}  // namespace

void CanvasBackingStore::invalidate(const Box2& part) {
    if (part.min.x > part.max.x) return;
    const QPointF margin(kInvalidationMargin, kInvalidationMargin);
    const QRectF box = QRectF(m_view.pixels(part.min), m_view.pixels(part.max)).normalized();
    const QRectF around(box.topLeft() - margin, box.bottomRight() + margin);
    m_stale |= (around & QRectF(area())).toAlignedRect();
}

const QImage& CanvasBackingStore::at(const CanvasView& view, double ratio, const CanvasContents& contents,
                                     const CanvasColours& colours) {
    const CanvasView before = std::exchange(m_view, view);
    resize(ratio);
    if (before != view) moveFrom(before);
    if (m_isStale) m_stale = area();
    m_isStale = false;
    const QRegion stale = std::exchange(m_stale, {}) & area();
    if (stale.isEmpty()) return m_image;
    QPainter painter(&m_image);
    for (const QRect& part : stale) paintContents(painter, part, view, contents, colours);
    return m_image;
}

void CanvasBackingStore::resize(double ratio) {
    const QSize pixels = (m_view.size * ratio).toSize();
    if (m_image.size() == pixels && m_image.devicePixelRatio() == ratio) return;
    m_image = QImage(pixels, QImage::Format_RGB32);
    m_image.setDevicePixelRatio(ratio);
    m_isStale = true;
}

/// Keeps what was only panned by whole pixels.
void CanvasBackingStore::moveFrom(const CanvasView& before) {
    const QPointF moved = m_view.pixels(before.centre) - before.pixels(before.centre);
    const QPoint whole = moved.toPoint();
    const double ratio = m_image.devicePixelRatio();
    const bool isWhole = (moved - whole).manhattanLength() < kPixelTolerance && ratio == std::floor(ratio);
    if (before.scale != m_view.scale || before.size != m_view.size || !isWhole) {
        m_isStale = true;
        return;
    }
    QImage kept(m_image.size(), m_image.format());
    kept.setDevicePixelRatio(ratio);
    QPainter(&kept).drawImage(whole, m_image);
    m_image = std::move(kept);
    m_stale.translate(whole);
    m_stale |= QRegion(area()) - QRegion(area().translated(whole));
}

}  // namespace rubble
