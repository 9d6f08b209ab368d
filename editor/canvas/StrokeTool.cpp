#include "editor/canvas/StrokeTool.h"

#include "core/fracture/SeedEdits.h"
#include "editor/canvas/CanvasPainting.h"
#include "editor/canvas/Snapping.h"
#include "editor/commands/ProjectEdits.h"

#include <QApplication>

#include <glm/geometric.hpp>

#include <algorithm>
#include <ranges>
#include <utility>

namespace rubble {

namespace {

constexpr double kGrabReach = 9.0;  // pixels from a point within which a press takes it
constexpr double kPathStep = 3.0;   // pixels between two points of what is drawn freely
constexpr double kStraight = 2.0;   // pixels that a free line may be off when points are left out
constexpr double kPointSize = 7.0;  // pixels
constexpr double kLineWidth = 2.5;  // pixels

const Strokes::Stroke* findStroke(const Pattern& pattern, Id layerId, std::uint32_t index) {
    const PatternLayer* layer = findLayer(pattern, layerId);
    const auto* strokes = layer ? std::get_if<Strokes>(&layer->parameters) : nullptr;
    if (!strokes) return nullptr;
    const auto found = std::ranges::find(strokes->strokes, index, &Strokes::Stroke::index);
    return found == strokes->strokes.end() ? nullptr : &*found;
}

Strokes::Stroke* findStroke(Pattern& pattern, Id layerId, std::uint32_t index) {
    return const_cast<Strokes::Stroke*>(findStroke(std::as_const(pattern), layerId, index));
}

/// Leaves out points that lie within `slack` of the line without them.
/// Source: Ramer 1972; Douglas, Peucker 1973.
void keepTurns(const std::vector<Vec2>& points, std::size_t first, std::size_t last, double slack,
               std::vector<bool>& isKept) {
    const Vec2 along = points[last] - points[first];
    const double squared = glm::dot(along, along);
    std::size_t farthest = first;
    double most = slack;
    for (std::size_t k = first + 1; k < last; ++k) {
        const Vec2 offset = points[k] - points[first];
        const double share = squared > 0.0 ? std::clamp(glm::dot(offset, along) / squared, 0.0, 1.0) : 0.0;
        const double off = glm::distance(points[k], points[first] + share * along);
        if (off <= most) continue;
        most = off;
        farthest = k;
    }
    if (farthest == first) return;
    isKept[farthest] = true;
    keepTurns(points, first, farthest, slack, isKept);
    keepTurns(points, farthest, last, slack, isKept);
}

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double slack) {
    std::vector<bool> isKept(points.size(), false);
    isKept.front() = isKept.back() = true;
    keepTurns(points, 0, points.size() - 1, slack, isKept);
    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (isKept[k] && (kept.empty() || kept.back() != points[k])) kept.push_back(points[k]);
    }
    return kept;
}

QPolygonF polyline(const std::vector<Vec2>& points, const CanvasView& view) {
    QPolygonF line;
    for (const Vec2 point : points) line.push_back(view.pixels(point));
    return line;
}

template <class Visit>
void forEachStroke(const Pattern& pattern, Visit visit) {
    for (const PatternLayer& layer : pattern.layers) {
        const auto* strokes = std::get_if<Strokes>(&layer.parameters);
        if (!strokes || !layer.isOn) continue;
        for (const Strokes::Stroke& stroke : strokes->strokes) visit(layer, stroke);
    }
}

}  // namespace

std::optional<StrokeTool::Place> StrokeTool::placeAt(const CanvasPointer& pointer) const {
    std::optional<Place> nearest;
    double least = kGrabReach * kGrabReach;
    if (!m_state.shown()) return nearest;
    forEachStroke(m_state.shown()->pattern, [&](const PatternLayer& layer, const Strokes::Stroke& stroke) {
        for (std::size_t k = 0; k < stroke.points.size(); ++k) {
            const QPointF off = m_state.view.pixels(stroke.points[k]) - pointer.pixels;
            const double squared = QPointF::dotProduct(off, off);
            if (squared > least) continue;
            least = squared;
            nearest = Place{layer.id, stroke.index, k};
        }
    });
    return nearest;
}

Vec2 StrokeTool::snappedPoint(const CanvasPointer& pointer) const {
    SnapTargets targets = outlineTargets(m_state);
    forEachStroke(m_state.shown()->pattern, [&](const PatternLayer& layer, const Strokes::Stroke& stroke) {
        for (std::size_t k = 0; k < stroke.points.size(); ++k) {
            const bool isOwn = m_drag && m_drag->place == Place{layer.id, stroke.index, k};
            if (!isOwn) targets.points.push_back(stroke.points[k]);
        }
    });
    return snapped(m_state, pointer, targets);
}

void StrokeTool::press(const CanvasPointer& pointer) {
    m_pressed = pointer.pixels;
    m_hasMoved = false;
    if (!m_state.shown() || !m_draft.empty()) return;
    m_chosen = placeAt(pointer);
    if (!m_chosen) {
        m_path = {snappedPoint(pointer)};
    } else {
        m_drag = Drag{*m_state.asset(), *m_chosen, m_state.document.newStroke()};
    }
    emit changed();
}

void StrokeTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer.metres;
    if ((pointer.pixels - m_pressed).manhattanLength() >= QApplication::startDragDistance() / 2.0) m_hasMoved = true;
    if (m_drag && m_hasMoved) {
        dragTo(snappedPoint(pointer));
    } else if (!m_path.empty() && m_hasMoved) {
        const QPointF off = m_state.view.pixels(m_path.back()) - pointer.pixels;
        if (QPointF::dotProduct(off, off) >= kPathStep * kPathStep) m_path.push_back(pointer.metres);
    }
    m_hovered = isDrawing() || !m_state.shown() ? std::nullopt : placeAt(pointer);
    emit changed();
}

void StrokeTool::release(const CanvasPointer& pointer) {
    m_drag.reset();
    if (!m_state.shown()) return;
    if (m_path.size() > 1) {
        m_path.push_back(snappedPoint(pointer));
        endPath();
    } else if (!m_path.empty() || !m_draft.empty()) {
        m_path.clear();
        addToDraft(snappedPoint(pointer));
    }
    emit changed();
}

void StrokeTool::doubleClick(const CanvasPointer&) {
    endDraft();
    emit changed();
}

void StrokeTool::addToDraft(Vec2 point) {
    if (m_draft.empty() || m_draft.back() != point) m_draft.push_back(point);
}

void StrokeTool::endPath() {
    std::vector<Vec2> points = simplified(m_path, kStraight / m_state.view.scale);
    m_path.clear();
    add(std::move(points));
}

void StrokeTool::endDraft() {
    std::vector<Vec2> points = std::move(m_draft);
    m_draft.clear();
    m_path.clear();
    add(std::move(points));
}

void StrokeTool::add(std::vector<Vec2> points) {
    if (points.size() < 2 || !m_state.shown()) return;
    Asset asset = *m_state.asset();
    Edit edit{.text = tr("Draw stroke")};
    const auto isOpen = [](const PatternLayer& layer) {
        return layer.isOn && std::holds_alternative<Strokes>(layer.parameters);
    };
    auto& layers = m_state.patternIn(asset).layers;
    auto layer = std::find_if(layers.rbegin(), layers.rend(), isOpen);
    if (layer == layers.rend()) {
        const Id id = edit.takeId(m_state.document.project());
        layers.push_back({.id = id, .randomSeed = id, .parameters = Strokes{}});
        layer = layers.rbegin();
    }
    std::vector<Strokes::Stroke>& strokes = std::get<Strokes>(layer->parameters).strokes;
    const std::uint32_t index = strokes.empty() ? 0 : strokes.back().index + 1;
    m_chosen = Place{layer->id, index, points.size() - 1};
    strokes.push_back({index, std::move(points)});
    edit.swaps = {Swap<Asset>{asset.id, std::move(asset)}};
    m_state.document.push(std::move(edit));
}

void StrokeTool::dragTo(Vec2 position) {
    Asset asset = m_drag->before;
    const Place place = m_drag->place;
    Strokes::Stroke& stroke = *findStroke(m_state.patternIn(asset), place.layer, place.stroke);
    const Vec2 from = stroke.points[place.point];
    const bool isClosed = stroke.points.front() == stroke.points.back();
    stroke.points[place.point] = position;
    // The two ends of a closed stroke are one point.
    if (isClosed && from == stroke.points.back()) stroke.points.back() = position;
    if (isClosed && from == stroke.points.front()) stroke.points.front() = position;
    const auto same = std::ranges::adjacent_find(stroke.points);
    if (same == stroke.points.end())
        m_state.document.push(altered(tr("Move point of stroke"), std::move(asset), m_drag->stroke));
}

void StrokeTool::deleteChosenPoint() {
    if (!m_chosen || !m_state.shown()) return;
    Asset asset = *m_state.asset();
    Strokes::Stroke* stroke = findStroke(m_state.patternIn(asset), m_chosen->layer, m_chosen->stroke);
    if (!stroke || m_chosen->point >= stroke->points.size()) return;
    if (stroke->points.size() <= 2) return deleteChosenStroke();
    stroke->points.erase(stroke->points.begin() + static_cast<std::ptrdiff_t>(m_chosen->point));
    const auto repeated = std::ranges::unique(stroke->points);
    stroke->points.erase(repeated.begin(), repeated.end());
    if (stroke->points.size() < 2) return deleteChosenStroke();
    m_chosen.reset();
    m_state.document.push(altered(tr("Delete point of stroke"), std::move(asset)));
}

void StrokeTool::deleteChosenStroke() {
    if (!m_chosen || !m_state.shown()) return;
    Asset asset = *m_state.asset();
    PatternLayer* layer = findLayer(m_state.patternIn(asset), m_chosen->layer);
    auto* strokes = layer ? std::get_if<Strokes>(&layer->parameters) : nullptr;
    if (!strokes ||
        std::erase_if(strokes->strokes, [&](const auto& stroke) { return stroke.index == m_chosen->stroke; }) == 0)
        return;
    m_chosen.reset();
    m_hovered.reset();
    m_state.document.push(altered(tr("Delete stroke"), std::move(asset)));
}

bool StrokeTool::key(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (m_draft.empty()) return false;
            endDraft();
            emit changed();
            return true;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            if (!m_draft.empty()) {
                m_draft.pop_back();
                emit changed();
            } else {
                deleteChosenPoint();
            }
            return true;
        case Qt::Key_Escape:
            if (!cancel() && !std::exchange(m_chosen, std::nullopt)) return false;
            emit changed();
            return true;
        default: return false;
    }
}

bool StrokeTool::cancel() {
    if (!isDrawing() && !m_drag) return false;
    if (m_drag && m_state.asset() && m_state.asset()->id == m_drag->before.id)
        m_state.document.push(altered(tr("Move point of stroke"), m_drag->before, m_drag->stroke));
    letGo();
    m_draft.clear();
    emit changed();
    return true;
}

void StrokeTool::letGo() {
    m_drag.reset();
    m_path.clear();
    if (m_chosen && m_state.shown()) {
        const Strokes::Stroke* stroke = findStroke(m_state.shown()->pattern, m_chosen->layer, m_chosen->stroke);
        if (!stroke || m_chosen->point >= stroke->points.size()) m_chosen.reset();
    }
    m_hovered.reset();
    emit changed();
}

void StrokeTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_state.shown()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const auto paintLine = [&](const QPolygonF& line) {
        painter.setPen(QPen(colours.halo, kLineWidth + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.setPen(QPen(colours.accent, kLineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    };
    const auto paintPoint = [&](QPointF at, const QColor& fill) {
        painter.setPen(QPen(colours.accent, 1.5));
        painter.setBrush(fill);
        painter.drawEllipse(at, kPointSize / 2.0, kPointSize / 2.0);
        painter.setBrush(Qt::NoBrush);
    };
    forEachStroke(m_state.shown()->pattern, [&](const PatternLayer& layer, const Strokes::Stroke& stroke) {
        const QPolygonF line = polyline(stroke.points, m_state.view);
        paintLine(line);
        for (std::size_t k = 0; k < stroke.points.size(); ++k) {
            const Place place{layer.id, stroke.index, k};
            paintPoint(line[static_cast<qsizetype>(k)], m_chosen == place    ? colours.accent
                                                        : m_hovered == place ? colours.hover
                                                                             : colours.halo);
        }
    });
    QPolygonF drawn = polyline(m_draft.empty() ? m_path : m_draft, m_state.view);
    if (drawn.isEmpty()) return;
    if (!m_draft.empty()) drawn.push_back(m_state.view.pixels(m_pointer));
    paintLine(drawn);
    for (const Vec2 point : m_draft) paintPoint(m_state.view.pixels(point), colours.accent);
}

Qt::CursorShape StrokeTool::cursor() const { return m_drag || m_hovered ? Qt::SizeAllCursor : Qt::CrossCursor; }

QString StrokeTool::hint() const {
    if (!m_draft.empty())
        return tr("Click: next point · Enter or double click: end · Backspace: one point back · Esc: give up");
    if (!m_path.empty()) return tr("Release to end the crack");
    if (m_drag) return tr("Release to drop · Shift: without snapping · Esc: put back");
    if (m_chosen) return tr("Drag: move the point · Del: delete it · Esc: choose none");
    return tr("Drag: draw a crack freely · click from point to point: draw straight lines · drag a point: move it");
}

void StrokeTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    if (const std::optional<Place> place = placeAt(pointer)) m_chosen = place;
    menu.addAction(tr("&End Stroke"), this, &StrokeTool::endDraft)->setEnabled(m_draft.size() > 1);
    menu.addSeparator();
    menu.addAction(tr("Delete &Point"), this, &StrokeTool::deleteChosenPoint)->setEnabled(m_chosen.has_value());
    menu.addAction(tr("Delete &Stroke"), this, &StrokeTool::deleteChosenStroke)->setEnabled(m_chosen.has_value());
    emit changed();
}

}  // namespace rubble
