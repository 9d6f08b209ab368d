#include "editor/view3d/TimelineBar.h"

#include "editor/document/ShownText.h"
#include "editor/play/PlayController.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kHandle = 6.0;  // this and the following: points
constexpr double kTrackHeight = 6.0;
constexpr double kMarkHeight = 12.0;
constexpr int kTextMargin = 10;
constexpr double kMarkTolerance = 4.0;
const QColor kBreak(214, 69, 48);

QString timeText(double seconds) { return TimelineBar::tr("%1 s").arg(QLocale().toString(seconds, 'f', 2)); }

}  // namespace

TimelineBar::TimelineBar(PlayController& controller, QWidget* parent) : QWidget(parent), m_controller(controller) {
    setFocusPolicy(Qt::StrongFocus);
    setObjectName("timeline");
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(tr("Arrow keys move by a step, with Shift by a second; Home and End go to the ends."));
    setStatusTip(tr("Drag to seek; input at an earlier step discards all later steps"));
    connect(&controller, &PlayController::frameChanged, this, qOverload<>(&QWidget::update));
    connect(&controller, &PlayController::impactsChanged, this, qOverload<>(&QWidget::update));
}

QSize TimelineBar::sizeHint() const { return {300, std::max(26, fontMetrics().height() + 8)}; }

/// Between the time labels at both ends.
QRectF TimelineBar::track() const {
    const int text = fontMetrics().horizontalAdvance(timeText(8888.88)) + kTextMargin;
    return QRectF(text + kHandle, (height() - kTrackHeight) / 2.0, std::max(20.0, width() - 2.0 * (text + kHandle)),
                  kTrackHeight);
}

double TimelineBar::positionOf(std::uint64_t step) const {
    const double length = static_cast<double>(std::max<std::uint64_t>(1, m_controller.frame()->length));
    return track().left() + track().width() * static_cast<double>(step) / length;
}

std::uint64_t TimelineBar::stepAt(double x) const {
    const double fraction = std::clamp((x - track().left()) / track().width(), 0.0, 1.0);
    return static_cast<std::uint64_t>(std::lround(fraction * static_cast<double>(m_controller.frame()->length)));
}

void TimelineBar::seekTo(double x) {
    if (m_controller.frame()) m_controller.seek(stepAt(x));
}

void TimelineBar::paintEvent(QPaintEvent*) {
    if (!m_controller.frame()) return;
    const PlayFrame& frame = *m_controller.frame();
    const double dt = m_controller.thread().stepLength();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect inside = rect().adjusted(kTextMargin, 0, -kTextMargin, 0);
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, timeText(static_cast<double>(frame.step) * dt));
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, timeText(static_cast<double>(frame.length) * dt));
    const QRectF whole = track();
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(whole, 3, 3);
    QRectF played = whole;
    played.setRight(positionOf(frame.step));
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawRoundedRect(played, 3, 3);
    painter.setBrush(kBreak);
    for (const ImpactRecord& broken : m_controller.impacts()) {
        if (!broken.isBreak()) continue;
        painter.drawRect(QRectF(positionOf(broken.step) - 1.0, (height() - kMarkHeight) / 2.0, 2.0, kMarkHeight));
    }
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::WindowText), 1.5));
    painter.setBrush(palette().color(QPalette::Button));
    painter.drawEllipse(QPointF(positionOf(frame.step), height() / 2.0), kHandle, kHandle);
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) seekTo(event->position().x());
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) seekTo(event->position().x());
}

void TimelineBar::keyPressEvent(QKeyEvent* event) {
    if (!m_controller.frame()) return QWidget::keyPressEvent(event);
    const PlayFrame& frame = *m_controller.frame();
    const auto second = static_cast<std::uint64_t>(std::lround(1.0 / m_controller.thread().stepLength()));
    const std::uint64_t by = event->modifiers().testFlag(Qt::ShiftModifier) ? second : 1;
    switch (event->key()) {
        case Qt::Key_Left: return m_controller.seek(frame.step - std::min(frame.step, by));
        case Qt::Key_Right: return m_controller.seek(frame.step + by);
        case Qt::Key_Home: return m_controller.seek(0);
        case Qt::Key_End: return m_controller.seek(frame.length);
        default: QWidget::keyPressEvent(event);
    }
}

/// Shows a tooltip with the time and the breaks at the pointer.
bool TimelineBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !m_controller.frame()) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const double dt = m_controller.thread().stepLength();
    QStringList lines{timeText(static_cast<double>(stepAt(help->pos().x())) * dt)};
    for (const ImpactRecord& broken : m_controller.impacts()) {
        if (!broken.isBreak()) continue;
        if (std::abs(positionOf(broken.step) - help->pos().x()) <= kMarkTolerance && lines.size() < 8) {
            lines << tr("%1 broke at %2").arg(nameText(broken.name), timeText(static_cast<double>(broken.step) * dt));
        }
    }
    QToolTip::showText(help->globalPos(), toolTipText(lines.join('\n')), this);
    return true;
}

}  // namespace rubble

#include "moc_TimelineBar.cpp"
