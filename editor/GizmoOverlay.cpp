#include "editor/GizmoOverlay.h"

#include "viewport/ViewportWidget.h"

#include <QEvent>
#include <QOpenGLWidget>
#include <QPainter>
#include <QPainterPath>

namespace rubble {

namespace {

const QColor kAxisColours[] = {QColor(0xe5, 0x48, 0x4d), QColor(0x4c, 0xa8, 0x3d), QColor(0x3b, 0x7d, 0xe0)};
const QColor kFree(0xf2, 0xf2, 0xf2);
const QColor kHot(0xff, 0xc4, 0x2e);
const QColor kUnderline(0, 0, 0, 110);           // keeps lines apart from what is behind them, light or dark
constexpr double kLine = 2.5, kThickLine = 3.5;  // points
constexpr double kTip = 13.0, kTipWidth = 5.0;   // points
constexpr QPointF kLabelOffset{18.0, 22.0};
constexpr double kLabelMargin = 5.0;

QPointF qt(Vec2 point) { return {point.x, point.y}; }

QPolygonF polygonOf(const std::vector<Vec2>& line) {
    QPolygonF polygon;
    for (const Vec2 point : line) polygon.append(qt(point));
    return polygon;
}

QPolygonF tipOf(Vec2 from, Vec2 to) {
    const Vec2 along = glm::normalize(to - from);
    const Vec2 aside = kTipWidth * perpendicular(along), base = to - kTip * along;
    return {qt(to), qt(base + aside), qt(base - aside)};
}

}  // namespace

GizmoOverlay::GizmoOverlay(ViewportWidget& viewport) : QWidget(&viewport), m_viewport(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    viewport.installEventFilter(this);
    resize(viewport.size());
    raise();
    connect(&viewport, &ViewportWidget::cameraChanged, this, qOverload<>(&QWidget::update));
    // While the camera flies nobody is told of every picture.
    if (auto* canvas = viewport.findChild<QOpenGLWidget*>()) {
        connect(canvas, &QOpenGLWidget::frameSwapped, this, &GizmoOverlay::follow);
    }
}

void GizmoOverlay::setContent(const Content& content) {
    m_content = content;
    update();
}

std::optional<GizmoView> GizmoOverlay::view() const {
    if (!m_content.middle) return std::nullopt;
    return GizmoView{m_viewport.shownCamera(), {std::max(1, width()), std::max(1, height())}, *m_content.middle};
}

void GizmoOverlay::follow() {
    if (m_viewport.shownCamera() != m_painted) update();
}

bool GizmoOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) resize(m_viewport.size());
    return QWidget::eventFilter(watched, event);
}

void GizmoOverlay::paintEvent(QPaintEvent*) {
    m_painted = m_viewport.shownCamera();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintEdges(painter);
    if (const std::optional<GizmoView> drawn = view()) {
        for (const GizmoHandle handle : handlesOf(m_content.mode)) {
            if (!m_content.isDragging || handle == m_content.hot) paintHandle(painter, handle, *drawn);
        }
    }
    paintLabel(painter);
}

void GizmoOverlay::paintHandle(QPainter& painter, GizmoHandle handle, const GizmoView& view) const {
    const std::vector<Vec2> line = lineOf(handle, view);
    if (line.empty()) return;
    const bool isHot = handle == m_content.hot;
    const QColor colour = isHot ? kHot : axisOf(handle) ? kAxisColours[*axisOf(handle)] : kFree;
    const QPolygonF shape = polygonOf(line);
    const double width = isHot ? kThickLine : kLine;
    const auto pen = [](const QColor& ink, double wide) {
        return QPen(ink, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    QColor inside = colour;
    inside.setAlpha(isPlane(handle) ? 90 : 60);
    const bool isArea = isPlane(handle) || handle == GizmoHandle::MoveFreely;
    painter.setBrush(isArea ? QBrush(inside) : QBrush(Qt::NoBrush));
    painter.setPen(pen(kUnderline, width + 2.0));
    painter.drawPolyline(shape);
    painter.setPen(pen(colour, width));
    isArea ? painter.drawPolygon(shape) : painter.drawPolyline(shape);
    if (line.size() != 2) return;
    painter.setBrush(colour);
    painter.setPen(pen(kUnderline, 1.0));
    painter.drawPolygon(tipOf(line[0], line[1]));
}

void GizmoOverlay::paintEdges(QPainter& painter) const {
    for (const double width : {3.5, 1.5}) {
        painter.setPen(QPen(width > 2.0 ? kUnderline : kHot, width, Qt::SolidLine, Qt::RoundCap));
        for (const auto& [from, to] : m_content.edges) {
            const std::optional<QPointF> a = m_viewport.pointOf(from), b = m_viewport.pointOf(to);
            if (a && b) painter.drawLine(*a, *b);
        }
    }
}

void GizmoOverlay::paintLabel(QPainter& painter) const {
    if (m_content.label.isEmpty()) return;
    const QFontMetricsF metrics(font());
    QRectF box(m_content.pointer + kLabelOffset, QSizeF(metrics.horizontalAdvance(m_content.label) + 2.0 * kLabelMargin,
                                                        metrics.height() + kLabelMargin));
    box.moveRight(std::min(box.right(), width() - kLabelMargin));
    box.moveBottom(std::min(box.bottom(), height() - kLabelMargin));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 20, 20, 200));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, m_content.label);
}

}  // namespace rubble
