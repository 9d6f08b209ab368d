#include "editor/view3d/tools/PlayTool.h"

#include "core/asset/project/Ranges.h"
#include "editor/play/PlayController.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/input/HeldKey.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kTapSeconds = 0.2;  // holding F longer charges the throw
constexpr double kSecondsToFull = 1.0;
constexpr double kRadiusPerNotch = 1.1;
constexpr double kMinRadius = 0.01;  // m, by the wheel: smaller ones could hardly be enlarged again

bool isPlain(Qt::KeyboardModifiers modifiers) {
    return !modifiers.testAnyFlags(Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier | Qt::MetaModifier);
}

bool isOwnKey(int key) { return key == Qt::Key_F || key == Qt::Key_H || key == Qt::Key_X || key == Qt::Key_Escape; }

}  // namespace

PlayTool::PlayTool(PlayController& controller, ViewportWidget& viewport)
    : m_controller(controller), m_viewport(viewport) {
    connect(&viewport, &ViewportWidget::cameraChanged, this, &PlayTool::updateAim);
    connect(&controller, &PlayController::toolSettingsChanged, this, &PlayTool::updateAim);
    connect(&controller, &PlayController::stateChanged, this, [this] {
        if (!m_controller.isInPlay()) {
            m_chargingSince.reset();
            m_pressedAt.reset();
            m_isGrabbing = false;
        }
        updateAim();
    });
}

std::optional<double> PlayTool::charge() const {
    if (!m_chargingSince) return std::nullopt;
    const double held = m_controller.thread().now() - *m_chargingSince;
    return std::clamp((held - kTapSeconds) / (kSecondsToFull - kTapSeconds), 0.0, 1.0);
}

Ray PlayTool::ray() const { return m_viewport.rayAt(m_isPointing ? m_pointer : QRectF(m_viewport.rect()).center()); }

void PlayTool::throwWith(double charge) {
    m_controller.throwAlong(ray(), charge);
    if (!m_controller.isPlaying()) m_controller.play();
}

void PlayTool::throwAtPointer() {
    if (m_controller.isInPlay()) throwWith(0.0);
}

void PlayTool::hammerAtPointer() {
    if (m_controller.isInPlay()) m_controller.hammerAlong(ray());
}

void PlayTool::explodeAtPointer() {
    if (m_controller.isInPlay()) m_controller.blastAlong(ray());
}

void PlayTool::updateAim() {
    if (!m_controller.isInPlay()) return;
    const bool isAiming = m_isPointing && !m_isGrabbing;
    m_controller.aim(isAiming ? std::optional(ray()) : std::nullopt, charge().value_or(0.0));
}

void PlayTool::enter(QPointF position) {
    if (!m_controller.isInPlay()) return;
    m_pointer = position;
    m_isPointing = true;
    updateAim();
}

void PlayTool::leave() {
    m_isPointing = false;  // also for the next run
    updateAim();
}

void PlayTool::focusLost() {
    if (m_controller.isInPlay()) m_chargingSince.reset();
}

bool PlayTool::overridesShortcut(const QKeyEvent& event) const {
    if (!m_controller.isInPlay()) return false;
    return (isPlain(event.modifiers()) && isOwnKey(event.key())) || actionOf(event) != nullptr;
}

QAction* PlayTool::actionOf(const QKeyEvent& event) const {
    const auto found =
        std::ranges::find_if(m_actions, [&](const QAction* action) { return isShortcutOf(*action, event); });
    return found != m_actions.end() ? *found : nullptr;
}

bool PlayTool::wheel(const QWheelEvent& event) {
    if (!m_controller.isInPlay() || !event.modifiers().testFlag(Qt::ControlModifier)) return false;
    PlayToolSettings settings = m_controller.toolSettings();
    double& radius = settings.blast.radius;
    const NumberRange& range = rangeOf(ProjectNumber::BlastRadius);
    radius *= std::pow(kRadiusPerNotch, event.angleDelta().y() / double{QWheelEvent::DefaultDeltasPerStep});
    radius = std::clamp(radius, kMinRadius, range.max);
    m_controller.setToolSettings(settings);
    emit statusMessage(tr("Blast radius: %1").arg(localizedQuantity(QuantityKind::Length, radius, m_units)));
    return true;
}

/// The tool's own keys act once when held.
bool PlayTool::keyPress(const QKeyEvent& event) {
    if (!overridesShortcut(event)) return false;
    if (QAction* action = actionOf(event)) {
        triggerByKey(*action, event);
        return true;
    }
    if (event.isAutoRepeat()) return true;
    switch (event.key()) {
        case Qt::Key_F:
            if (m_isPointing && !m_chargingSince) {
                m_chargingSince = m_controller.thread().now();
                emit chargingStarted();
            }
            break;
        case Qt::Key_H:
            if (m_isPointing) hammerAtPointer();
            break;
        case Qt::Key_X:
            if (m_isPointing) explodeAtPointer();
            break;
        case Qt::Key_Escape:
            if (!cancel()) m_controller.stop();
            break;
        default: break;
    }
    return true;
}

bool PlayTool::keyRelease(const QKeyEvent& event) {
    if (!m_controller.isInPlay() || event.key() != Qt::Key_F || event.isAutoRepeat()) return false;
    if (!isHeld(event)) throwCharged();
    return true;
}

bool PlayTool::cancel() {
    if (!m_chargingSince) return false;
    m_chargingSince.reset();
    updateAim();
    return true;
}

void PlayTool::throwCharged() {
    const std::optional<double> charged = charge();
    m_chargingSince.reset();
    if (!charged || !m_isPointing) return;
    throwWith(*charged);
    updateAim();
}

/// Not consumed: it may become a click.
bool PlayTool::press(const QMouseEvent& event) {
    const bool isGrab = event.button() == Qt::LeftButton && isPlain(event.modifiers());
    if (m_controller.isInPlay() && isGrab) m_pressedAt = event.position();
    return false;
}

bool PlayTool::doubleClick(const QMouseEvent& event) {
    if (!m_controller.toolSettings().throwsOnClick) return false;
    press(event);
    return m_pressedAt.has_value();
}

bool PlayTool::move(const QMouseEvent& event) {
    if (!m_controller.isInPlay()) return false;
    m_pointer = event.position();
    m_isPointing = true;
    if (m_pressedAt) {
        const QPoint displacement = (event.position() - *m_pressedAt).toPoint();
        if (displacement.manhattanLength() < QApplication::startDragDistance()) return false;
        m_controller.grabAlong(m_viewport.rayAt(*m_pressedAt));
        m_pressedAt.reset();
        m_isGrabbing = true;
        updateAim();
    }
    if (m_isGrabbing) {
        m_controller.dragAlong(ray());
        return true;
    }
    updateAim();
    return false;
}

bool PlayTool::release(const QMouseEvent& event) {
    if (!m_controller.isInPlay() || event.button() != Qt::LeftButton) return false;
    const bool isClick = std::exchange(m_pressedAt, std::nullopt).has_value();
    if (isClick && m_controller.toolSettings().throwsOnClick) {
        throwWith(0.0);
        return true;
    }
    if (!m_isGrabbing) return false;
    m_isGrabbing = false;
    m_controller.release();
    updateAim();
    return true;
}

}  // namespace rubble

#include "moc_PlayTool.cpp"
