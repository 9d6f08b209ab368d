#include "viewport/widget/ViewportOverlay.h"

#include "viewport/widget/ViewportCanvas.h"
#include "viewport/widget/ViewportWidget.h"

#include <QStringList>

#include <algorithm>

namespace rubble {

ViewportOverlay::ViewportOverlay(ViewportWidget& viewport) : QWidget(&viewport), m_viewport(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Overlay"));
    // Without pictures; with them, it is painted together with each.
    connect(&viewport, &ViewportWidget::cameraChanged, this, &ViewportOverlay::followCamera);
}

void ViewportOverlay::setItems(const std::vector<OverlayItem*>& items) {
    for (OverlayItem* item : m_items) disconnect(item, &OverlayItem::changed, this, nullptr);
    m_items = items;
    for (OverlayItem* item : m_items) connect(item, &OverlayItem::changed, this, &ViewportOverlay::refresh);
    refresh();
}

void ViewportOverlay::refresh() {
    QStringList texts;
    for (const OverlayItem* item : m_items) {
        if (const QString text = item->accessibleText(); !text.isEmpty()) texts << text;
    }
    setAccessibleDescription(texts.join(". "));
    update();
    emit itemsChanged();
}

std::vector<QRect> ViewportOverlay::plates(QSize size) const {
    std::vector<QRect> all;
    for (const OverlayItem* item : m_items) {
        const std::vector<QRect> plates = item->plates(size, font());
        all.insert(all.end(), plates.begin(), plates.end());
    }
    return all;
}

ImageStrips ViewportOverlay::strips(QSize size) const {
    ImageStrips strips;
    if (isHidden()) return strips;
    for (const QRect& plate : plates(size)) {
        const bool isUpper = plate.center().y() < size.height() / 2;
        double& strip = isUpper ? strips.top : strips.bottom;
        strip = std::max(strip, static_cast<double>(isUpper ? plate.bottom() + 1 : size.height() - plate.top()));
    }
    return strips;
}

void ViewportOverlay::followCamera() {
    if (!m_items.empty() && m_viewport.shownCamera() != m_paintedCamera) update();
}

void ViewportOverlay::paintEvent(QPaintEvent*) {
    const ViewportCanvas* canvas = m_viewport.m_canvas;
    if (canvas != nullptr && canvas->hasPicture()) m_viewport.m_painted = canvas->shownCamera();
    m_paintedCamera = m_viewport.shownCamera();
    QPainter painter(this);
    for (const OverlayItem* item : m_items) {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        item->paint(painter, size());
        painter.restore();
    }
    m_viewport.m_painted.reset();
}

}  // namespace rubble

#include "moc_ViewportOverlay.cpp"
