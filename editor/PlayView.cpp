#include "editor/PlayView.h"

#include "viewport/ViewportWidget.h"

#include <QLocale>

namespace rubble {

namespace {

constexpr int kMilliseconds = 16;  // between pictures

QString number(double value, int digits) { return QLocale().toString(value, 'f', digits); }

/// 12 kJ.
QString energyText(double joule) {
    if (std::abs(joule) >= 1e6) return PlayView::tr("%1 MJ").arg(number(joule / 1e6, 2));
    if (std::abs(joule) >= 1e3) return PlayView::tr("%1 kJ").arg(number(joule / 1e3, 1));
    return PlayView::tr("%1 J").arg(number(joule, 1));
}

}  // namespace

PlayView::PlayView(PlayController& controller, ViewportWidget& viewport)
    : QObject(&viewport),
      m_controller(controller),
      m_viewport(viewport),
      m_hands(controller, viewport),
      m_hud(new PlayHud(&viewport)) {
    m_hud->hide();
    m_timer.setInterval(kMilliseconds);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &PlayView::refresh);
    connect(&controller, &PlayController::stateChanged, this, &PlayView::takeState);
    connect(&controller, &PlayController::framed, this, [this] {
        if (!m_timer.isActive()) refresh();
    });
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] { m_hud->setContent(content()); });
}

void PlayView::takeState() {
    m_hud->setVisible(m_controller.isOn());
    m_hud->raise();
    if (m_controller.isOn()) {
        m_timer.start();
    } else {
        m_timer.stop();
        m_shown = nullptr;
        m_viewport.setMoment(1.0);
    }
    refresh();
}

void PlayView::refresh() {
    if (!m_controller.isOn()) return;
    showFrame();
    m_viewport.setMoment(m_controller.share());
    if (m_hands.charge()) m_hands.aimAgain();
    countPicture();
    m_hud->setContent(content());
}

void PlayView::showFrame() {
    const std::optional<PlayFrame>& frame = m_controller.frame();
    if (!frame || frame->scene.get() == m_shown) return;
    m_shown = frame->scene.get();
    m_viewport.setScene(frame->scene);
}

void PlayView::countPicture() {
    ++m_counted;
    const double passed = m_controller.thread().now() - m_countedSince;
    if (passed < 0.5) return;
    m_picturesPerSecond = static_cast<int>(std::lround(m_counted / passed));
    m_countedSince += passed;
    m_counted = 0;
}

QStringList PlayView::figures() const {
    const PlayFrame& frame = *m_controller.frame();
    const PlayFigures& told = frame.figures;
    QStringList lines;
    const double dt = m_controller.thread().stepLength();
    lines << tr("%1 s · step %L2").arg(number(static_cast<double>(frame.step) * dt, 2)).arg(frame.step);
    lines << tr("%1 ms a step · %2 pictures a second").arg(number(told.cost.total(), 2)).arg(m_picturesPerSecond);
    lines << tr("%L1 bodies, %L2 asleep").arg(told.bodies).arg(told.asleep);
    lines << tr("%L1 pairs · %L2 contact points").arg(told.candidatePairs).arg(told.contactPoints);
    const std::vector<ToldBreak>& breaks = m_controller.breaks();
    if (breaks.empty()) {
        lines << tr("nothing broke");
    } else {
        lines << tr("%L1 broke · last swap %2 ms").arg(breaks.size()).arg(number(breaks.back().milliseconds, 3));
    }
    lines << tr("energy %1").arg(energyText(told.energy));
    return lines;
}

PlayHud::Content PlayView::content() const {
    PlayHud::Content content{.isRunning = m_controller.isPlaying()};
    switch (m_controller.state()) {
        case PlayState::Stopped: return content;
        case PlayState::Preparing: content.title = tr("Preparing…"); break;
        case PlayState::Paused: content.title = tr("Paused"); break;
        case PlayState::Playing: content.title = tr("Playing"); break;
    }
    if (m_controller.timeScale() != 1.0)
        content.title += tr(" at %1×").arg(QLocale().toString(m_controller.timeScale()));
    if (!m_controller.hasDestruction()) content.title += tr(" · nothing breaks");
    content.hint =
        tr("F throws, held it charges · H strikes · X blows up · dragging grabs · P pauses · . steps · R resets · "
           "Esc stops");
    const std::optional<PlayFrame>& frame = m_controller.frame();
    if (!frame) return content;
    content.figures = figures();
    content.hasHeat = m_controller.overlays().hasHeat;
    content.isForecast = frame->flight.has_value();
    content.charge = m_hands.charge();
    if (content.charge) {
        content.chargeText = tr("%1 m/s").arg(number(*content.charge * m_controller.tools().thrown.speed, 1));
    }
    if (!frame->flight) return content;
    for (const Vec3& place : frame->flight->points) {
        if (const std::optional<QPointF> point = m_viewport.pointOf(place)) content.flight.push_back(*point);
    }
    content.isMet = frame->flight->hit.has_value();
    return content;
}

}  // namespace rubble
