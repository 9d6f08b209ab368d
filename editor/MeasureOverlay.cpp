#include "editor/MeasureOverlay.h"

#include "editor/HudPlate.h"
#include "editor/ViewMeasure.h"
#include "editor/canvas/LabelPainting.h"
#include "viewport/ViewportWidget.h"

#include <QEvent>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

const QColor kLine(76, 194, 255);
const QColor kUnderline(10, 14, 20, 190);
constexpr double kRadius = 4.5;  // this and the following: points
constexpr double kCorner = 6.0;
constexpr int kLabelOffset = 16;
constexpr int kMargin = 6;

}  // namespace

MeasureOverlay::MeasureOverlay(const ViewMeasure& measure, ViewportWidget& viewport)
    : QWidget(&viewport), m_measure(measure), m_viewport(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Measure"));
    viewport.installEventFilter(this);
    resize(viewport.size());
    hide();
    connect(&measure, &ViewMeasure::changed, this, [this] {
        setVisible(m_measure.isOn());
        raise();
        update();
    });
    connect(&viewport, &ViewportWidget::cameraChanged, this, qOverload<>(&QWidget::update));
}

bool MeasureOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) resize(parentWidget()->size());
    return QWidget::eventFilter(watched, event);
}

void MeasureOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto seen = [&](const std::optional<ViewMeasure::Point>& point) {
        return point ? m_viewport.pointOf(point->place) : std::nullopt;
    };
    const auto& end = m_measure.to() ? m_measure.to() : m_measure.pointed();
    const std::optional<QPointF> from = seen(m_measure.from()), to = seen(end);
    if (from && to) paintLine(painter, *from, *to);
    if (from) paintPoint(painter, *from, m_measure.from()->isCorner);
    if (to) paintPoint(painter, *to, end->isCorner);
    if (!m_measure.from() || !end || !to) return;
    const Vec3 along = end->place - m_measure.from()->place;
    paintLabel(painter, *to,
               {lengthText(glm::length(along)),
                tr("x %1   y %2   z %3")
                    .arg(lengthText(std::abs(along.x)), lengthText(std::abs(along.y)), lengthText(std::abs(along.z)))});
}

void MeasureOverlay::paintLine(QPainter& painter, QPointF from, QPointF to) const {
    for (const auto& [colour, width] : {std::pair(kUnderline, 4.5), std::pair(kLine, 2.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
    }
}

/// A square on a corner, a ring elsewhere.
void MeasureOverlay::paintPoint(QPainter& painter, QPointF at, bool isCorner) const {
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(kUnderline, 4.0), std::pair(kLine, 2.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        if (isCorner) {
            painter.drawRect(QRectF(at.x() - kCorner, at.y() - kCorner, 2.0 * kCorner, 2.0 * kCorner));
        } else {
            painter.drawEllipse(at, kRadius, kRadius);
        }
    }
}

void MeasureOverlay::paintLabel(QPainter& painter, QPointF beside, const QStringList& lines) const {
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics plain(font()), title(bold);
    const int width = std::max(title.horizontalAdvance(lines[0]), plain.horizontalAdvance(lines[1]));
    QRect plate(beside.toPoint() + QPoint(kLabelOffset, kLabelOffset),
                QSize(width + 2 * kPlatePadding, title.height() + plain.height() + 2 * kPlatePadding - 4));
    if (plate.right() > this->width() - kMargin) plate.moveRight(static_cast<int>(beside.x()) - kLabelOffset);
    if (plate.bottom() > height() - kMargin) plate.moveBottom(static_cast<int>(beside.y()) - kLabelOffset);
    plate.moveLeft(std::max(plate.left(), kMargin));
    plate.moveTop(std::max(plate.top(), kMargin));
    const QRect inside = paintPlate(painter, plate);
    painter.setPen(kPlateInk);
    painter.setFont(bold);
    painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, lines[0]);
    painter.setFont(font());
    painter.setPen(kPlateFaintInk);
    painter.drawText(inside, Qt::AlignBottom | Qt::AlignLeft, lines[1]);
}

}  // namespace rubble
