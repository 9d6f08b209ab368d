#include "editor/PlayHands.h"

#include "editor/play/PlayController.h"
#include "viewport/ViewportWidget.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kLeastCharge = 0.2;
constexpr double kSecondsToFull = 1.0;

bool isPlain(Qt::KeyboardModifiers modifiers) {
    return !modifiers.testAnyFlags(Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier | Qt::MetaModifier);
}

}  // namespace

PlayHands::PlayHands(PlayController& controller, ViewportWidget& viewport)
    : QObject(&viewport), m_controller(controller), m_viewport(viewport) {
    viewport.installEventFilter(this);
    connect(&viewport, &ViewportWidget::cameraChanged, this, &PlayHands::aimAgain);
    connect(&controller, &PlayController::toolsChanged, this, &PlayHands::aimAgain);
    connect(&controller, &PlayController::stateChanged, this, [this] {
        if (!m_controller.isOn()) {
            m_chargingSince.reset();
            m_pressedAt.reset();
            m_isGrabbing = false;
        }
        aimAgain();
    });
}

std::optional<double> PlayHands::charge() const {
    if (!m_chargingSince) return std::nullopt;
    const double held = m_controller.thread().now() - *m_chargingSince;
    return std::clamp(kLeastCharge + (1.0 - kLeastCharge) * held / kSecondsToFull, kLeastCharge, 1.0);
}

Ray PlayHands::ray() const { return m_viewport.rayAt(m_pointer); }

void PlayHands::aimAgain() {
    if (!m_controller.isOn()) return;
    const bool isAiming = m_isPointing && !m_isGrabbing;
    m_controller.aim(isAiming ? std::optional(ray()) : std::nullopt, charge().value_or(1.0));
}

bool PlayHands::eventFilter(QObject* watched, QEvent* event) {
    if (!m_controller.isOn()) return QObject::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            if (press(*static_cast<QKeyEvent*>(event))) {
                event->accept();
                return true;
            }
            break;
        case QEvent::KeyRelease: return release(*static_cast<QKeyEvent*>(event));
        case QEvent::MouseButtonPress: return pressButton(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease: return releaseButton(*static_cast<QMouseEvent*>(event));
        case QEvent::Enter:
            m_pointer = static_cast<QEnterEvent*>(event)->position();
            m_isPointing = true;
            m_viewport.setFocus();  // who points into the play wants its keys
            aimAgain();
            break;
        case QEvent::Leave:
            m_isPointing = false;
            aimAgain();
            break;
        case QEvent::FocusOut: m_chargingSince.reset(); break;
        default: break;
    }
    return QObject::eventFilter(watched, event);
}

/// Keys are taken before shortcuts can be, and once where they repeat.
bool PlayHands::press(const QKeyEvent& event) {
    if (!isPlain(event.modifiers())) return false;
    const bool isOverride = event.type() == QEvent::ShortcutOverride, isFirst = !isOverride && !event.isAutoRepeat();
    switch (event.key()) {
        case Qt::Key_F:
            if (isFirst && m_isPointing) m_chargingSince = m_controller.thread().now();
            return true;
        case Qt::Key_H:
            if (isFirst && m_isPointing) m_controller.strikeAlong(ray());
            return true;
        case Qt::Key_X:
            if (isFirst && m_isPointing) m_controller.blastAlong(ray());
            return true;
        case Qt::Key_P:
            if (isFirst) m_controller.isPlaying() ? m_controller.pause() : m_controller.play();
            return true;
        case Qt::Key_Period:
            if (!isOverride) m_controller.stepOnce();
            return true;
        case Qt::Key_R:
            if (isFirst) m_controller.reset();
            return true;
        case Qt::Key_Escape:
            if (!isFirst) return true;
            if (m_chargingSince) {
                m_chargingSince.reset();
                aimAgain();
            } else {
                m_controller.stop();
            }
            return true;
        default: return false;
    }
}

bool PlayHands::release(const QKeyEvent& event) {
    if (event.key() != Qt::Key_F || event.isAutoRepeat()) return false;
    letThrowGo();
    return true;
}

void PlayHands::letThrowGo() {
    const std::optional<double> charged = charge();
    m_chargingSince.reset();
    if (!charged || !m_isPointing) return;
    m_controller.throwAlong(ray(), *charged);
    if (!m_controller.isPlaying()) m_controller.play();
    aimAgain();
}

bool PlayHands::pressButton(const QMouseEvent& event) {
    if (event.button() == Qt::LeftButton && isPlain(event.modifiers())) m_pressedAt = event.position();
    return false;  // it may become a click
}

bool PlayHands::move(const QMouseEvent& event) {
    m_pointer = event.position();
    m_isPointing = true;
    if (m_pressedAt) {
        const QPoint way = (event.position() - *m_pressedAt).toPoint();
        if (way.manhattanLength() < QApplication::startDragDistance()) return false;
        m_controller.grabAlong(m_viewport.rayAt(*m_pressedAt));
        m_pressedAt.reset();
        m_isGrabbing = true;
        aimAgain();
    }
    if (m_isGrabbing) {
        m_controller.dragAlong(ray());
        return true;
    }
    aimAgain();
    return false;
}

bool PlayHands::releaseButton(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    m_pressedAt.reset();
    if (!m_isGrabbing) return false;
    m_isGrabbing = false;
    m_controller.letGo();
    aimAgain();
    return true;
}

}  // namespace rubble
