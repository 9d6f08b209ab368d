#include "editor/canvas/OutlineTool.h"

#include "editor/canvas/CanvasPainting.h"
#include "editor/canvas/FaultyOutline.h"
#include "editor/canvas/GridPainting.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/Inside.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kPointReach = 8.0;  // pixels within which a press takes a point
constexpr double kEdgeReach = 6.0;
constexpr double kHandle = 3.5;         // pixels, half a handle's side
constexpr double kDepthOfNew = 0.5;     // m, of an asset that is drawn
constexpr double kLeastHandles = 12.0;  // pixels between points below which handles would hide the outline

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

/// The outline less its moving points: what those may be drawn to.
SnapTargets targetsWithout(const Polygon& outline, RingPoint moving, bool isEdge) {
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

QString sentenceInside() {
    return OutlineTool::tr(
        "The outline of a fragment follows from the pattern that it is cut by; go out to change the asset's.");
}

}  // namespace

/// A fragment's outline is nobody's to draw.
const Asset* OutlineTool::drawn() const { return m_state.isInside() ? nullptr : m_state.asset(); }

std::optional<OutlineTool::Place> OutlineTool::placeAt(const CanvasPointer& pointer) const {
    if (!drawn()) return std::nullopt;
    const Polygon& outline = drawn()->prism.outline;
    std::optional<Place> place;
    double least = kPointReach / m_state.view.scale;
    const auto offer = [&](double away, RingPoint at, bool isEdge) {
        if (away > least) return;
        least = away;
        place = {at, isEdge};
    };
    forEachPoint(outline, [&](RingPoint at) { offer(distance(pointOf(outline, at), pointer.metres), at, false); });
    if (place) return place;
    least = kEdgeReach / m_state.view.scale;
    forEachPoint(outline, [&](RingPoint at) {
        const Vec2 from = pointOf(outline, at), to = pointOf(outline, nextOf(outline, at));
        offer(distance(nearestOnEdge(pointer.metres, from, to), pointer.metres), at, true);
    });
    return place;
}

void OutlineTool::press(const CanvasPointer& pointer) {
    if (m_draft) {
        m_draft->movePen(snapped(m_state, pointer, outlineTargets(m_state)));
        if (m_draft->wouldClose(kPointReach / m_state.view.scale)) return closeDraft();
        m_draft->add();
        emit changed();
        return;
    }
    if (m_state.isInside()) return emit said(sentenceInside());
    m_hovered = placeAt(pointer);
    m_chosen = m_hovered && !m_hovered->isEdge ? std::optional(m_hovered->at) : std::nullopt;
    if (m_hovered) m_drag = {*drawn(), *m_hovered, pointer, m_state.document.newStroke()};
    emit changed();
}

void OutlineTool::move(const CanvasPointer& pointer) {
    if (m_draft) {
        m_draft->movePen(snapped(m_state, pointer, outlineTargets(m_state)));
    } else if (m_drag) {
        const Polygon outline = dragged(pointer);
        std::vector<PolygonFault> faults = outlineFaults(outline);
        m_faulty.reset();
        if (faults.empty()) {
            offer(m_drag->place.isEdge ? tr("Move edge") : tr("Move point"), outline, m_drag->stroke);
        } else {
            m_faulty = {outline, std::move(faults)};
        }
    } else {
        m_hovered = placeAt(pointer);
    }
    emit changed();
}

Polygon OutlineTool::dragged(const CanvasPointer& pointer) const {
    Polygon outline = m_drag->before.prism.outline;
    const RingPoint at = m_drag->place.at;
    const Vec2 from = pointOf(outline, at);
    if (pointer.pixels == m_drag->from.pixels) return outline;
    CanvasPointer wanted = pointer;
    wanted.metres = from + (pointer.metres - m_drag->from.metres);
    const Vec2 by = snapped(m_state, wanted, targetsWithout(outline, at, m_drag->place.isEdge)) - from;
    if (m_drag->place.isEdge) pointOf(outline, nextOf(outline, at)) += by;
    pointOf(outline, at) = from + by;
    return outline;
}

bool OutlineTool::offer(const QString& text, Polygon outline, quint64 stroke) {
    const std::vector<PolygonFault> faults = outlineFaults(outline);
    if (!faults.empty()) {
        emit said(QString::fromStdString(faults[0].message));
        return false;
    }
    Asset asset = *drawn();
    asset.prism.outline = withCanonicalWinding(std::move(outline));
    m_state.document.push(altered(text, std::move(asset), stroke));
    return true;
}

void OutlineTool::release(const CanvasPointer& pointer) {
    if (m_faulty) {
        emit said(
            tr("%1 The last shape that can be cut is back.").arg(QString::fromStdString(m_faulty->faults[0].message)));
    }
    m_faulty.reset();
    m_drag.reset();
    if (!m_draft) m_hovered = placeAt(pointer);
    // Winding may have turned the numbers round.
    if (m_chosen && m_hovered && !m_hovered->isEdge) m_chosen = m_hovered->at;
    emit changed();
}

void OutlineTool::doubleClick(const CanvasPointer& pointer) {
    if (m_draft) return closeDraft();
    const std::optional<Place> place = placeAt(pointer);
    if (!place || !place->isEdge) return press(pointer);
    const Polygon& outline = drawn()->prism.outline;
    insertPoint(place->at, nearestOnEdge(pointer.metres, pointOf(outline, place->at),
                                         pointOf(outline, nextOf(outline, place->at))));
}

void OutlineTool::insertPoint(RingPoint edge, Vec2 position) {
    Polygon outline = drawn()->prism.outline;
    Ring& ring = ringOf(outline, edge.ring);
    ring.insert(ring.begin() + edge.point + 1, position);
    if (!offer(tr("Add point"), std::move(outline))) return;
    m_chosen = {edge.ring, edge.point + 1};
    m_hovered = {*m_chosen, false};
    emit changed();
}

void OutlineTool::deleteChosenPoint() {
    if (!drawn() || !m_chosen || !isIn(drawn()->prism.outline, *m_chosen)) return;
    Polygon outline = drawn()->prism.outline;
    Ring& ring = ringOf(outline, m_chosen->ring);
    if (ring.size() <= 3 && m_chosen->ring > 0) return deleteHole(m_chosen->ring);
    ring.erase(ring.begin() + m_chosen->point);
    if (!offer(tr("Delete point"), std::move(outline))) return;
    m_chosen.reset();
    m_hovered.reset();
    emit changed();
}

void OutlineTool::deleteHole(int ring) {
    Polygon outline = drawn()->prism.outline;
    outline.holes.erase(outline.holes.begin() + (ring - 1));
    offer(tr("Delete hole"), std::move(outline));
    m_chosen.reset();
    m_hovered.reset();
    emit changed();
}

void OutlineTool::beginDrawing(Drawing drawing) {
    cancel();
    if (drawing == Drawing::NewAsset) goOut(m_state.selection, {});
    if (drawing != Drawing::NewAsset && !drawn()) return;
    m_drawing = drawing;
    m_draft.emplace(drawing == Drawing::Hole ? std::optional(drawn()->prism.outline) : std::nullopt);
    m_draft->movePen(m_state.view.centre);
    m_chosen.reset();
    m_hovered.reset();
    emit changed();
}

void OutlineTool::closeDraft() {
    const Polygon outline = m_draft->closed();
    if (m_drawing == Drawing::NewAsset) {
        const std::vector<PolygonFault> faults = outlineFaults(outline);
        if (!faults.empty()) return emit said(QString::fromStdString(faults[0].message));
        Addition addition = addAsset(m_state.document.project(), tr("shape").toStdString(),
                                     {withCanonicalWinding(outline), kDepthOfNew});
        m_draft.reset();
        m_state.document.push(std::move(addition.edit));
        m_state.selection.setAsset(addition.id);
    } else if (offer(m_drawing == Drawing::Hole ? tr("Add hole") : tr("Draw outline"), outline)) {
        m_draft.reset();
    }
    emit changed();
}

bool OutlineTool::cancel() {
    if (!m_drag && !m_draft) return false;
    if (m_drag && drawn() && drawn()->id == m_drag->before.id) {
        m_state.document.push(altered(tr("Move point"), m_drag->before, m_drag->stroke));
    }
    m_drag.reset();
    m_draft.reset();
    m_faulty.reset();
    emit changed();
    return true;
}

void OutlineTool::letGo() {
    m_drag.reset();
    m_faulty.reset();
    emit changed();
}

bool OutlineTool::draftKey(int key) {
    switch (key) {
        case Qt::Key_Return:
        case Qt::Key_Enter: closeDraft(); return true;
        case Qt::Key_Backspace:
        case Qt::Key_Delete:
            if (!m_draft->removeLast()) cancel();
            emit changed();
            return true;
        case Qt::Key_Insert:
            m_draft->add();
            emit changed();
            return true;
        default: return false;
    }
}

bool OutlineTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
        if (!cancel() && !std::exchange(m_chosen, std::nullopt)) return false;
        emit changed();
        return true;
    }
    if (const std::optional<Vec2> by = nudgeOf(event, m_state)) {
        if (m_draft) {
            m_draft->movePen(m_draft->pen() + *by);
            emit changed();
        } else {
            nudge(*by, event.isAutoRepeat());
        }
        return true;
    }
    if (m_draft) return draftKey(event.key());
    if (!drawn()) return false;
    switch (event.key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace: deleteChosenPoint(); return true;
        case Qt::Key_PageDown: chooseNext(1); return true;
        case Qt::Key_PageUp: chooseNext(-1); return true;
        case Qt::Key_Insert: {
            if (!m_chosen) return true;
            const Polygon& outline = drawn()->prism.outline;
            insertPoint(*m_chosen, (pointOf(outline, *m_chosen) + pointOf(outline, nextOf(outline, *m_chosen))) / 2.0);
            return true;
        }
        default: return false;
    }
}

void OutlineTool::nudge(Vec2 by, bool isRepeated) {
    if (!drawn() || !m_chosen || m_drag || !isIn(drawn()->prism.outline, *m_chosen)) return;
    Polygon outline = drawn()->prism.outline;
    pointOf(outline, *m_chosen) += by;
    offer(tr("Move point"), std::move(outline), nudgeStroke(isRepeated));
}

/// Goes through the points of all rings.
void OutlineTool::chooseNext(int by) {
    std::vector<RingPoint> points;
    forEachPoint(drawn()->prism.outline, [&](RingPoint point) { points.push_back(point); });
    const auto count = static_cast<int>(points.size());
    const auto place = m_chosen ? std::ranges::find(points, *m_chosen) : points.end();
    const int now = place == points.end() ? (by > 0 ? -1 : 0) : static_cast<int>(place - points.begin());
    m_chosen = points[static_cast<std::size_t>((now + by + count) % count)];
    emit changed();
}

void OutlineTool::paint(QPainter& painter, const CanvasColours& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_draft) return m_draft->paint(painter, m_state.view, colours);
    if (m_faulty) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.fault, 1.5, Qt::DashLine));
        painter.drawPath(pathOf(m_faulty->outline, m_state.view));
        paintFaults(painter, m_faulty->outline, m_faulty->faults, m_state.view, colours);
    } else if (drawn()) {
        paintPlaces(painter, colours);
    }
}

void OutlineTool::paintPlaces(QPainter& painter, const CanvasColours& colours) const {
    const Polygon& outline = drawn()->prism.outline;
    if (m_hovered && m_hovered->isEdge && isIn(outline, m_hovered->at)) {
        painter.setPen(QPen(colours.accent, 4.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(m_state.view.pixels(pointOf(outline, m_hovered->at)),
                         m_state.view.pixels(pointOf(outline, nextOf(outline, m_hovered->at))));
    }
    QPointF last(-1e9, -1e9);
    forEachPoint(outline, [&](RingPoint point) {
        const QPointF at = m_state.view.pixels(pointOf(outline, point));
        const bool isChosen = m_chosen == point, isHovered = m_hovered == Place{point, false};
        if (!isChosen && !isHovered && (at - last).manhattanLength() < kLeastHandles) return;
        last = at;
        const double half = isHovered ? kHandle + 1.5 : kHandle;
        painter.setPen(QPen(isChosen || isHovered ? colours.accent : colours.outline, 1.5));
        painter.setBrush(isChosen ? colours.accent : colours.halo);
        painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    });
}

Qt::CursorShape OutlineTool::cursor() const {
    if (m_draft) return Qt::CrossCursor;
    if (m_drag) return Qt::SizeAllCursor;
    return m_hovered ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

QString OutlineTool::hint() const {
    if (m_draft)
        return tr(
            "Click: add a point · Backspace: take the last one back · Enter or first point: close · Esc: give up");
    if (m_drag) return tr("Release to drop · Shift: without snapping · Esc: put back");
    if (m_state.isInside()) return sentenceInside();
    if (m_chosen) return tr("Drag or arrow keys: move the point · Del: delete it · PgUp, PgDn: choose another");
    return tr("Drag a point or an edge · double click on an edge: add a point · right click: draw anew, add a hole");
}

void OutlineTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    const Asset* asset = drawn();
    const std::optional<Place> place = placeAt(pointer);
    if (place && !place->isEdge) m_chosen = place->at;
    if (place && place->isEdge) {
        const Vec2 position = nearestOnEdge(pointer.metres, pointOf(asset->prism.outline, place->at),
                                            pointOf(asset->prism.outline, nextOf(asset->prism.outline, place->at)));
        menu.addAction(tr("&Add Point Here"), this, [this, place, position] { insertPoint(place->at, position); });
    }
    menu.addAction(tr("&Delete Point"), this, &OutlineTool::deleteChosenPoint)->setEnabled(m_chosen.has_value());
    const int hole = place ? place->at.ring : 0;
    menu.addAction(tr("Delete &Hole"), this, [this, hole] { deleteHole(hole); })->setEnabled(hole > 0);
    menu.addSeparator();
    menu.addAction(tr("Draw a Hol&e"), this, [this] { beginDrawing(Drawing::Hole); })->setEnabled(asset != nullptr);
    menu.addAction(tr("Draw the &Outline Anew"), this, [this] { beginDrawing(Drawing::Outline); })
        ->setEnabled(asset != nullptr);
    menu.addAction(tr("Draw a &New Asset"), this, [this] { beginDrawing(Drawing::NewAsset); });
}

}  // namespace rubble
