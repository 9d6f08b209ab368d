#include "editor/canvas/tools/OutlineTool.h"

#include "core/asset/project/OutlineEdit.h"
#include "editor/canvas/painting/CanvasPainting.h"
#include "editor/canvas/painting/GridPainting.h"
#include "editor/canvas/painting/OutlineFaults.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/EnteredFragment.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kPointRadius = 8.0;  // pixels
constexpr double kEdgeRadius = 6.0;
constexpr double kHandle = 3.5;             // pixels, half the side of a handle
constexpr double kMinHandleSpacing = 12.0;  // pixels; closer handles would hide the outline

double distance(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

RingPoint nextOf(const Polygon& outline, RingPoint point, int by = 1) {
    const int count = static_cast<int>(ringOf(outline, point.ring).size());
    return {point.ring, (point.point + by + count) % count};
}

Vec2& pointOf(Polygon& outline, RingPoint point) {
    return ringOf(outline, point.ring)[static_cast<std::size_t>(point.point)];
}
Vec2 pointOf(const Polygon& outline, RingPoint point) {
    return ringOf(outline, point.ring)[static_cast<std::size_t>(point.point)];
}

bool isIn(const Polygon& outline, RingPoint point) {
    return point.ring < ringCount(outline) && point.point < static_cast<int>(ringOf(outline, point.ring).size());
}

template <class Visit>
void forEachPoint(const Polygon& outline, Visit visit) {
    for (int ring = 0; ring < ringCount(outline); ++ring) {
        for (int point = 0; point < static_cast<int>(ringOf(outline, ring).size()); ++point)
            visit(RingPoint{ring, point});
    }
}

/// The points and edges of an outline that its moving points can snap to.
SnapTargets snapTargetsWithout(const Polygon& outline, RingPoint moving, bool isEdge) {
    SnapTargets targets;
    const auto isMoving = [&](RingPoint point) {
        return point == moving || (isEdge && point == nextOf(outline, moving));
    };
    forEachPoint(outline, [&](RingPoint point) {
        if (isMoving(point)) return;
        targets.points.push_back(pointOf(outline, point));
        const RingPoint next = nextOf(outline, point);
        if (!isMoving(next)) targets.edges.push_back({pointOf(outline, point), pointOf(outline, next)});
    });
    return targets;
}

QString fragmentOutlineMessage() {
    return OutlineTool::tr(
        "The outline of a fragment follows from its parent's pattern. Exit the fragment to edit the asset's outline.");
}

}  // namespace

OutlineTool::OutlineTool(const CanvasState& state) : CanvasTool(state), m_drawing(state) {
    connect(&m_drawing, &CanvasTool::changed, this, &CanvasTool::changed);
    connect(&m_drawing, &CanvasTool::statusMessage, this, &CanvasTool::statusMessage);
}

/// The outline of a fragment cannot be edited.
const Asset* OutlineTool::editableAsset() const {
    return m_state.isInFragment() || m_state.isMesh() ? nullptr : m_state.asset();
}

std::optional<OutlineTool::Handle> OutlineTool::handleAt(const CanvasPointer& pointer) const {
    if (!editableAsset()) return std::nullopt;
    const Polygon& outline = editableAsset()->prism().outline;
    std::optional<Handle> nearest;
    double least = kPointRadius / m_state.view.scale;
    const auto consider = [&](double away, RingPoint at, bool isEdge) {
        if (away > least) return;
        least = away;
        nearest = {at, isEdge};
    };
    forEachPoint(outline, [&](RingPoint at) { consider(distance(pointOf(outline, at), pointer.metres), at, false); });
    if (nearest) return nearest;
    least = kEdgeRadius / m_state.view.scale;
    forEachPoint(outline, [&](RingPoint at) {
        const Vec2 from = pointOf(outline, at), to = pointOf(outline, nextOf(outline, at));
        consider(distance(nearestOnEdge(pointer.metres, from, to), pointer.metres), at, true);
    });
    return nearest;
}

void OutlineTool::press(const CanvasPointer& pointer) {
    if (isDrawing()) return m_drawing.press(pointer);
    if (m_state.isInFragment()) return emit statusMessage(fragmentOutlineMessage());
    m_hovered = handleAt(pointer);
    m_selected = m_hovered && !m_hovered->isEdge ? std::optional(m_hovered->at) : std::nullopt;
    if (m_hovered) m_drag = {*editableAsset(), *m_hovered, pointer, m_state.document.newMergeKey()};
    emit changed();
}

void OutlineTool::move(const CanvasPointer& pointer) {
    if (isDrawing()) return m_drawing.move(pointer);
    if (m_drag) {
        const Polygon outline = dragged(pointer);
        std::vector<PolygonFault> faults = outlineFaults(outline);
        m_faulty.reset();
        if (faults.empty()) {
            pushOutline(m_drag->handle.isEdge ? tr("Move Edge") : tr("Move Point"), outline, m_drag->mergeKey);
        } else {
            m_faulty = {outline, std::move(faults)};
        }
    } else {
        m_hovered = handleAt(pointer);
    }
    emit changed();
}

Polygon OutlineTool::dragged(const CanvasPointer& pointer) const {
    Polygon outline = m_drag->before.prism().outline;
    const RingPoint at = m_drag->handle.at;
    const Vec2 from = pointOf(outline, at);
    if (pointer.pixels == m_drag->from.pixels) return outline;
    CanvasPointer target = pointer;
    target.metres = from + (pointer.metres - m_drag->from.metres);
    const Vec2 by = snapped(m_state, target, snapTargetsWithout(outline, at, m_drag->handle.isEdge)) - from;
    if (m_drag->handle.isEdge) pointOf(outline, nextOf(outline, at)) += by;
    pointOf(outline, at) = from + by;
    return outline;
}

bool OutlineTool::pushOutline(const QString& text, Polygon outline, quint64 mergeKey) {
    const std::vector<PolygonFault> faults = outlineFaults(outline);
    if (!faults.empty()) {
        emit statusMessage(QString::fromStdString(faults[0].message));
        return false;
    }
    return m_state.push(modify(text, withOutline(*editableAsset(), std::move(outline)), mergeKey));
}

void OutlineTool::release(const CanvasPointer& pointer) {
    if (isDrawing()) return m_drawing.release(pointer);
    if (m_faulty) {
        emit statusMessage(
            tr("%1 The last valid outline was restored.").arg(QString::fromStdString(m_faulty->faults[0].message)));
    }
    m_faulty.reset();
    m_drag.reset();
    m_hovered = handleAt(pointer);
    // Canonical winding may have renumbered the points.
    if (m_selected && m_hovered && !m_hovered->isEdge) m_selected = m_hovered->at;
    emit changed();
}

void OutlineTool::doubleClick(const CanvasPointer& pointer) {
    if (isDrawing()) return m_drawing.doubleClick(pointer);
    const std::optional<Handle> handle = handleAt(pointer);
    if (!handle || !handle->isEdge) return press(pointer);
    const Polygon& outline = editableAsset()->prism().outline;
    insertPoint(handle->at, nearestOnEdge(pointer.metres, pointOf(outline, handle->at),
                                          pointOf(outline, nextOf(outline, handle->at))));
}

void OutlineTool::insertPoint(RingPoint edge, Vec2 position) {
    Polygon outline = editableAsset()->prism().outline;
    Ring& ring = ringOf(outline, edge.ring);
    ring.insert(ring.begin() + edge.point + 1, position);
    if (!pushOutline(tr("Add Point"), std::move(outline))) return;
    m_selected = {edge.ring, edge.point + 1};
    m_hovered = {*m_selected, false};
    emit changed();
}

void OutlineTool::deleteSelectedPoint() {
    if (!editableAsset() || !m_selected || !isIn(editableAsset()->prism().outline, *m_selected)) return;
    Polygon outline = editableAsset()->prism().outline;
    Ring& ring = ringOf(outline, m_selected->ring);
    if (ring.size() <= 3 && m_selected->ring > 0) return deleteHole(m_selected->ring);
    ring.erase(ring.begin() + m_selected->point);
    if (!pushOutline(tr("Delete Point"), std::move(outline))) return;
    m_selected.reset();
    m_hovered.reset();
    emit changed();
}

void OutlineTool::deleteHole(int ring) {
    Polygon outline = editableAsset()->prism().outline;
    outline.holes.erase(outline.holes.begin() + (ring - 1));
    pushOutline(tr("Delete Hole"), std::move(outline));
    m_selected.reset();
    m_hovered.reset();
    emit changed();
}

void OutlineTool::beginDrawing(ShapeDrawing::Purpose purpose, DraftShape shape) {
    cancel();
    m_selected.reset();
    m_hovered.reset();
    m_drawing.begin(purpose, shape);
}

bool OutlineTool::cancel() {
    if (m_drawing.cancel()) return true;
    if (!m_drag) return false;
    if (editableAsset() && editableAsset()->id == m_drag->before.id) {
        m_state.push(modify(tr("Move Point"), m_drag->before, m_drag->mergeKey));
    }
    m_drag.reset();
    m_faulty.reset();
    emit changed();
    return true;
}

void OutlineTool::endDrag() {
    m_drag.reset();
    m_faulty.reset();
    emit changed();
}

bool OutlineTool::key(const QKeyEvent& event) {
    if (isDrawing()) return m_drawing.key(event);
    if (event.key() == Qt::Key_Escape) {
        if (!cancel() && !std::exchange(m_selected, std::nullopt)) return false;
        emit changed();
        return true;
    }
    if (const std::optional<Vec2> by = nudgeStep(event, m_state)) {
        nudge(*by, event.isAutoRepeat());
        return true;
    }
    if (!editableAsset()) return false;
    switch (event.key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace: deleteSelectedPoint(); return true;
        case Qt::Key_PageDown: selectNext(1); return true;
        case Qt::Key_PageUp: selectNext(-1); return true;
        case Qt::Key_Insert: {
            if (!m_selected) return true;
            const Polygon& outline = editableAsset()->prism().outline;
            insertPoint(*m_selected,
                        (pointOf(outline, *m_selected) + pointOf(outline, nextOf(outline, *m_selected))) / 2.0);
            return true;
        }
        default: return false;
    }
}

void OutlineTool::nudge(Vec2 by, bool isRepeated) {
    if (!editableAsset() || !m_selected || m_drag || !isIn(editableAsset()->prism().outline, *m_selected)) return;
    Polygon outline = editableAsset()->prism().outline;
    pointOf(outline, *m_selected) += by;
    pushOutline(tr("Move Point"), std::move(outline), nudgeMergeKey(isRepeated));
}

/// Cycles through the points of all rings.
void OutlineTool::selectNext(int by) {
    std::vector<RingPoint> points;
    forEachPoint(editableAsset()->prism().outline, [&](RingPoint point) { points.push_back(point); });
    const auto count = static_cast<int>(points.size());
    const auto selected = m_selected ? std::ranges::find(points, *m_selected) : points.end();
    const int now = selected == points.end() ? (by > 0 ? -1 : 0) : static_cast<int>(selected - points.begin());
    m_selected = points[static_cast<std::size_t>((now + by + count) % count)];
    emit changed();
}

void OutlineTool::paint(QPainter& painter, const CanvasColours& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    if (isDrawing()) return m_drawing.paint(painter, colours);
    if (m_faulty) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.fault, 1.5, Qt::DashLine));
        painter.drawPath(pathOf(m_faulty->outline, m_state.view));
        paintFaults(painter, m_faulty->outline, m_faulty->faults, m_state.view, colours);
    } else if (editableAsset()) {
        paintHandles(painter, colours);
    }
}

void OutlineTool::paintHandles(QPainter& painter, const CanvasColours& colours) const {
    const Polygon& outline = editableAsset()->prism().outline;
    if (m_hovered && m_hovered->isEdge && isIn(outline, m_hovered->at)) {
        painter.setPen(QPen(colours.accent, 4.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(m_state.view.pixels(pointOf(outline, m_hovered->at)),
                         m_state.view.pixels(pointOf(outline, nextOf(outline, m_hovered->at))));
    }
    QPointF last(-1e9, -1e9);
    forEachPoint(outline, [&](RingPoint point) {
        const QPointF at = m_state.view.pixels(pointOf(outline, point));
        const bool isSelected = m_selected == point, isHovered = m_hovered == Handle{point, false};
        if (!isSelected && !isHovered && (at - last).manhattanLength() < kMinHandleSpacing) return;
        last = at;
        const double half = isHovered ? kHandle + 1.5 : kHandle;
        painter.setPen(QPen(isSelected || isHovered ? colours.accent : colours.outline, 1.5));
        painter.setBrush(isSelected ? colours.accent : colours.halo);
        painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    });
}

Qt::CursorShape OutlineTool::cursor() const {
    if (isDrawing()) return m_drawing.cursor();
    if (m_drag) return Qt::SizeAllCursor;
    return m_hovered ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

QString OutlineTool::hint() const {
    if (isDrawing()) return m_drawing.hint();
    if (m_drag) return tr("Release to finish · Shift: no snapping · Esc: cancel");
    if (m_state.isInFragment()) return fragmentOutlineMessage();
    if (m_selected)
        return tr("Drag or arrow keys: move the point · Del: delete · PgUp, PgDn: select the previous or next point");
    return tr(
        "Drag: move a point or an edge · Double-click on an edge: add a point · Right-click: add or cut a shape, "
        "draw an outline");
}

void OutlineTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    if (isDrawing()) return m_drawing.fillMenu(menu, pointer);
    const Asset* asset = editableAsset();
    const std::optional<Handle> handle = handleAt(pointer);
    if (handle && !handle->isEdge) m_selected = handle->at;
    if (handle && handle->isEdge) {
        const Vec2 position =
            nearestOnEdge(pointer.metres, pointOf(asset->prism().outline, handle->at),
                          pointOf(asset->prism().outline, nextOf(asset->prism().outline, handle->at)));
        menu.addAction(tr("&Add Point Here"), this, [this, at = handle->at, position] { insertPoint(at, position); });
    }
    menu.addAction(tr("&Delete Point"), this, &OutlineTool::deleteSelectedPoint)->setEnabled(m_selected.has_value());
    const int hole = handle ? handle->at.ring : 0;
    menu.addAction(tr("Delete &Hole"), this, [this, hole] { deleteHole(hole); })->setEnabled(hole > 0);
    menu.addSeparator();
    using Purpose = ShapeDrawing::Purpose;
    addDrawings(*menu.addMenu(tr("Add &to Outline")), Purpose::Add);
    addDrawings(*menu.addMenu(tr("&Cut from Outline")), Purpose::Cut);
    menu.addAction(tr("Draw &Outline"), this, [this] { beginDrawing(Purpose::Replace); })->setEnabled(asset != nullptr);
    menu.addAction(tr("Draw &New Asset"), this, [this] { beginDrawing(Purpose::NewAsset); });
}

void OutlineTool::addDrawings(QMenu& menu, ShapeDrawing::Purpose purpose) {
    const std::pair<QString, DraftShape> shapes[] = {{tr("&Rectangle"), DraftShape::Rectangle},
                                                     {tr("&Polygon"), DraftShape::Polygon},
                                                     {tr("&Circle"), DraftShape::Circle}};
    for (const auto& [text, shape] : shapes)
        menu.addAction(text, this, [this, purpose, kind = shape] { beginDrawing(purpose, kind); });
    menu.setEnabled(editableAsset() != nullptr);
}

}  // namespace rubble

#include "moc_OutlineTool.cpp"
