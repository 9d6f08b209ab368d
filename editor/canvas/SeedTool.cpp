#include "editor/canvas/SeedTool.h"

#include "core/fracture/SeedEdits.h"
#include "editor/canvas/CanvasPainting.h"
#include "editor/canvas/Snapping.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/CellChoice.h"
#include "editor/document/Inside.h"

#include <QApplication>

#include <algorithm>
#include <ranges>

namespace rubble {

namespace {

constexpr double kGrabReach = 9.0;  // pixels from a seed within which a press takes it

QString moveText(std::size_t count) {
    return count == 1 ? SeedTool::tr("Move seed") : SeedTool::tr("Move %1 seeds").arg(count);
}

/// The layer that seeds are placed in: the last one of its kind, or none.
PatternLayer* placedLayer(Pattern& pattern) {
    for (PatternLayer& layer : pattern.layers | std::views::reverse) {
        if (layer.isOn && std::holds_alternative<PlacedSeeds>(layer.parameters)) return &layer;
    }
    return nullptr;
}

bool isPlaced(const Pattern& pattern, SeedId seed) {
    const PatternLayer* layer = findLayer(pattern, seed.layer);
    return layer && std::holds_alternative<PlacedSeeds>(layer->parameters);
}

/// Where a seed stands that was placed or moved by hand.
std::optional<Vec2> positionByHand(const Pattern& pattern, SeedId seed) {
    const PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return std::nullopt;
    const auto positionIn = [&](const auto& list) -> std::optional<Vec2> {
        const auto place = std::ranges::lower_bound(list, seed.index, {}, [](const auto& each) { return each.index; });
        if (place == list.end() || place->index != seed.index) return std::nullopt;
        return place->position;
    };
    const auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    return placed ? positionIn(placed->seeds) : positionIn(layer->overrides);
}

}  // namespace

std::uint32_t SeedTool::seedAt(const CanvasPointer& pointer) const {
    return m_state.pattern ? m_state.pattern->seedNear(pointer.metres, kGrabReach / m_state.view.scale) : kNone;
}

void SeedTool::press(const CanvasPointer& pointer) {
    m_pressed = pointer.pixels;
    m_hasMoved = false;
    m_placed.reset();
    if (!m_state.shown()) return;
    if (m_handles.press(pointer)) return emit changed();
    const std::uint32_t seed = seedAt(pointer);
    const bool isAdding = pointer.modifiers.testFlag(Qt::ControlModifier);
    if (seed == kNone) {
        m_catch = {{{pointer.pixels}}, pointer.modifiers.testFlag(Qt::AltModifier), isAdding};
        return;
    }
    const SeedId id = m_state.pattern->seeds().ids[seed];
    if (isAdding) return m_state.selection.toggleSeed(id);
    if (!m_state.selection.seeds().contains(id)) m_state.selection.setSeeds({id});
    beginDrag(seed);
}

void SeedTool::beginDrag(std::uint32_t seed) {
    m_drag = {.before = *m_state.asset(),
              .from = chosenPositions(),
              .grabbed = m_state.pattern->seeds().positions[seed],
              .stroke = m_state.document.newStroke()};
    emit changed();
}

std::map<SeedId, Vec2> SeedTool::chosenPositions() const {
    std::map<SeedId, Vec2> positions;
    for (const SeedId id : m_state.selection.seeds()) {
        const std::uint32_t seed = m_state.pattern->find(id);
        if (seed == kNone) continue;
        // What was baked may be a moment old.
        const std::optional<Vec2> byHand = positionByHand(m_state.shown()->pattern, id);
        positions.emplace(id, byHand.value_or(m_state.pattern->seeds().positions[seed]));
    }
    return positions;
}

void SeedTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if ((pointer.pixels - m_pressed).manhattanLength() >= QApplication::startDragDistance() / 2.0) m_hasMoved = true;
    m_handles.move(pointer, m_hasMoved);
    if (m_drag && m_hasMoved) {
        CanvasPointer seed = pointer;
        seed.metres = m_drag->grabbed + (pointer.metres - m_state.view.metres(m_pressed));
        dragBy(snapped(m_state, seed, outlineTargets(m_state)) - m_drag->grabbed);
    } else if (m_catch) {
        if (!m_catch->isLasso) m_catch->path.resize(1);
        m_catch->path.push_back(pointer.pixels);
    }
    m_hovered = seedAt(pointer);
    emit changed();
}

void SeedTool::dragBy(Vec2 by) {
    m_drag->by = by;
    Asset asset = m_drag->before;
    if (by != Vec2(0.0)) {
        Pattern& pattern = m_state.patternIn(asset);
        for (const auto& [id, from] : m_drag->from) moveSeed(pattern, id, from + by);
    }
    m_state.document.push(altered(moveText(m_drag->from.size()), std::move(asset), m_drag->stroke));
}

void SeedTool::release(const CanvasPointer& pointer) {
    if (m_catch && m_hasMoved) {
        m_state.selection.setSeeds(caught());
    } else if (m_catch) {
        click(pointer);
    }
    m_catch.reset();
    m_drag.reset();
    m_handles.letGo();
    emit changed();
}

/// Where no seed is: on a piece that cuts alone have made it chooses that one, as a click on a seed does its own.
void SeedTool::click(const CanvasPointer& pointer) {
    const bool isAdding = m_catch->isAdding;
    const std::uint32_t piece = m_state.pattern ? m_state.pattern->pieceAt(pointer.metres) : kNone;
    if (piece != kNone && (isAdding || hasCutsAlone())) {
        const SeedId cell = m_state.pattern->cellOf(piece);
        if (isAdding) return m_state.selection.toggleSeed(cell);
        return m_state.selection.setSeeds({cell});
    }
    if (isAdding) return;
    if (!m_state.selection.choice().isEmpty()) return m_state.selection.setSeeds({});
    const quint64 stroke = m_state.document.newStroke();
    m_placed = Placed{*m_state.asset(), m_state.document.project().nextId, m_state.brokenAt(pointer.metres), stroke};
    place(snapped(m_state, pointer, outlineTargets(m_state)), stroke);
}

/// Goes into the fragment that is pointed at. A seed that the first of the two clicks placed was not meant; where there is no
/// such fragment it stays, and gets no second one in its place.
void SeedTool::doubleClick(const CanvasPointer& pointer) {
    const std::optional<Placed> placed = std::exchange(m_placed, std::nullopt);
    const std::optional<FragmentPath> broken = placed ? placed->broken : m_state.brokenAt(pointer.metres);
    if (placed && !broken) return;
    if (!broken || pointer.modifiers != Qt::NoModifier || m_handles.isPointedAt()) return press(pointer);
    if (placed) takeBack(*placed);
    goInto(m_state.selection, *broken);
}

void SeedTool::takeBack(const Placed& placed) {
    Edit edit = altered(tr("Place seed"), placed.before, placed.stroke);
    edit.nextId = placed.nextId;
    m_state.document.push(std::move(edit));
}

bool SeedTool::hasCutsAlone() const {
    return m_state.pattern && m_state.pattern->seeds().ids.empty() && !m_state.pattern->partition().cutLayers.empty();
}

Selection::Seeds SeedTool::caught() const {
    Selection::Seeds seeds;
    if (m_catch->isAdding) seeds = m_state.selection.seeds();
    if (!m_state.pattern) return seeds;
    const QRectF box = QRectF(m_catch->path.front(), m_catch->path.back()).normalized();
    const auto isCaught = [&](Vec2 place) {
        const QPointF at = m_state.view.pixels(place);
        return m_catch->isLasso ? m_catch->path.containsPoint(at, Qt::OddEvenFill) : box.contains(at);
    };
    const std::vector<Vec2>& positions = m_state.pattern->seeds().positions;
    for (std::size_t seed = 0; seed < positions.size(); ++seed) {
        if (isCaught(positions[seed])) seeds.insert(m_state.pattern->seeds().ids[seed]);
    }
    if (!hasCutsAlone()) return seeds;
    for (std::uint32_t piece = 0; piece < m_state.pattern->partition().pieceCount(); ++piece) {
        if (isCaught(m_state.pattern->middle(piece))) seeds.insert(m_state.pattern->cellOf(piece));
    }
    return seeds;
}

void SeedTool::place(Vec2 position, quint64 stroke) {
    Asset asset = *m_state.asset();
    Pattern& pattern = m_state.patternIn(asset);
    Edit edit{.text = tr("Place seed"), .stroke = stroke};
    PatternLayer* layer = placedLayer(pattern);
    if (!layer) {
        const Id id = edit.takeId(m_state.document.project());
        pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = PlacedSeeds{}});
        layer = &pattern.layers.back();
    }
    placeSeed(*layer, position);
    edit.swaps = {Swap<Asset>{asset.id, std::move(asset)}};
    m_state.document.push(std::move(edit));
}

bool SeedTool::cancel() {
    if (!m_drag && !m_catch && !m_handles.isHeld()) return false;
    m_handles.cancel();
    if (m_drag && m_state.asset() && m_state.asset()->id == m_drag->before.id) dragBy({0.0, 0.0});
    m_drag.reset();
    m_catch.reset();
    emit changed();
    return true;
}

void SeedTool::letGo() {
    m_drag.reset();
    m_placed.reset();
    m_handles.letGo();
    emit changed();
}

bool SeedTool::key(const QKeyEvent& event) {
    if (const std::optional<Vec2> by = nudgeOf(event, m_state)) {
        nudge(*by, event.isAutoRepeat());
        return true;
    }
    if (event.matches(QKeySequence::SelectAll)) {
        chooseAll();
        return true;
    }
    switch (event.key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace: deleteChosen(); return true;
        case Qt::Key_PageDown: chooseNext(1); return true;
        case Qt::Key_PageUp: chooseNext(-1); return true;
        case Qt::Key_Insert:
            if (m_state.shown()) place(m_state.view.centre);
            return true;
        case Qt::Key_Escape:
            if (cancel()) return true;
            if (m_state.selection.choice().isEmpty()) return false;
            m_state.selection.setSeeds({});
            return true;
        default: return false;
    }
}

void SeedTool::nudge(Vec2 by, bool isRepeated) {
    if (!m_state.shown() || !m_state.pattern || m_drag || m_state.selection.seeds().empty()) return;
    Asset asset = *m_state.asset();
    const std::map<SeedId, Vec2> positions = chosenPositions();
    if (positions.empty()) return;
    Pattern& pattern = m_state.patternIn(asset);
    for (const auto& [id, from] : positions) moveSeed(pattern, id, from + by);
    m_state.document.push(altered(moveText(positions.size()), std::move(asset), nudgeStroke(isRepeated)));
}

void SeedTool::chooseNext(int by) {
    if (!m_state.pattern || m_state.pattern->seeds().ids.empty()) return;
    const std::vector<SeedId>& ids = m_state.pattern->seeds().ids;
    const auto count = static_cast<std::int64_t>(ids.size());
    const std::uint32_t chosen =
        m_state.selection.seeds().empty() ? kNone : m_state.pattern->find(*m_state.selection.seeds().begin());
    const std::int64_t now = chosen != kNone ? chosen : by > 0 ? -1 : 0;
    m_state.selection.setSeeds({ids[static_cast<std::size_t>((now + by + count) % count)]});
}

/// Bricks and slices are chosen by the same names, but are no seeds.
Selection::Seeds SeedTool::chosenSeeds() const {
    Selection::Seeds seeds;
    for (const SeedId id : m_state.selection.seeds()) {
        if (m_state.pattern && m_state.pattern->find(id) != kNone) seeds.insert(id);
    }
    return seeds;
}

void SeedTool::deleteChosen() {
    const Selection::Seeds seeds = chosenSeeds();
    if (!m_state.shown() || seeds.empty()) return;
    Asset asset = *m_state.asset();
    Pattern& pattern = m_state.patternIn(asset);
    // In the order in which the lists that they are taken from and noted in have little to move.
    for (const SeedId seed : seeds) {
        if (!isPlaced(pattern, seed)) deleteSeed(pattern, seed);
    }
    for (const SeedId seed : seeds | std::views::reverse) {
        if (isPlaced(pattern, seed)) deleteSeed(pattern, seed);
    }
    cancel();
    const QString text = seeds.size() == 1 ? tr("Delete seed") : tr("Delete %1 seeds").arg(seeds.size());
    m_state.selection.setSeeds({});
    m_state.document.push(altered(text, std::move(asset)));
}

void SeedTool::restoreChosen() {
    const Selection::Seeds seeds = chosenSeeds();
    if (!m_state.shown() || seeds.empty()) return;
    Asset asset = *m_state.asset();
    Pattern& pattern = m_state.patternIn(asset);
    for (const SeedId seed : seeds) restoreSeed(pattern, seed);
    m_state.document.push(altered(tr("Restore seeds"), std::move(asset)));
}

void SeedTool::chooseAll() {
    if (m_state.pattern) m_state.selection.setSeeds(allCells(m_state.pattern->baked()));
}

void SeedTool::chooseNeighbours() {
    if (!m_state.pattern) return;
    m_state.selection.setSeeds(withNeighbourCells(m_state.pattern->baked(), m_state.selection.seeds()));
}

void SeedTool::invertChoice() {
    if (m_state.pattern) m_state.selection.setSeeds(otherCells(m_state.pattern->baked(), m_state.selection.seeds()));
}

void SeedTool::paint(QPainter& painter, const CanvasColours& colours) const {
    m_handles.paint(painter, colours);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_catch && m_hasMoved) {
        QColor fill = colours.accent;
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.setPen(QPen(colours.accent, 1.0, Qt::DashLine));
        if (m_catch->isLasso) {
            painter.drawPolygon(m_catch->path);
        } else {
            painter.drawRect(QRectF(m_catch->path.front(), m_catch->path.back()).normalized());
        }
    }
    if (!m_drag || !m_state.pattern || !m_state.shown()) return;
    painter.setPen(QPen(colours.halo, 1.5));
    painter.setBrush(colours.accent);
    const double radius = std::max(seedRadius(*m_state.pattern, m_state.view), 3.0);
    for (const auto& [id, from] : m_drag->from) {
        const SeedOrigin origin = isPlaced(m_state.shown()->pattern, id) ? SeedOrigin::Placed : SeedOrigin::Moved;
        paintSeedSign(painter, m_state.view.pixels(from + m_drag->by), radius, origin);
    }
}

Qt::CursorShape SeedTool::cursor() const {
    if (m_drag || m_handles.isHeld() || m_handles.isPointedAt()) return Qt::SizeAllCursor;
    return m_hovered != kNone ? Qt::PointingHandCursor : Qt::CrossCursor;
}

QString SeedTool::hint() const {
    if (m_handles.isPointedAt() && !m_handles.isHeld()) return tr("%1: drag to move").arg(m_handles.text());
    if (m_drag || m_handles.isHeld()) return tr("Release to drop · Shift: without snapping · Esc: put back");
    if (hasCutsAlone()) {
        return tr(
            "Click: choose a piece · Ctrl+click: add · drag: choose by a box, with Alt by a lasso · Esc: choose none");
    }
    if (!m_state.selection.seeds().empty()) {
        const std::size_t count = m_state.selection.seeds().size();
        return (count == 1 ? tr("1 seed chosen") : tr("%1 seeds chosen").arg(count)) +
               tr(" · drag or arrow keys: move · Del: delete · Ctrl+click: add · Esc: choose none");
    }
    const Asset* asset = m_state.asset();
    const bool hasBroken = asset && !(asset->levels.empty() && asset->leaves.empty());
    return tr("Click: place a seed · drag a seed: move it · drag elsewhere: choose by a box, with Alt by a lasso") +
           (m_state.isInside() ? tr(" · Esc: go out")
            : hasBroken        ? tr(" · double click: go into a fragment")
                               : QString());
}

void SeedTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    const std::uint32_t seed = seedAt(pointer);
    if (seed != kNone && !m_state.selection.seeds().contains(m_state.pattern->seeds().ids[seed])) {
        m_state.selection.setSeeds({m_state.pattern->seeds().ids[seed]});
    }
    const bool hasChoice = !m_state.selection.seeds().empty();
    const bool hasMoved = std::ranges::any_of(m_state.selection.seeds(), [&](SeedId id) {
        const std::uint32_t chosen = m_state.pattern ? m_state.pattern->find(id) : kNone;
        return chosen != kNone && m_state.pattern->origin(chosen) == SeedOrigin::Moved;
    });
    if (m_state.shown() && seed == kNone) {
        const Vec2 position = snapped(m_state, pointer, outlineTargets(m_state));
        menu.addAction(tr("&Place Seed Here"), this, [this, position] { place(position); });
        menu.addSeparator();
    }
    menu.addAction(tr("&Delete Seeds"), this, &SeedTool::deleteChosen)->setEnabled(!chosenSeeds().empty());
    menu.addAction(tr("&Restore Moved Seeds"), this, &SeedTool::restoreChosen)->setEnabled(hasMoved);
    menu.addSeparator();
    menu.addAction(tr("Choose &All"), this, &SeedTool::chooseAll)->setEnabled(m_state.pattern != nullptr);
    menu.addAction(tr("Choose &Neighbours Too"), this, &SeedTool::chooseNeighbours)->setEnabled(hasChoice);
    menu.addAction(tr("&Invert Choice"), this, &SeedTool::invertChoice)->setEnabled(m_state.pattern != nullptr);
}

}  // namespace rubble
