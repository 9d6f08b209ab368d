#include "editor/canvas/tools/MeasureTool.h"

#include "editor/canvas/painting/LabelPainting.h"
#include "editor/canvas/tools/Snapping.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QLocale>

#include <cmath>
#include <numbers>

namespace rubble {

namespace {

constexpr double kTick = 6.0;        // pixels, half the length of an end mark
constexpr double kArc = 28.0;        // pixels, radius of the arc that shows the angle
constexpr double kAngleStep = 15.0;  // degrees, with Ctrl
constexpr double kDegrees = 180.0 / std::numbers::pi;

double angleDegrees(Vec2 along) { return std::atan2(along.y, along.x) * kDegrees; }

}  // namespace

Vec2 MeasureTool::pointOf(const CanvasPointer& pointer) const {
    SnapTargets targets = outlineTargets(m_state);
    if (m_state.pattern) {
        const std::vector<Vec2>& seeds = m_state.pattern->seeds().positions;
        targets.points.insert(targets.points.end(), seeds.begin(), seeds.end());
    }
    const Vec2 point = snapped(m_state, pointer, targets);
    if (!m_isHeld || !pointer.modifiers.testFlag(Qt::ControlModifier)) return point;
    const Vec2 along = point - m_line->from;
    const double snappedAngle = std::round(angleDegrees(along) / kAngleStep) * kAngleStep / kDegrees;
    return m_line->from + std::hypot(along.x, along.y) * Vec2(std::cos(snappedAngle), std::sin(snappedAngle));
}

void MeasureTool::press(const CanvasPointer& pointer) {
    const Vec2 from = pointOf(pointer);
    m_line = {from, from};
    m_isHeld = true;
    emit changed();
}

void MeasureTool::move(const CanvasPointer& pointer) {
    if (!m_isHeld) return;
    m_line->to = pointOf(pointer);
    emit changed();
}

void MeasureTool::release(const CanvasPointer& pointer) {
    move(pointer);
    m_isHeld = false;
    if (m_line && m_line->from == m_line->to) m_line.reset();
    emit changed();
}

bool MeasureTool::cancel() {
    if (!m_line) return false;
    m_line.reset();
    m_isHeld = false;
    emit changed();
    return true;
}

void MeasureTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_line) return;
    const Vec2 along = m_line->to - m_line->from;
    const double length = std::hypot(along.x, along.y), angle = angleDegrees(along);
    const QPointF from = m_state.view.pixels(m_line->from), to = m_state.view.pixels(m_line->to);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.measure, 1.0, Qt::DotLine));
    painter.drawLine(from, from + QPointF(2.0 * kArc, 0.0));
    painter.drawArc(QRectF(from - QPointF(kArc, kArc), QSizeF(2.0 * kArc, 2.0 * kArc)), 0,
                    static_cast<int>(std::lround(16.0 * angle)));
    painter.setPen(QPen(colours.measure, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
    if (length > 0.0) {
        const QPointF across = kTick * QPointF(along.y, along.x) / length;
        painter.drawLine(from - across, from + across);
        painter.drawLine(to - across, to + across);
    }
    const auto text = [this](double metres) { return localizedQuantity(QuantityKind::Length, metres, m_state.units); };
    paintLabel(painter, to,
               {text(length), tr("x %1   y %2").arg(text(along.x), text(along.y)),
                tr("angle %1°").arg(QLocale().toString(angle, 'f', 1))},
               colours, colours.measure, m_state.view);
}

QString MeasureTool::hint() const {
    return m_isHeld ? tr("Release to finish · Ctrl: snap to 15° · Shift: no snapping")
                    : tr("Drag from one point to another to measure · Esc: clear");
}

void MeasureTool::fillMenu(QMenu& menu, const CanvasPointer&) {
    menu.addAction(tr("&Clear Measurement"), this, &MeasureTool::cancel)->setEnabled(m_line.has_value());
}

}  // namespace rubble

#include "moc_MeasureTool.cpp"
