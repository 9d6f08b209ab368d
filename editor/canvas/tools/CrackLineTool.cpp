#include "editor/canvas/tools/CrackLineTool.h"

#include "core/fracture/pattern/SeedEdits.h"
#include "core/geometry/line/LineSimplification.h"
#include "editor/canvas/painting/CanvasPainting.h"
#include "editor/canvas/tools/Snapping.h"
#include "editor/commands/ProjectEdits.h"

#include <QApplication>

#include <algorithm>
#include <ranges>
#include <utility>

namespace rubble {

namespace {

constexpr double kPointGrabRadius = 9.0;    // pixels
constexpr double kPathStep = 3.0;           // pixels between freehand points
constexpr double kSimplifyTolerance = 2.0;  // pixels
constexpr double kPointSize = 7.0;          // pixels
constexpr double kLineWidth = 2.5;          // pixels

const CrackLines::CrackLine* findLine(const Pattern& pattern, Id layerId, std::uint32_t index) {
    const PatternLayer* layer = findLayer(pattern, layerId);
    const auto* lines = layer ? std::get_if<CrackLines>(&layer->parameters) : nullptr;
    if (!lines) return nullptr;
    const auto found = std::ranges::find(lines->lines, index, &CrackLines::CrackLine::index);
    return found == lines->lines.end() ? nullptr : &*found;
}

CrackLines::CrackLine* findLine(Pattern& pattern, Id layerId, std::uint32_t index) {
    return const_cast<CrackLines::CrackLine*>(findLine(std::as_const(pattern), layerId, index));
}

QPolygonF polyline(const std::vector<Vec2>& points, const CanvasView& view) {
    QPolygonF line;
    for (const Vec2 point : points) line.push_back(view.pixels(point));
    return line;
}

template <class Visit>
void forEachLine(const Pattern& pattern, Visit visit) {
    for (const PatternLayer& layer : pattern.layers) {
        const auto* lines = std::get_if<CrackLines>(&layer.parameters);
        if (!lines || !layer.isOn) continue;
        for (const CrackLines::CrackLine& line : lines->lines) visit(layer, line);
    }
}

}  // namespace

std::optional<CrackLineTool::LinePoint> CrackLineTool::pointAt(const CanvasPointer& pointer) const {
    std::optional<LinePoint> nearest;
    double least = kPointGrabRadius * kPointGrabRadius;
    if (!m_state.planarAsset()) return nearest;
    forEachLine(m_state.planarAsset()->pattern, [&](const PatternLayer& layer, const CrackLines::CrackLine& line) {
        for (std::size_t k = 0; k < line.points.size(); ++k) {
            const QPointF off = m_state.view.pixels(line.points[k]) - pointer.pixels;
            const double squared = QPointF::dotProduct(off, off);
            if (squared > least) continue;
            least = squared;
            nearest = LinePoint{layer.id, line.index, k};
        }
    });
    return nearest;
}

Vec2 CrackLineTool::snappedPoint(const CanvasPointer& pointer) const {
    SnapTargets targets = outlineTargets(m_state);
    forEachLine(m_state.planarAsset()->pattern, [&](const PatternLayer& layer, const CrackLines::CrackLine& line) {
        for (std::size_t k = 0; k < line.points.size(); ++k) {
            const bool isOwn = m_drag && m_drag->point == LinePoint{layer.id, line.index, k};
            if (!isOwn) targets.points.push_back(line.points[k]);
        }
    });
    return snapped(m_state, pointer, targets);
}

void CrackLineTool::press(const CanvasPointer& pointer) {
    m_pressed = pointer.pixels;
    m_hasMoved = false;
    if (!m_state.planarAsset() || !m_draft.empty()) return;
    m_selected = pointAt(pointer);
    if (!m_selected) {
        m_path = {snappedPoint(pointer)};
    } else {
        m_drag = Drag{*m_state.asset(), *m_selected, m_state.document.newMergeKey()};
    }
    emit changed();
}

void CrackLineTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer.metres;
    if ((pointer.pixels - m_pressed).manhattanLength() >= QApplication::startDragDistance() / 2.0) m_hasMoved = true;
    if (m_drag && m_hasMoved) {
        dragTo(snappedPoint(pointer));
    } else if (!m_path.empty() && m_hasMoved) {
        const QPointF off = m_state.view.pixels(m_path.back()) - pointer.pixels;
        if (QPointF::dotProduct(off, off) >= kPathStep * kPathStep) m_path.push_back(pointer.metres);
    }
    m_hovered = isDrawing() || !m_state.planarAsset() ? std::nullopt : pointAt(pointer);
    emit changed();
}

void CrackLineTool::release(const CanvasPointer& pointer) {
    m_drag.reset();
    if (!m_state.planarAsset()) return;
    if (m_path.size() > 1) {
        m_path.push_back(snappedPoint(pointer));
        endPath();
    } else if (!m_path.empty() || !m_draft.empty()) {
        m_path.clear();
        addToDraft(snappedPoint(pointer));
    }
    emit changed();
}

void CrackLineTool::doubleClick(const CanvasPointer&) {
    endDraft();
    emit changed();
}

void CrackLineTool::addToDraft(Vec2 point) {
    if (m_draft.empty() || m_draft.back() != point) m_draft.push_back(point);
}

void CrackLineTool::endPath() {
    std::vector<Vec2> points = simplified(m_path, kSimplifyTolerance / m_state.view.scale);
    m_path.clear();
    add(std::move(points));
}

void CrackLineTool::endDraft() {
    std::vector<Vec2> points = std::move(m_draft);
    m_draft.clear();
    m_path.clear();
    add(std::move(points));
}

void CrackLineTool::add(std::vector<Vec2> points) {
    if (points.size() < 2 || !m_state.planarAsset()) return;
    Asset asset = *m_state.asset();
    Edit edit{.text = tr("Draw Crack")};
    const auto isCrackLayer = [](const PatternLayer& layer) {
        return layer.isOn && std::holds_alternative<CrackLines>(layer.parameters);
    };
    auto& layers = m_state.patternIn(asset).layers;
    auto layer = std::find_if(layers.rbegin(), layers.rend(), isCrackLayer);
    if (layer == layers.rend()) {
        const Id id = edit.allocateId(m_state.document.project());
        layers.push_back({.id = id, .randomSeed = id, .parameters = CrackLines{}});
        layer = layers.rbegin();
    }
    std::vector<CrackLines::CrackLine>& lines = std::get<CrackLines>(layer->parameters).lines;
    const std::uint32_t index = lines.empty() ? 0 : lines.back().index + 1;
    m_selected = LinePoint{layer->id, index, points.size() - 1};
    lines.push_back({index, std::move(points)});
    edit.replacements = {Replacement<Asset>{asset.id, std::move(asset)}};
    m_state.push(std::move(edit));
}

void CrackLineTool::dragTo(Vec2 position) {
    Asset asset = m_drag->before;
    const LinePoint dragged = m_drag->point;
    CrackLines::CrackLine& line = *findLine(m_state.patternIn(asset), dragged.layer, dragged.line);
    const Vec2 from = line.points[dragged.point];
    const bool isClosed = line.points.front() == line.points.back();
    line.points[dragged.point] = position;
    // The ends of a closed line coincide.
    if (isClosed && from == line.points.back()) line.points.back() = position;
    if (isClosed && from == line.points.front()) line.points.front() = position;
    const auto same = std::ranges::adjacent_find(line.points);
    if (same == line.points.end()) m_state.push(modify(tr("Move Crack Point"), std::move(asset), m_drag->mergeKey));
}

void CrackLineTool::deleteSelectedPoint() {
    if (!m_selected || !m_state.planarAsset()) return;
    Asset asset = *m_state.asset();
    CrackLines::CrackLine* line = findLine(m_state.patternIn(asset), m_selected->layer, m_selected->line);
    if (!line || m_selected->point >= line->points.size()) return;
    if (line->points.size() <= 2) return deleteSelectedLine();
    line->points.erase(line->points.begin() + static_cast<std::ptrdiff_t>(m_selected->point));
    const auto repeated = std::ranges::unique(line->points);
    line->points.erase(repeated.begin(), repeated.end());
    if (line->points.size() < 2) return deleteSelectedLine();
    m_selected.reset();
    m_state.push(modify(tr("Delete Crack Point"), std::move(asset)));
}

void CrackLineTool::deleteSelectedLine() {
    if (!m_selected || !m_state.planarAsset()) return;
    Asset asset = *m_state.asset();
    PatternLayer* layer = findLayer(m_state.patternIn(asset), m_selected->layer);
    auto* lines = layer ? std::get_if<CrackLines>(&layer->parameters) : nullptr;
    if (!lines || std::erase_if(lines->lines, [&](const auto& line) { return line.index == m_selected->line; }) == 0)
        return;
    m_selected.reset();
    m_hovered.reset();
    m_state.push(modify(tr("Delete Crack"), std::move(asset)));
}

bool CrackLineTool::key(const QKeyEvent& event) {
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
                deleteSelectedPoint();
            }
            return true;
        case Qt::Key_Escape:
            if (!cancel() && !std::exchange(m_selected, std::nullopt)) return false;
            emit changed();
            return true;
        default: return false;
    }
}

bool CrackLineTool::cancel() {
    if (!isDrawing() && !m_drag) return false;
    if (m_drag && m_state.asset() && m_state.asset()->id == m_drag->before.id)
        m_state.push(modify(tr("Move Crack Point"), m_drag->before, m_drag->mergeKey));
    endDrag();
    m_draft.clear();
    emit changed();
    return true;
}

void CrackLineTool::endDrag() {
    m_drag.reset();
    m_path.clear();
    if (m_selected && m_state.planarAsset()) {
        const CrackLines::CrackLine* line =
            findLine(m_state.planarAsset()->pattern, m_selected->layer, m_selected->line);
        if (!line || m_selected->point >= line->points.size()) m_selected.reset();
    }
    m_hovered.reset();
    emit changed();
}

void CrackLineTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_state.planarAsset()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const auto paintLine = [&](const QPolygonF& path) {
        painter.setPen(QPen(colours.halo, kLineWidth + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(path);
        painter.setPen(QPen(colours.accent, kLineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(path);
    };
    const auto paintPoint = [&](QPointF at, const QColor& fill) {
        painter.setPen(QPen(colours.accent, 1.5));
        painter.setBrush(fill);
        painter.drawEllipse(at, kPointSize / 2.0, kPointSize / 2.0);
        painter.setBrush(Qt::NoBrush);
    };
    forEachLine(m_state.planarAsset()->pattern, [&](const PatternLayer& layer, const CrackLines::CrackLine& line) {
        const QPolygonF path = polyline(line.points, m_state.view);
        paintLine(path);
        for (std::size_t k = 0; k < line.points.size(); ++k) {
            const LinePoint point{layer.id, line.index, k};
            paintPoint(path[static_cast<qsizetype>(k)], m_selected == point  ? colours.accent
                                                        : m_hovered == point ? colours.hover
                                                                             : colours.halo);
        }
    });
    QPolygonF drawn = polyline(m_draft.empty() ? m_path : m_draft, m_state.view);
    if (drawn.isEmpty()) return;
    if (!m_draft.empty()) drawn.push_back(m_state.view.pixels(m_pointer));
    paintLine(drawn);
    for (const Vec2 point : m_draft) paintPoint(m_state.view.pixels(point), colours.accent);
}

Qt::CursorShape CrackLineTool::cursor() const { return m_drag || m_hovered ? Qt::SizeAllCursor : Qt::CrossCursor; }

QString CrackLineTool::hint() const {
    if (!m_draft.empty())
        return tr(
            "Click: add a point · Enter or double-click: finish · Backspace: remove the last point · Esc: cancel");
    if (!m_path.empty()) return tr("Release to finish");
    if (m_drag) return tr("Release to finish · Shift: no snapping · Esc: cancel");
    if (m_selected) return tr("Drag: move the point · Del: delete · Esc: clear the selection");
    return tr("Drag: draw a crack freehand · Click: draw straight lines · Drag a point: move it");
}

void CrackLineTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    if (const std::optional<LinePoint> point = pointAt(pointer)) m_selected = point;
    menu.addAction(tr("&End Crack"), this, &CrackLineTool::endDraft)->setEnabled(m_draft.size() > 1);
    menu.addSeparator();
    menu.addAction(tr("Delete &Point"), this, &CrackLineTool::deleteSelectedPoint)->setEnabled(m_selected.has_value());
    menu.addAction(tr("Delete &Crack"), this, &CrackLineTool::deleteSelectedLine)->setEnabled(m_selected.has_value());
    emit changed();
}

}  // namespace rubble

#include "moc_CrackLineTool.cpp"
