#pragma once

#include "viewport/scene/Camera.h"

#include <QPainter>
#include <QWidget>

#include <vector>

namespace rubble {

class ViewportWidget;

/// Something painted over a 3D view: a tool's handles, a legend, a head-up display.
class OverlayItem : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    /// Paints in widget coordinates; `size`: the size of the view.
    virtual void paint(QPainter& painter, QSize size) const = 0;
    /// The rectangles at the upper or lower edge of a view of this size that it fills with texts. Items keep clear of
    /// those of each other, and framing leaves room for them.
    virtual std::vector<QRect> plates(QSize /*size*/, const QFont& /*font*/) const { return {}; }
    /// The item's texts for screen readers; empty if it shows none.
    virtual QString accessibleText() const { return {}; }

signals:
    void changed();
};

/// The transparent layer over a 3D view that paints its overlay items. It lets all input through, and repaints when an
/// item or the camera on screen changes.
class ViewportOverlay : public QWidget {
    Q_OBJECT
public:
    explicit ViewportOverlay(ViewportWidget& viewport);

    /// Sets the items, painted from first to last. They are used until others are set, or the overlay is destroyed.
    void setItems(const std::vector<OverlayItem*>& items);
    /// The plates of all items in a view of this size.
    std::vector<QRect> plates(QSize size) const;
    /// The strips at the edges of a view of this size that plates cover, in points; none while hidden.
    ImageStrips strips(QSize size) const;

signals:
    /// The strips may have changed.
    void itemsChanged();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void followCamera();
    void refresh();

    ViewportWidget& m_viewport;
    std::vector<OverlayItem*> m_items;
    Camera m_paintedCamera;
};

}  // namespace rubble
