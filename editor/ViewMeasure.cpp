#include "editor/ViewMeasure.h"

#include "editor/MeasureOverlay.h"
#include "viewport/ViewportWidget.h"
#include "viewport/scene/SurfacePoint.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace rubble {

namespace {

constexpr double kReach = 12.0;  // points from a corner within which the pointer is drawn to it

}  // namespace

ViewMeasure::ViewMeasure(ViewportWidget& viewport)
    : QObject(&viewport), m_viewport(viewport), m_overlay(new MeasureOverlay(*this, viewport)) {
    viewport.installEventFilter(this);
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] {
        if (m_isOn) point(m_pointer);
    });
}

void ViewMeasure::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    m_isOn = isOn;
    m_from.reset();
    m_to.reset();
    m_pointed.reset();
    if (isOn) {
        m_viewport.setCursor(Qt::CrossCursor);
        m_viewport.setFocus();
        point(m_viewport.mapFromGlobal(QCursor::pos()));
    } else {
        m_viewport.unsetCursor();
    }
    emit changed();
    emit onChanged(isOn);
    tellHint();
}

std::optional<double> ViewMeasure::distance() const {
    if (!m_from || !m_to) return std::nullopt;
    return glm::distance(m_from->place, m_to->place);
}

std::optional<ViewMeasure::Point> ViewMeasure::pointAt(QPointF pixel) const {
    const auto hit = surfaceAt(m_viewport.scene(), m_viewport.rayAt(pixel));
    if (!hit) return std::nullopt;
    const Vec2 at = m_viewport.devicePixelRatioF() * Vec2(pixel.x(), pixel.y());
    const auto corner = cornerNear(m_viewport.scene(), hit->body, m_viewport.shownCamera(), m_viewport.pictureSize(),
                                   at, kReach * m_viewport.devicePixelRatioF());
    return corner ? Point{*corner, true} : Point{hit->place, false};
}

void ViewMeasure::point(QPointF pixel) {
    m_pointer = pixel;
    m_pointed = pointAt(pixel);
    emit changed();
}

/// The first click after a measure begins another one.
void ViewMeasure::take() {
    if (!m_pointed) return;
    if (!m_from || m_to) {
        m_from = m_pointed;
        m_to.reset();
    } else {
        m_to = m_pointed;
    }
    emit changed();
    tellHint();
}

void ViewMeasure::cancel() {
    if (!m_from) return setOn(false);
    m_from.reset();
    m_to.reset();
    emit changed();
    tellHint();
}

void ViewMeasure::tellHint() {
    if (!m_isOn) return emit hintChanged({});
    if (m_from && !m_to) return emit hintChanged(tr("Click the point to measure to · Esc: begin anew"));
    emit hintChanged(m_to ? tr("Click to measure from another point · Esc: clear")
                          : tr("Click the point to measure from; corners draw the pointer to them · Esc: end"));
}

/// Left clicks and Esc are its own; the view is moved as ever.
bool ViewMeasure::eventFilter(QObject* watched, QEvent* event) {
    if (!m_isOn) return QObject::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) break;
            event->accept();
            if (event->type() == QEvent::KeyPress) cancel();
            return true;
        case QEvent::MouseMove: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->buttons() == Qt::NoButton) point(mouse->position());
            break;
        }
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseButtonRelease: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->button() != Qt::LeftButton || mouse->modifiers().testFlag(Qt::AltModifier)) break;
            if (event->type() == QEvent::MouseButtonRelease) return true;
            point(mouse->position());
            take();
            return true;
        }
        default: break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble
