#include "editor/canvas/CanvasPicture.h"

#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kAroundChange = 10.0;  // pixels that signs and lines reach beyond what changed
constexpr double kWholePixel = 1e-3;    // pixels that a move may be off a whole number

}  // namespace

void CanvasPicture::spoil(const Box2& part) {
    if (part.min.x > part.max.x) return;
    const QPointF reach(kAroundChange, kAroundChange);
    const QRectF box = QRectF(m_view.pixels(part.min), m_view.pixels(part.max)).normalized();
    const QRectF around(box.topLeft() - reach, box.bottomRight() + reach);
    m_stale |= (around & QRectF(area())).toAlignedRect();
}

const QImage& CanvasPicture::at(const CanvasView& view, double ratio, const CanvasContents& contents,
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

void CanvasPicture::resize(double ratio) {
    const QSize pixels = (m_view.size * ratio).toSize();
    if (m_image.size() == pixels && m_image.devicePixelRatio() == ratio) return;
    m_image = QImage(pixels, QImage::Format_RGB32);
    m_image.setDevicePixelRatio(ratio);
    m_isStale = true;
}

/// What was only moved by whole pixels is kept.
void CanvasPicture::moveFrom(const CanvasView& before) {
    const QPointF moved = m_view.pixels(before.centre) - before.pixels(before.centre);
    const QPoint whole = moved.toPoint();
    const double ratio = m_image.devicePixelRatio();
    const bool isWhole = (moved - whole).manhattanLength() < kWholePixel && ratio == std::floor(ratio);
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
