#pragma once

#include "editor/canvas/painting/CanvasPainting.h"

#include <QImage>
#include <QRegion>

namespace rubble {

/// Caches the painted contents of a canvas: only changed parts are repainted, and panning shifts the cached image.
class CanvasBackingStore {
public:
    void invalidateAll() { m_isStale = true; }
    /// Invalidates a box (m) with a margin for markers and lines that extend beyond it.
    void invalidate(const Box2& part);

    /// The image for a view, up to date; `ratio` is the device pixel ratio.
    const QImage& at(const CanvasView& view, double ratio, const CanvasContents& contents,
                     const CanvasColours& colours);

private:
    void resize(double ratio);
    void moveFrom(const CanvasView& before);
    QRect area() const { return QRectF(QPointF(), m_view.size).toAlignedRect(); }

    QImage m_image;
    CanvasView m_view;      // of m_image
    QRegion m_stale;        // to be repainted, pixels of the view
    bool m_isStale = true;  // everything must be repainted
};

}  // namespace rubble
