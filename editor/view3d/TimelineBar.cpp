#include "editor/view3d/TimelineBar.h"

#include "editor/document/ShownText.h"
#include "editor/play/EventText.h"
#include "editor/play/PlayController.h"
#include "editor/view3d/TimelineMarks.h"
#include "editor/widgets/AccessibleRole.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/RoundStep.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {

namespace {

constexpr double kHandle = 6.0;  // this and the following: points
constexpr double kTrackHeight = 6.0;
constexpr double kLoopHeight = 14.0;
constexpr double kTop = 9.0;  // above the handle, which is lower than the marks
constexpr double kTick = 4.0;
constexpr double kMinTickDistance = 70.0;
constexpr int kTextMargin = 10;
constexpr int kMinTrack = 80;
constexpr double kMarkTolerance = 4.0;
constexpr double kZoomPerNotch = 1.25;
constexpr std::size_t kMaxTipEvents = 8;
const QColor kLoop(242, 140, 40);

QString timeText(double seconds) { return fixedQuantity(seconds, 2, Units::seconds()); }

}  // namespace

TimelineBar::TimelineBar(PlayController& controller, QWidget* parent) : QWidget(parent), m_controller(controller) {
    setFocusPolicy(Qt::StrongFocus);
    setObjectName("timeline");
    setAccessibleName(tr("Timeline"));
    setAccessibleRole(*this, QAccessible::Slider);
    setAccessibleDescription(
        tr("Arrow keys move by a step, with Shift by a second; Page Up and Page Down go to the previous and the next "
           "event; Home and End go to the ends; plus and minus zoom, 0 shows everything."));
    setStatusTip(tr("Drag to seek, turn the wheel to zoom, drag with the middle button to pan"));
    connect(&controller, &PlayController::frameChanged, this, &TimelineBar::refreshFrame);
    connect(&controller, &PlayController::eventsChanged, this, qOverload<>(&QWidget::update));
    connect(&controller, &PlayController::stateChanged, this, [this] {
        if (!m_controller.hasSession()) m_span = {};
    });
}

/// Keeps the displayed step visible: always after a seek, while playing unless the user has panned away.
void TimelineBar::refreshFrame() {
    const PlayFrame& frame = *m_controller.frame();
    const bool wasVisible = m_span.contains(static_cast<double>(m_step));
    m_span.setLength(static_cast<double>(frame.length));
    if (frame.step != m_step && (wasVisible || !m_controller.isPlaying())) {
        if (!m_span.contains(static_cast<double>(frame.step))) m_span.reveal(static_cast<double>(frame.step));
    }
    m_step = frame.step;
    update();
}

void TimelineBar::zoom(double step, double factor) {
    m_span.zoom(step, factor);
    update();
}

void TimelineBar::zoomIn() {
    const auto step = static_cast<double>(m_step);
    zoom(m_span.contains(step) ? step : m_span.first() + m_span.width() / 2.0, kZoomPerNotch * kZoomPerNotch);
}

void TimelineBar::zoomOut() {
    const auto step = static_cast<double>(m_step);
    zoom(m_span.contains(step) ? step : m_span.first() + m_span.width() / 2.0, 1.0 / (kZoomPerNotch * kZoomPerNotch));
}

void TimelineBar::fit() {
    m_span.fit();
    update();
}

/// The labels of the ticks are below the track.
QSize TimelineBar::sizeHint() const {
    return {300, static_cast<int>(kTop + 2.0 * kHandle + kTick) + fontMetrics().height() + 6};
}

int TimelineBar::labelWidth() const { return fontMetrics().horizontalAdvance(timeText(8888.88)) + kTextMargin; }

/// A narrow bar shows the displayed time, but not its length.
bool TimelineBar::hasLengthLabel() const { return width() >= 2 * labelWidth() + kMinTrack; }

/// Between the time labels at both ends.
QRectF TimelineBar::track() const {
    const double left = labelWidth() + kHandle, right = kHandle + (hasLengthLabel() ? labelWidth() : kTextMargin);
    return QRectF(left, kTop + kHandle - kTrackHeight / 2.0, std::max(20.0, width() - left - right), kTrackHeight);
}

double TimelineBar::positionOf(double step) const {
    return track().left() + track().width() * (step - m_span.first()) / m_span.width();
}

double TimelineBar::stepAt(double x) const {
    return m_span.first() + m_span.width() * (x - track().left()) / track().width();
}

/// The events that are marked at a position.
std::span<const EventRef> TimelineBar::eventsAt(double x) const {
    return eventsBetween(m_controller.shownEvents(), stepAt(x - kMarkTolerance), stepAt(x + kMarkTolerance));
}

/// The break under a position, the nearest if there are several.
std::optional<std::uint64_t> TimelineBar::breakAt(double x) const {
    std::optional<std::uint64_t> nearest;
    const auto distance = [&](std::uint64_t step) { return std::abs(positionOf(static_cast<double>(step)) - x); };
    for (const EventRef& event : eventsAt(x)) {
        const std::uint64_t step = event->record.step;
        if (event->isBreak() && (!nearest || distance(step) < distance(*nearest))) nearest = step;
    }
    return nearest;
}

void TimelineBar::seekTo(double x) {
    if (!m_controller.frame()) return;
    const double step = std::clamp(stepAt(x), m_span.first(), m_span.last());
    m_controller.seek(static_cast<std::uint64_t>(std::lround(step)));
}

void TimelineBar::paintEvent(QPaintEvent*) {
    if (!m_controller.frame()) return;
    const PlayFrame& frame = *m_controller.frame();
    const double dt = m_controller.thread().stepLength();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    QRectF line(0.0, track().center().y() - fontMetrics().height(), width(), 2.0 * fontMetrics().height());
    line.adjust(kTextMargin, 0.0, -kTextMargin, 0.0);
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, timeText(static_cast<double>(frame.step) * dt));
    if (hasLengthLabel())
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, timeText(static_cast<double>(frame.length) * dt));
    paintTicks(painter);
    paintTrack(painter);
    paintMarks(painter);
    if (!m_span.contains(static_cast<double>(frame.step))) return;
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::WindowText), 1.5));
    painter.setBrush(palette().color(QPalette::Button));
    painter.drawEllipse(QPointF(positionOf(static_cast<double>(frame.step)), track().center().y()), kHandle, kHandle);
}

/// What was played up to the displayed step, and below it the visible part of the whole.
void TimelineBar::paintTrack(QPainter& painter) const {
    const PlayFrame& frame = *m_controller.frame();
    const QRectF whole = track();
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(whole, 3, 3);
    QRectF played = whole;
    played.setRight(std::clamp(positionOf(static_cast<double>(frame.step)), whole.left(), whole.right()));
    painter.setBrush(palette().color(QPalette::Highlight));
    if (played.width() > 0.0) painter.drawRoundedRect(played, 3, 3);
    if (m_span.isWhole()) return;
    const double length = static_cast<double>(frame.length);
    const double scale = whole.width() / length;
    const QRectF overview(whole.left(), height() - 2.0, whole.width(), 2.0);
    painter.fillRect(overview, palette().color(QPalette::Mid));
    painter.fillRect(QRectF(overview.left() + scale * m_span.first(), overview.top(),
                            std::max(4.0, scale * m_span.width()), overview.height()),
                     palette().color(QPalette::Highlight));
}

/// The loop as a bracket, the events, and forks of branches as triangles that point at the track.
void TimelineBar::paintMarks(QPainter& painter) const {
    const PlayFrame& frame = *m_controller.frame();
    const QRectF whole = track();
    const double middle = whole.center().y();
    painter.save();
    painter.setClipRect(QRectF(whole.left() - kHandle, 0.0, whole.width() + 2.0 * kHandle, height()));
    if (frame.loop) {
        const QRectF loop(QPointF(positionOf(static_cast<double>(frame.loop->first)), middle - kLoopHeight / 2.0),
                          QPointF(positionOf(static_cast<double>(frame.loop->last)), middle + kLoopHeight / 2.0));
        painter.setPen(QPen(kLoop, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(loop, 3, 3);
    }
    rubble::paintMarks(painter, timelineMarks(m_controller.shownEvents(), m_span.first(), m_span.last(), whole.width()),
                       whole);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    for (const PlayBranch& branch : frame.branches) {
        const double x = positionOf(static_cast<double>(branch.fork)), y = middle + kTrackHeight / 2.0;
        painter.drawPolygon(QPolygonF({QPointF(x, y), QPointF(x - 4.0, y + 5.0), QPointF(x + 4.0, y + 5.0)}));
    }
    painter.restore();
}

void TimelineBar::paintTicks(QPainter& painter) const {
    const double dt = m_controller.thread().stepLength();
    const double seconds = std::max(1e-6, m_span.width() * dt);
    const double every = roundStep(kMinTickDistance * seconds / track().width());
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(every) - 1e-9)), 0, 4);
    const double top = track().bottom() + kHandle - kTrackHeight / 2.0 + 2.0;
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    painter.setFont(small);
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.7F);
    painter.setPen(colour);
    const auto first = static_cast<long long>(std::ceil(m_span.first() * dt / every - 1e-9));
    const auto last = static_cast<long long>(std::floor(m_span.last() * dt / every + 1e-9));
    for (long long k = first; k <= last; ++k) {
        const double x = positionOf(static_cast<double>(k) * every / dt);
        painter.drawLine(QPointF(x, top), QPointF(x, top + kTick));
        painter.drawText(QRectF(x - 60.0, top + kTick, 120.0, QFontMetricsF(small).height()),
                         Qt::AlignHCenter | Qt::AlignTop,
                         QLocale().toString(static_cast<double>(k) * every, 'f', decimals));
    }
    painter.setFont(font());
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) seekTo(event->position().x());
    if (event->button() == Qt::MiddleButton) m_pannedFrom = event->position().x();
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) return seekTo(event->position().x());
    if (!event->buttons().testFlag(Qt::MiddleButton)) return;
    m_span.pan(stepAt(m_pannedFrom) - stepAt(event->position().x()));
    m_pannedFrom = event->position().x();
    update();
}

void TimelineBar::mouseDoubleClickEvent(QMouseEvent* event) {
    const std::optional<std::uint64_t> broken = breakAt(event->position().x());
    if (event->button() == Qt::LeftButton && broken) m_controller.loopAround(*broken);
}

/// Zooms at the pointer; with Shift, or sideways, pans by a tenth a notch.
void TimelineBar::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta();
    if (angle.x() != 0 || event->modifiers().testFlag(Qt::ShiftModifier)) {
        const double notches = (angle.x() != 0 ? angle.x() : angle.y()) / double{QWheelEvent::DefaultDeltasPerStep};
        m_span.pan(-0.1 * notches * m_span.width());
        return update();
    }
    zoom(stepAt(event->position().x()), std::pow(kZoomPerNotch, angle.y() / double{QWheelEvent::DefaultDeltasPerStep}));
}

void TimelineBar::keyPressEvent(QKeyEvent* event) {
    if (!m_controller.frame()) return QWidget::keyPressEvent(event);
    const auto second = static_cast<std::int64_t>(std::lround(1.0 / m_controller.thread().stepLength()));
    const std::int64_t by = event->modifiers().testFlag(Qt::ShiftModifier) ? second : 1;
    switch (event->key()) {
        case Qt::Key_Left: return m_controller.seekBy(-by);
        case Qt::Key_Right: return m_controller.seekBy(by);
        case Qt::Key_Home: return m_controller.seek(0);
        case Qt::Key_End: return m_controller.seek(m_controller.frame()->length);
        case Qt::Key_PageUp: return m_controller.previousEvent();
        case Qt::Key_PageDown: return m_controller.nextEvent();
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoomIn();
        case Qt::Key_Minus: return zoomOut();
        case Qt::Key_0: return fit();
        default: QWidget::keyPressEvent(event);
    }
}

void TimelineBar::contextMenuEvent(QContextMenuEvent* event) {
    if (!m_controller.frame()) return;
    QMenu menu;
    if (const std::optional<std::uint64_t> broken = breakAt(event->pos().x())) {
        menu.addAction(tr("Loop Around This Break"), this, [this, broken] { m_controller.loopAround(*broken); });
    }
    if (m_controller.frame()->loop) menu.addAction(tr("End Loop"), &m_controller, &PlayController::endLoop);
    if (!menu.isEmpty()) menu.addSeparator();
    menu.addAction(tr("Show All"), this, &TimelineBar::fit)->setEnabled(!m_span.isWhole());
    menu.exec(event->globalPos());
}

/// What the marks at a position stand for: breaks first, then the others by energy.
QStringList TimelineBar::eventLines(double x) const {
    const std::span<const EventRef> here = eventsAt(x);
    std::vector<EventRef> listed(std::min(here.size(), kMaxTipEvents));
    std::ranges::partial_sort_copy(here, listed, [](const EventRef& a, const EventRef& b) {
        const auto rank = [](const EventRef& event) {
            return std::tuple(!event->isBreak(), -event->record.energy, event->record.step);
        };
        return rank(a) < rank(b);
    });
    const double dt = m_controller.thread().stepLength();
    QStringList lines;
    for (const EventRef& event : listed) {
        lines << tr("%1: %2").arg(timeText(static_cast<double>(event->record.step) * dt), sentenceOf(*event));
    }
    if (here.size() > listed.size()) {
        lines << tr("and %Ln other event(s)", nullptr, static_cast<int>(here.size() - listed.size()));
    }
    return lines;
}

/// Shows a tooltip with the time, and the events and forks at the pointer.
bool TimelineBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !m_controller.frame()) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const double dt = m_controller.thread().stepLength();
    const auto isHere = [&](std::uint64_t step) {
        return std::abs(positionOf(static_cast<double>(step)) - help->pos().x()) <= kMarkTolerance;
    };
    const double shown = std::clamp(stepAt(help->pos().x()), m_span.first(), m_span.last());
    QStringList lines{timeText(std::round(shown) * dt)};
    lines << eventLines(help->pos().x());
    const auto forks = std::ranges::count_if(m_controller.frame()->branches,
                                             [&](const PlayBranch& branch) { return isHere(branch.fork); });
    if (forks > 0) lines << tr("%Ln earlier timeline(s) from here", nullptr, static_cast<int>(forks));
    QToolTip::showText(help->globalPos(), toolTipText(lines.join('\n')), this);
    return true;
}

}  // namespace rubble

#include "moc_TimelineBar.cpp"
