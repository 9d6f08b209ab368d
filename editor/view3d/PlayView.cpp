#include "editor/view3d/PlayView.h"

#include "editor/document/ShownText.h"
#include "editor/play/EventText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/widget/ViewportWidget.h"

#include <QEvent>
#include <QLocale>

#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr int kMilliseconds = 16;  // between frames

QString playTimeText(double seconds) { return fixedQuantity(seconds, 2, Units::seconds()); }

QString millisecondsText(double milliseconds, int decimals) {
    constexpr int kDecimalsOfSecond = 3;
    return fixedQuantity(1e-3 * milliseconds, kDecimalsOfSecond + decimals, Units::milliseconds());
}

}  // namespace

PlayView::PlayView(PlayController& controller, ViewportWidget& viewport)
    : QObject(&viewport),
      m_controller(controller),
      m_viewport(viewport),
      m_tool(controller, viewport),
      m_hud(new PlayHud(&viewport)) {
    m_timer.setInterval(kMilliseconds);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &PlayView::refresh);
    connect(&controller, &PlayController::stateChanged, this, &PlayView::updateState);
    connect(&controller, &PlayController::frameChanged, this, [this] {
        if (!m_timer.isActive() && isShown()) refresh();
    });
    connect(&m_tool, &PlayTool::chargingStarted, this, &PlayView::updateTimer);
    viewport.installEventFilter(this);
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] { m_hud->setContent(content()); });
    connect(&viewport, &ViewportWidget::drawn, this, [this] { ++m_counted; });
}

void PlayView::updateState() {
    m_hud->setVisible(m_controller.isInPlay());
    if (std::exchange(m_isInPlay, m_controller.isInPlay()) != m_isInPlay) restartCount();
    if (!m_isInPlay) {
        m_timer.stop();
        m_shown = nullptr;
        m_viewport.setStepFraction(1.0);
    }
    refresh();
}

/// A minimized window is visible to Qt.
bool PlayView::isShown() const { return m_viewport.isVisible() && !m_viewport.window()->isMinimized(); }

/// Whether the next refresh() may show something else, with the same frame or the one that follows by itself.
bool PlayView::isAnimated() const {
    if (!m_controller.isInPlay()) return false;
    if (m_tool.charge()) return true;
    if (isMoving(m_viewport.scene()) && m_controller.stepFraction() < 1.0) return true;
    return m_controller.isPlaying() && m_controller.frame() && !m_controller.frame()->isAtRest;
}

void PlayView::updateTimer() {
    const bool isOn = isShown() && isAnimated();
    if (isOn == m_timer.isActive()) return;
    restartCount();
    isOn ? m_timer.start() : m_timer.stop();
}

/// Follows the view and its window, of which only the latter is notified that it is minimized.
bool PlayView::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::Show && type != QEvent::Hide && type != QEvent::WindowStateChange)
        return QObject::eventFilter(watched, event);
    m_viewport.window()->installEventFilter(this);  // replaces an earlier one
    if (isShown()) refresh();
    updateTimer();
    return QObject::eventFilter(watched, event);
}

void PlayView::refresh() {
    if (!m_controller.isInPlay()) return;
    showFrame();
    m_viewport.setStepFraction(isMoving(m_viewport.scene()) ? m_controller.stepFraction() : 1.0);
    if (m_tool.charge()) m_tool.updateAim();
    updateFrameRate();
    updateTimer();
    m_hud->setContent(content());
}

void PlayView::showFrame() {
    const std::optional<PlayFrame>& frame = m_controller.frame();
    if (!frame || frame->scene.get() == m_shown) return;
    m_shown = frame->scene.get();
    m_viewport.setScene(frame->scene);
}

void PlayView::setStatisticsShown(bool isOn) {
    m_hasStatistics = isOn;
    m_hud->setContent(content());
}

/// Frames are counted while the session is shown.
void PlayView::restartCount() {
    m_countedSince = m_controller.thread().now();
    m_counted = 0;
    m_framesPerSecond.reset();
}

void PlayView::updateFrameRate() {
    const double passed = m_controller.thread().now() - m_countedSince;
    if (passed < 0.5) return;
    m_framesPerSecond.reset();
    if (m_counted > 0) m_framesPerSecond = static_cast<int>(std::lround(m_counted / passed));
    m_countedSince += passed;
    m_counted = 0;
}

QStringList PlayView::statisticsLines() const {
    const PlayFrame& frame = *m_controller.frame();
    const PlayStatistics& statistics = frame.statistics;
    const double dt = m_controller.thread().stepLength();
    const std::span<const EventRef> breaks = m_controller.events().breaks(frame.step);
    const QString rate = m_framesPerSecond ? tr("%L1 fps").arg(*m_framesPerSecond) : tr("– fps");
    QString broken = textOf(countsOf(breaks));
    if (!breaks.empty())
        broken = tr("%1, the last computed in %2").arg(broken, millisecondsText(breaks.back()->milliseconds, 3));
    const QString separator = QStringLiteral(" · ");
    return {
        tr("%1 · step %L2").arg(playTimeText(static_cast<double>(frame.step) * dt)).arg(frame.step) + separator +
            tr("%1 per step").arg(millisecondsText(statistics.cost.total(), 2)) + separator + rate,
        tr("bodies: %L1, asleep: %L2").arg(statistics.bodies).arg(statistics.asleep) + separator +
            tr("pairs: %L1, contact points: %L2").arg(statistics.candidatePairs).arg(statistics.contactPoints),
        broken + separator + tr("energy %1").arg(localizedQuantity(QuantityKind::Energy, statistics.energy)),
    };
}

QString PlayView::collapseText(const CollapseForecast& collapse) {
    const QString name = nameText(collapse.name);
    if (collapse.bodies == 0) return tr("Without %1, nothing would fall").arg(name);
    const QString falling = tr("Without %1, %Ln bodies would fall: %2", nullptr, static_cast<int>(collapse.bodies))
                                .arg(name, localizedQuantity(QuantityKind::Mass, collapse.mass));
    if (std::isinf(collapse.first)) return falling;
    if (std::isinf(collapse.last)) return tr("%1, the first for %2").arg(falling, playTimeText(collapse.first));
    return tr("%1, for up to %2").arg(falling, playTimeText(collapse.last));
}

void PlayView::setGrab(PlayHud::Content& content, const GrabbedBody& grabbed) const {
    const std::optional<QPointF> from = m_viewport.pointOf(grabbed.point), to = m_viewport.pointOf(grabbed.target);
    if (!from || !to) return;
    content.spring = QLineF(*from, *to);
    content.isTooHeavy = grabbed.isTooHeavy();
    const QString mass = localizedQuantity(QuantityKind::Mass, grabbed.mass);
    content.grabText = content.isTooHeavy
                           ? tr("Too heavy to lift: %1 weighs %2, the grab pulls with up to %3 (see Play Tools)")
                                 .arg(mass, localizedQuantity(QuantityKind::Force, grabbed.weight),
                                      localizedQuantity(QuantityKind::Force, grabbed.force))
                           : mass;
}

PlayHud::Content PlayView::content() const {
    PlayHud::Content content{.isRunning = m_controller.isPlaying()};
    switch (m_controller.state()) {
        case PlayState::Stopped: return content;
        case PlayState::Preparing: content.title = tr("Preparing…"); break;
        case PlayState::Paused: content.title = tr("Paused"); break;
        case PlayState::Playing:
            content.title =
                m_controller.frame() && m_controller.frame()->isAtRest ? tr("Playing · at rest") : tr("Playing");
            break;
    }
    if (m_controller.timeScale() != 1.0)
        content.title += tr(" at %1×").arg(QLocale().toString(m_controller.timeScale()));
    if (!m_controller.hasDestruction()) content.title += tr(" · destruction off");
    content.hint =
        (m_controller.toolSettings().throwsOnClick ? tr("Click: throw · ") : QString()) +
        tr("F: throw, hold to charge · H: hammer · X: blast, Ctrl and wheel: its radius · Drag: grab · P: pause · "
           "Comma, period: step · "
           "L: loop · R: restart · Esc: stop");
    const std::optional<PlayFrame>& frame = m_controller.frame();
    if (!frame) return content;
    if (m_hasStatistics) content.statistics = statisticsLines();
    if (frame->collapse) content.collapse = collapseText(*frame->collapse);
    content.hasHeat = m_controller.overlays().hasHeat;
    content.hasBonds = m_controller.overlays().hasBonds;
    content.isForecast = frame->hasForecast;
    content.charge = m_tool.charge();
    if (content.charge && frame->aimed) content.chargeText = fixedQuantity(frame->aimed->speed, 1, Units::speeds());
    if (frame->grabbed) setGrab(content, *frame->grabbed);
    if (!frame->trajectory) return content;
    const std::vector<Vec3>& points = frame->trajectory->points;
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (const auto line = m_viewport.lineOf(points[k - 1], points[k])) content.trajectory.push_back(*line);
    }
    if (frame->trajectory->hit) content.hit = m_viewport.pointOf(points.back());
    return content;
}

}  // namespace rubble

#include "moc_PlayView.cpp"
