#include "editor/canvas/tools/SeedTool.h"

#include "core/fracture/pattern/SeedEdits.h"
#include "editor/canvas/painting/CanvasPainting.h"
#include "editor/canvas/tools/PieceSelection.h"
#include "editor/canvas/tools/Snapping.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/commands/SelectedSeedEdits.h"
#include "editor/document/CellSelection.h"
#include "editor/document/EnteredFragment.h"

#include <QApplication>

#include <algorithm>
#include <ranges>
#include <utility>

namespace rubble {

namespace {

constexpr double kSeedGrabRadius = 9.0;  // pixels, within which a press grabs a seed

QString moveText(std::size_t count) { return SeedTool::tr("Move %n Seed(s)", nullptr, static_cast<int>(count)); }

/// The layer that new seeds are placed in: the last enabled one of placed seeds; null if there is none.
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

/// The position of a seed that was placed or moved by hand.
std::optional<Vec2> positionByHand(const Pattern& pattern, SeedId seed) {
    const PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return std::nullopt;
    const auto positionIn = [&](const auto& list) -> std::optional<Vec2> {
        const auto found = std::ranges::lower_bound(list, seed.index, {}, [](const auto& each) { return each.index; });
        if (found == list.end() || found->index != seed.index) return std::nullopt;
        return found->position;
    };
    const auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    return placed ? positionIn(placed->seeds) : positionIn(layer->overrides);
}

}  // namespace

std::uint32_t SeedTool::seedAt(const CanvasPointer& pointer) const {
    return m_state.pattern ? m_state.pattern->nearestSeed(pointer.metres, kSeedGrabRadius / m_state.view.scale) : kNone;
}

std::uint32_t SeedTool::pieceAt(const CanvasPointer& pointer) const {
    return m_state.pattern ? m_state.pattern->pieceAt(pointer.metres) : kNone;
}

void SeedTool::press(const CanvasPointer& pointer) {
    m_pressed = pointer.pixels;
    m_pressedSeed.reset();
    m_hasMoved = false;
    if (!m_state.displayedAsset()) return;
    if (m_handles.press(pointer)) return emit changed();
    const std::uint32_t seed = seedAt(pointer);
    const bool isAdding = pointer.modifiers.testFlag(Qt::ControlModifier);
    if (seed == kNone) {
        const bool isLasso = pointer.modifiers.testFlag(Qt::AltModifier);
        using Shape = BoxLassoSelection::Shape;
        m_area = AreaDrag{{isLasso ? Shape::Lasso : Shape::Box, pointer.pixels}, isAdding};
        return;
    }
    if (!m_isPlacing) {  // a click selects the fragment, a drag moves the seed
        m_pressedSeed = m_state.pattern->seeds().ids[seed];
        return;
    }
    const SeedId id = m_state.pattern->seeds().ids[seed];
    if (isAdding) return m_state.selection.toggleSeed(id);
    if (!m_state.selection.seeds().contains(id)) m_state.selection.setSeeds({id});
    beginDrag(seed);
}

void SeedTool::beginDrag(std::uint32_t seed) {
    m_drag = {.before = *m_state.asset(),
              .from = selectedPositions(),
              .grabbed = m_state.pattern->seeds().positions[seed],
              .mergeKey = m_state.document.newMergeKey()};
    emit changed();
}

std::map<SeedId, Vec2> SeedTool::selectedPositions() const {
    std::map<SeedId, Vec2> positions;
    for (const SeedId id : m_state.selection.seeds()) {
        const std::uint32_t seed = m_state.pattern->find(id);
        if (seed == kNone) continue;
        // The baked position may be outdated.
        const std::optional<Vec2> byHand =
            m_state.isMesh() ? std::nullopt : positionByHand(m_state.displayedAsset()->pattern, id);
        positions.emplace(id, byHand.value_or(m_state.pattern->seeds().positions[seed]));
    }
    return positions;
}

void SeedTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if ((pointer.pixels - m_pressed).manhattanLength() >= QApplication::startDragDistance() / 2.0) m_hasMoved = true;
    m_handles.move(pointer, m_hasMoved);
    if (m_pressedSeed && m_hasMoved) {
        const SeedId id = *std::exchange(m_pressedSeed, std::nullopt);
        const std::uint32_t seed = m_state.pattern ? m_state.pattern->find(id) : kNone;  // a bake may have ended
        if (seed != kNone) {
            if (!m_state.selection.seeds().contains(id)) m_state.selection.setSeeds({id});
            beginDrag(seed);
        }
    }
    if (m_drag && m_hasMoved) {
        CanvasPointer seed = pointer;
        seed.metres = m_drag->grabbed + (pointer.metres - m_state.view.metres(m_pressed));
        dragBy(snapped(m_state, seed, outlineTargets(m_state)) - m_drag->grabbed);
    } else if (m_area) {
        m_area->area.dragTo(pointer.pixels);
    }
    m_hovered = seedAt(pointer);
    emit changed();
}

void SeedTool::dragBy(Vec2 by) {
    m_drag->by = by;
    Asset asset = m_drag->before;
    if (by != Vec2(0.0)) {
        Pattern& pattern = m_state.patternIn(asset);
        for (const auto& [id, from] : m_drag->from) m_state.moveSeed(pattern, id, from + by);
    }
    m_state.push(modify(moveText(m_drag->from.size()), std::move(asset), m_drag->mergeKey));
}

void SeedTool::release(const CanvasPointer& pointer) {
    if (m_area && m_hasMoved) {
        selectArea();
    } else if (m_area || m_pressedSeed) {
        click(pointer);
    }
    m_pressedSeed.reset();
    m_area.reset();
    m_drag.reset();
    m_handles.endDrag();
    emit changed();
}

/// Handles a click that is none on a seed of the tool that places seeds.
void SeedTool::click(const CanvasPointer& pointer) {
    const bool isAdding = m_area ? m_area->isAdding : pointer.modifiers.testFlag(Qt::ControlModifier);
    if (isAdding) {
        const std::uint32_t piece = pieceAt(pointer);
        if (piece != kNone && m_isPlacing) m_state.selection.toggleSeed(m_state.pattern->cellOf(piece));
        if (piece != kNone && !m_isPlacing) togglePiece(m_state, piece);
    } else if (m_isPlacing) {
        place(snapped(m_state, pointer, outlineTargets(m_state)));
    } else if (pointer.modifiers.testFlag(Qt::AltModifier)) {
        selectSeedAt(pointer);
    } else {
        selectAt(pointer);
    }
}

/// Selects the fragment at the pointer; outside of all, the seed, or nothing.
void SeedTool::selectAt(const CanvasPointer& pointer) {
    const std::uint32_t piece = pieceAt(pointer);
    piece == kNone ? selectSeedAt(pointer) : selectPieces(m_state, {piece});
}

/// Selects the seed at the pointer, or that of the cell there, with all fragments that come from it.
void SeedTool::selectSeedAt(const CanvasPointer& pointer) {
    const std::uint32_t piece = pieceAt(pointer), seed = seedAt(pointer);
    if (seed != kNone) return m_state.selection.setSeeds({m_state.pattern->seeds().ids[seed]});
    m_state.selection.setSeeds(piece == kNone ? Selection::Seeds() : Selection::Seeds{m_state.pattern->cellOf(piece)});
}

/// Enters the fractured fragment under the pointer, which the first click selected; the second click of a tool that
/// places seeds does nothing.
void SeedTool::doubleClick(const CanvasPointer& pointer) {
    if (m_isPlacing && seedAt(pointer) == kNone) return;
    const std::optional<FragmentPath> fractured = m_state.fracturedFragmentAt(pointer.metres);
    if (m_isPlacing || !fractured || pointer.modifiers != Qt::NoModifier || m_handles.isHovered())
        return press(pointer);
    enterFragment(m_state.selection, *fractured);
}

void SeedTool::selectArea() {
    if (m_isPlacing) return m_state.selection.setSeeds(seedsInArea());
    selectPieces(m_state, piecesInArea(), m_area->isAdding);
}

Selection::Seeds SeedTool::seedsInArea() const {
    Selection::Seeds seeds;
    if (m_area->isAdding) seeds = m_state.selection.seeds();
    if (!m_state.pattern) return seeds;
    const std::vector<Vec2>& positions = m_state.pattern->seeds().positions;
    for (std::size_t seed = 0; seed < positions.size(); ++seed) {
        if (m_area->area.contains(m_state.view.pixels(positions[seed])))
            seeds.insert(m_state.pattern->seeds().ids[seed]);
    }
    return seeds;
}

/// The pieces whose seed is in the area, if the piece is all of its cell; else those whose centroid is.
std::vector<std::uint32_t> SeedTool::piecesInArea() const {
    std::vector<std::uint32_t> pieces;
    if (!m_state.pattern) return pieces;
    const DrawablePattern& pattern = *m_state.pattern;
    for (std::uint32_t piece = 0; piece < pattern.partition().pieceCount(); ++piece) {
        const std::uint32_t seed = pattern.partition().seedOfPiece[piece];
        const IndexRange own = seed == kNone ? IndexRange{} : pattern.piecesOf(seed);
        const Vec2 place = own.end - own.begin == 1 ? pattern.seeds().positions[seed] : pattern.centroid(piece);
        if (m_area->area.contains(m_state.view.pixels(place))) pieces.push_back(piece);
    }
    return pieces;
}

void SeedTool::place(Vec2 position) {
    Asset asset = *m_state.asset();
    Pattern& pattern = m_state.patternIn(asset);
    Edit edit{.text = tr("Place Seed")};
    PatternLayer* layer = placedLayer(pattern);
    if (!layer) {
        const Id id = edit.allocateId(m_state.document.project());
        pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = PlacedSeeds{}});
        layer = &pattern.layers.back();
    }
    m_state.placeSeed(*layer, position);
    edit.replacements = {Replacement<Asset>{asset.id, std::move(asset)}};
    m_state.push(std::move(edit));
}

bool SeedTool::cancel() {
    if (!isDragOfSeed() && !m_area && !m_handles.isDragging()) return false;
    m_pressedSeed.reset();
    m_handles.cancel();
    if (m_drag && m_state.asset() && m_state.asset()->id == m_drag->before.id) dragBy({0.0, 0.0});
    m_drag.reset();
    m_area.reset();
    emit changed();
    return true;
}

void SeedTool::endDrag() {
    m_pressedSeed.reset();
    m_drag.reset();
    m_handles.endDrag();
    emit changed();
}

bool SeedTool::key(const QKeyEvent& event) {
    if (const std::optional<Vec2> by = nudgeStep(event, m_state)) {
        nudge(*by, event.isAutoRepeat());
        return true;
    }
    if (event.matches(QKeySequence::SelectAll)) {
        selectAll();
        return true;
    }
    switch (event.key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace: deleteSelected(); return true;
        case Qt::Key_PageDown: selectNext(1); return true;
        case Qt::Key_PageUp: selectNext(-1); return true;
        case Qt::Key_Insert:
            if (m_state.displayedAsset()) place(m_state.view.centre);
            return true;
        case Qt::Key_Escape:
            if (cancel()) return true;
            if (m_state.selection.fragments().isEmpty()) return false;
            m_state.selection.setSeeds({});
            return true;
        default: return false;
    }
}

void SeedTool::nudge(Vec2 by, bool isRepeated) {
    if (!m_state.displayedAsset() || !m_state.pattern || m_drag || m_state.selection.seeds().empty()) return;
    Asset asset = *m_state.asset();
    const std::map<SeedId, Vec2> positions = selectedPositions();
    if (positions.empty()) return;
    Pattern& pattern = m_state.patternIn(asset);
    for (const auto& [id, from] : positions) m_state.moveSeed(pattern, id, from + by);
    m_state.push(modify(moveText(positions.size()), std::move(asset), nudgeMergeKey(isRepeated)));
}

/// Selects the next or previous fragment, or seed while seeds are placed.
void SeedTool::selectNext(int by) {
    if (!m_state.pattern) return;
    const auto next = [by](std::size_t count, std::uint32_t selected) {
        const std::int64_t now = selected != kNone ? selected : by > 0 ? -1 : 0, all = static_cast<std::int64_t>(count);
        return static_cast<std::uint32_t>((now + by + all) % all);
    };
    if (!m_isPlacing) {
        const std::vector<std::uint32_t> selected = selectedPieces(m_state);
        const std::uint32_t count = m_state.pattern->partition().pieceCount();
        if (count > 0) selectPieces(m_state, {next(count, selected.empty() ? kNone : selected.front())});
        return;
    }
    const std::vector<SeedId>& ids = m_state.pattern->seeds().ids;
    if (ids.empty()) return;
    const Selection::Seeds& seeds = m_state.selection.seeds();
    m_state.selection.setSeeds({ids[next(ids.size(), seeds.empty() ? kNone : m_state.pattern->find(*seeds.begin()))]});
}

void SeedTool::deleteSelected() {
    const Selection::Seeds seeds = selectedSeeds();
    if (!m_state.displayedAsset() || seeds.empty()) return;
    Edit edit = deleteSeeds(*m_state.asset(), m_state.selection.enteredFragment(), seeds);
    cancel();
    m_state.selection.setSeeds({});
    m_state.push(std::move(edit));
}

void SeedTool::restoreSelected() {
    const Selection::Seeds seeds = selectedSeeds();
    if (!m_state.displayedAsset() || seeds.empty()) return;
    Edit edit = restoreSeeds(*m_state.asset(), m_state.selection.enteredFragment(), seeds);
    if (!edit.isEmpty()) m_state.push(std::move(edit));
}

Selection::Seeds SeedTool::selectedSeeds() const {
    return m_state.pattern ? seedsAmong(m_state.pattern->baked(), m_state.selection.seeds()) : Selection::Seeds();
}

void SeedTool::selectAll() {
    if (m_state.pattern) m_state.selection.setSeeds(allCells(m_state.pattern->baked()));
}

void SeedTool::selectNeighbours() {
    if (!m_state.pattern) return;
    if (m_state.selection.fragments().ids) {
        std::vector<std::uint32_t> pieces = selectedPieces(m_state);
        for (std::size_t k = 0, count = pieces.size(); k < count; ++k) {
            const std::vector<std::uint32_t> around = m_state.pattern->neighbours(pieces[k]);
            pieces.insert(pieces.end(), around.begin(), around.end());
        }
        return selectPieces(m_state, pieces);
    }
    m_state.selection.setSeeds(withNeighbourCells(m_state.pattern->baked(), m_state.selection.seeds()));
}

void SeedTool::invertSelection() {
    if (!m_state.pattern) return;
    if (m_state.selection.fragments().ids) {
        const std::vector<std::uint32_t> selected = selectedPieces(m_state);
        std::vector<std::uint32_t> others;
        for (std::uint32_t piece = 0; piece < m_state.pattern->partition().pieceCount(); ++piece) {
            if (!std::ranges::binary_search(selected, piece)) others.push_back(piece);
        }
        return selectPieces(m_state, others);
    }
    m_state.selection.setSeeds(invertedCells(m_state.pattern->baked(), m_state.selection.seeds()));
}

void SeedTool::paint(QPainter& painter, const CanvasColours& colours) const {
    m_handles.paint(painter, colours);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_area && m_hasMoved) m_area->area.paint(painter, colours);
    if (!m_drag || !m_state.pattern || !m_state.displayedAsset()) return;
    painter.setPen(QPen(colours.halo, 1.5));
    painter.setBrush(colours.accent);
    const double radius = std::max(seedRadius(*m_state.pattern, m_state.view), 3.0);
    for (const auto& [id, from] : m_drag->from) {
        const SeedOrigin origin =
            isPlaced(m_state.displayedAsset()->pattern, id) ? SeedOrigin::Placed : SeedOrigin::Moved;
        paintSeedMarker(painter, m_state.view.pixels(from + m_drag->by), radius, origin);
    }
}

Qt::CursorShape SeedTool::cursor() const {
    if (m_drag || m_handles.isDragging() || m_handles.isHovered()) return Qt::SizeAllCursor;
    if (m_hovered != kNone) return Qt::PointingHandCursor;
    return m_isPlacing ? Qt::CrossCursor : Qt::ArrowCursor;
}

QString SeedTool::hint() const {
    if (!m_state.displayedAsset()) return {};
    if (m_handles.isHovered() && !m_handles.isDragging()) return tr("%1: drag to move").arg(m_handles.text());
    if (m_drag || m_handles.isDragging()) return tr("Release to finish · Shift: no snapping · Esc: cancel");
    if (!m_state.selection.seeds().empty()) return selectionHint();
    if (m_isPlacing) return tr("Click: place a seed · Drag a seed: move it · Alt+Q: select fragments");
    const Asset* asset = m_state.asset();
    const bool hasFractured = asset && !(asset->levels.empty() && asset->fragmentLevels.empty());
    return tr("Click: select a fragment · Ctrl+click: add · Alt+click: select a seed · Drag a seed: move it · "
              "Drag elsewhere: box select · Alt+drag: lasso select · Alt+N: place seeds") +
           (m_state.isInFragment() ? tr(" · Esc: exit the fragment")
            : hasFractured         ? tr(" · Double-click: enter a fragment")
                                   : QString());
}

QString SeedTool::selectionHint() const {
    const int fragments = static_cast<int>(selectedPieces(m_state).size());
    const int seeds = static_cast<int>(selectedSeeds().size());
    if (m_isPlacing || fragments == 0) {
        return tr("%Ln seed(s) selected · Drag or arrow keys: move · Del: delete · Ctrl+click: add · Esc: deselect",
                  nullptr, seeds);
    }
    if (seeds == 0) return tr("%Ln fragment(s) selected · Ctrl+click: add · Esc: deselect", nullptr, fragments);
    return tr("%Ln fragment(s) selected · Drag a seed: move · Del: delete seeds · Ctrl+click: add · Esc: deselect",
              nullptr, fragments);
}

void SeedTool::fillMenu(QMenu& menu, const CanvasPointer& pointer) {
    const std::uint32_t seed = seedAt(pointer);
    if (seed != kNone && !m_state.selection.seeds().contains(m_state.pattern->seeds().ids[seed])) {
        m_isPlacing ? m_state.selection.setSeeds({m_state.pattern->seeds().ids[seed]}) : selectAt(pointer);
    }
    const bool hasSelection = !m_state.selection.seeds().empty();
    const bool hasMoved = std::ranges::any_of(m_state.selection.seeds(), [&](SeedId id) {
        const std::uint32_t index = m_state.pattern ? m_state.pattern->find(id) : kNone;
        return index != kNone && m_state.pattern->origin(index) == SeedOrigin::Moved;
    });
    if (m_state.displayedAsset() && seed == kNone) {
        const Vec2 position = snapped(m_state, pointer, outlineTargets(m_state));
        menu.addAction(tr("&Place Seed Here"), this, [this, position] { place(position); });
        menu.addSeparator();
    }
    menu.addAction(tr("&Delete Seeds"), this, &SeedTool::deleteSelected)->setEnabled(!selectedSeeds().empty());
    menu.addAction(tr("&Restore Seeds"), this, &SeedTool::restoreSelected)->setEnabled(hasMoved);
    menu.addSeparator();
    menu.addAction(tr("Select &All"), this, &SeedTool::selectAll)->setEnabled(m_state.pattern != nullptr);
    menu.addAction(tr("Select &Neighbours"), this, &SeedTool::selectNeighbours)->setEnabled(hasSelection);
    menu.addAction(tr("&Invert Selection"), this, &SeedTool::invertSelection)->setEnabled(m_state.pattern != nullptr);
}

}  // namespace rubble

#include "moc_SeedTool.cpp"
