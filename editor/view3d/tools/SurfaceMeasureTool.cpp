#include "editor/view3d/tools/SurfaceMeasureTool.h"

#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/scene/SurfacePicking.h"
#include "viewport/widget/OverlayPlate.h"
#include "viewport/widget/ViewportWidget.h"

#include <QCursor>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kSnapDistance = 12.0;  // this and the following: points
const QColor kMeasureLine(76, 194, 255);
const QColor kMeasureUnderline(10, 14, 20, 190);
constexpr double kRadius = 4.5;
constexpr double kCorner = 6.0;
constexpr int kMeasureLabelOffset = 16;
constexpr int kMeasureMargin = 6;

void paintLine(QPainter& painter, QPointF from, QPointF to) {
    for (const auto& [colour, width] : {std::pair(kMeasureUnderline, 4.5), std::pair(kMeasureLine, 2.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
    }
}

/// A square on a corner, a ring elsewhere.
void paintPoint(QPainter& painter, QPointF at, bool isCorner) {
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(kMeasureUnderline, 4.0), std::pair(kMeasureLine, 2.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        if (isCorner) {
            painter.drawRect(QRectF(at.x() - kCorner, at.y() - kCorner, 2.0 * kCorner, 2.0 * kCorner));
        } else {
            painter.drawEllipse(at, kRadius, kRadius);
        }
    }
}

/// Paints two lines on a plate beside a point, within the view.
void paintLabel(QPainter& painter, QPointF beside, const QString& title, const QString& detail, QSize viewSize) {
    const QFont font = painter.font();
    QFont bold = font;
    bold.setBold(true);
    const QFontMetrics plain(font), strong(bold);
    const int width = std::max(strong.horizontalAdvance(title), plain.horizontalAdvance(detail));
    QRect plate(beside.toPoint() + QPoint(kMeasureLabelOffset, kMeasureLabelOffset),
                QSize(width + 2 * kPlatePadding, strong.height() + plain.height() + 2 * kPlatePadding - 4));
    if (plate.right() > viewSize.width() - kMeasureMargin)
        plate.moveRight(static_cast<int>(beside.x()) - kMeasureLabelOffset);
    if (plate.bottom() > viewSize.height() - kMeasureMargin)
        plate.moveBottom(static_cast<int>(beside.y()) - kMeasureLabelOffset);
    plate.moveLeft(std::max(plate.left(), kMeasureMargin));
    plate.moveTop(std::max(plate.top(), kMeasureMargin));
    const QRect inside = paintPlate(painter, plate);
    painter.setPen(kPlateText);
    painter.setFont(bold);
    painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, title);
    painter.setFont(font);
    painter.setPen(kPlateSecondaryText);
    painter.drawText(inside, Qt::AlignBottom | Qt::AlignLeft, detail);
}

bool isLeftClick(const QMouseEvent& event) {
    return event.button() == Qt::LeftButton && !event.modifiers().testFlag(Qt::AltModifier);
}

}  // namespace

SurfaceMeasureTool::SurfaceMeasureTool(ViewportWidget& viewport) : ViewportTool(&viewport), m_viewport(viewport) {
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] {
        if (m_isOn) updatePointed(m_pointer);
    });
}

void SurfaceMeasureTool::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    m_isOn = isOn;
    m_from.reset();
    m_to.reset();
    m_pointed.reset();
    if (isOn) {
        m_viewport.setCursor(Qt::CrossCursor);
        m_viewport.setFocus();
        updatePointed(m_viewport.mapFromGlobal(QCursor::pos()));
    } else {
        m_viewport.unsetCursor();
    }
    emit changed();
    emit onChanged(isOn);
    emitHint();
}

QString SurfaceMeasureTool::lengthText(double metres) const {
    return localizedQuantity(QuantityKind::Length, metres, m_units);
}

std::optional<double> SurfaceMeasureTool::distance() const {
    if (!m_from || !m_to) return std::nullopt;
    return glm::distance(m_from->position, m_to->position);
}

std::optional<SurfaceMeasureTool::Point> SurfaceMeasureTool::pointAt(QPointF pixel) const {
    const auto hit = surfaceHit(m_viewport.scene(), m_viewport.rayAt(pixel));
    if (!hit) return std::nullopt;
    const Vec2 at = m_viewport.devicePixelRatioF() * Vec2(pixel.x(), pixel.y());
    const auto corner = cornerNear(m_viewport.scene(), hit->body, m_viewport.shownCamera(), m_viewport.imageSize(), at,
                                   kSnapDistance * m_viewport.devicePixelRatioF());
    return corner ? Point{*corner, true} : Point{hit->point, false};
}

void SurfaceMeasureTool::updatePointed(QPointF pixel) {
    m_pointer = pixel;
    m_pointed = pointAt(pixel);
    emit changed();
}

/// Sets the next point; after a complete measurement, the first one of a new measurement.
void SurfaceMeasureTool::setPoint() {
    if (!m_pointed) return;
    if (!m_from || m_to) {
        m_from = m_pointed;
        m_to.reset();
    } else {
        m_to = m_pointed;
    }
    emit changed();
    emitHint();
}

bool SurfaceMeasureTool::cancel() {
    if (!m_isOn) return false;
    if (!m_from) {
        setOn(false);
        return true;
    }
    m_from.reset();
    m_to.reset();
    emit changed();
    emitHint();
    return true;
}

void SurfaceMeasureTool::emitHint() {
    if (!m_isOn) return emit hintChanged({});
    if (m_from && !m_to) return emit hintChanged(tr("Click: second point · Esc: start over"));
    emit hintChanged(m_to ? tr("Click: first point of a new measurement · Esc: clear")
                          : tr("Click: first point, snaps to corners · Esc: end"));
}

bool SurfaceMeasureTool::overridesShortcut(const QKeyEvent& event) const {
    return m_isOn && event.key() == Qt::Key_Escape;
}

bool SurfaceMeasureTool::keyPress(const QKeyEvent& event) { return overridesShortcut(event) && cancel(); }

/// Never consumed: the view can be navigated meanwhile.
bool SurfaceMeasureTool::move(const QMouseEvent& event) {
    if (m_isOn && event.buttons() == Qt::NoButton) updatePointed(event.position());
    return false;
}

bool SurfaceMeasureTool::press(const QMouseEvent& event) {
    if (!m_isOn || !isLeftClick(event)) return false;
    updatePointed(event.position());
    setPoint();
    return true;
}

bool SurfaceMeasureTool::release(const QMouseEvent& event) { return m_isOn && isLeftClick(event); }

void SurfaceMeasureTool::paint(QPainter& painter, QSize size) const {
    if (!m_isOn) return;
    const auto onScreen = [&](const std::optional<Point>& point) {
        return point ? m_viewport.pointOf(point->position) : std::nullopt;
    };
    const std::optional<Point>& end = m_to ? m_to : m_pointed;
    const std::optional<QPointF> from = onScreen(m_from), to = onScreen(end);
    if (from && to) paintLine(painter, *from, *to);
    if (from) paintPoint(painter, *from, m_from->isCorner);
    if (to) paintPoint(painter, *to, end->isCorner);
    if (!m_from || !end || !to) return;
    const Vec3 along = end->position - m_from->position;
    paintLabel(painter, *to, lengthText(glm::length(along)),
               tr("x %1   y %2   z %3")
                   .arg(lengthText(std::abs(along.x)), lengthText(std::abs(along.y)), lengthText(std::abs(along.z))),
               size);
}

QString SurfaceMeasureTool::accessibleText() const {
    return distance() ? tr("Distance %1").arg(lengthText(*distance())) : QString();
}

}  // namespace rubble

#include "moc_SurfaceMeasureTool.cpp"
