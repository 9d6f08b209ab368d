#pragma once

#include "editor/canvas/CanvasPainting.h"

#include <QImage>
#include <QRegion>

namespace rubble {

/// The contents of a canvas as they were painted last: only what changed is painted again, and what a view merely moved is kept.
class CanvasPicture {
public:
    void spoilAll() { m_isStale = true; }
    /// What lies in a box (m) of the picture as it is, with the signs and lines that reach out of it.
    void spoil(const Box2& part);

    /// The picture at a view, with `ratio` pixels of the screen to one of the view's.
    const QImage& at(const CanvasView& view, double ratio, const CanvasContents& contents,
                     const CanvasColours& colours);

private:
    void resize(double ratio);
    void moveFrom(const CanvasView& before);
    QRect area() const { return QRectF(QPointF(), m_view.size).toAlignedRect(); }

    QImage m_image;
    CanvasView m_view;      // that it was painted at
    QRegion m_stale;        // what is to be painted again, pixels of the view
    bool m_isStale = true;  // all of it is
};

}  // namespace rubble
