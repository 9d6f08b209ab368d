#include "editor/canvas/widget/CanvasContentsUpdater.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/strength/FragmentThresholds.h"
#include "core/asset/strength/Threshold.h"
#include "editor/canvas/painting/FragmentEdges.h"

#include <algorithm>
#include <utility>

namespace rubble {

void CanvasContentsUpdater::setOverlays(const CanvasOverlays& overlays) {
    m_contents.overlays = overlays;
    refreshShapes();
    refreshDepths();
    refreshMovedPart();
    refreshBonds();
    m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::setCompared(std::shared_ptr<const ComparedAsset> compared) {
    if (compared == m_compared) return;
    m_compared = std::move(compared);
    refreshComparison();
    refreshBonds();
    m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::refreshAll() {
    m_contents.hidden = m_state.selection.hidden();
    refreshSurroundings();
    refreshComparison();
    refreshMaterial();
    refreshPattern();
    refreshShapes();
    refreshDepths();
    refreshBonds();
    m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::refreshHidden() {
    m_contents.hidden = m_state.selection.hidden();
    m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::refreshMaterial() {
    const Asset* asset = m_state.asset();
    const Material* material = asset ? findMaterial(m_state.document.project(), asset->material) : nullptr;
    m_contents.density = material ? material->density : 0.0;
    const FragmentPath& entered = m_state.selection.enteredFragment();
    const std::optional<double> set =
        asset && !entered.empty() ? fragmentThreshold(*asset, entered, levelOf(entered)) : std::nullopt;
    m_contents.threshold = material ? set.value_or(thresholdOf(*asset, *material)) : 0.0;
}

void CanvasContentsUpdater::refreshPattern() {
    const std::shared_ptr<const BakedPattern> baked =
        m_state.bakes.findPattern(m_state.selection.asset(), m_state.selection.enteredFragment());
    const std::shared_ptr<const DrawablePattern> before = m_contents.pattern;
    if (before && &before->baked() == baked.get()) return;
    const std::shared_ptr<const MovedPart> movedBefore = m_contents.moved;
    const Asset* shown = m_contents.asset();
    const DrawablePattern::Range range = m_contents.range;
    m_contents.pattern = baked && !baked->fault ? std::make_shared<const DrawablePattern>(baked) : nullptr;
    m_contents.range = scale();
    refreshShapes();
    m_movedCells = m_contents.pattern ? std::make_unique<MovedCells>(m_contents.pattern) : nullptr;
    computeMovedPart();
    refreshBonds();
    if (!before || !m_contents.pattern || range != m_contents.range || !isLocal()) {
        m_backingStore.invalidateAll();
    } else if (*shown != *m_contents.asset()) {  // otherwise it is painted already
        Box2 box = differenceBox(*before, *m_contents.pattern);
        include(box, movedBox(movedBefore.get()));
        include(box, movedBox(m_contents.moved.get()));
        m_backingStore.invalidate(box);
    }
}

void CanvasContentsUpdater::refreshMovedPart() {
    const std::shared_ptr<const MovedPart> before = m_contents.moved;
    computeMovedPart();
    Box2 box = movedBox(before.get());
    include(box, movedBox(m_contents.moved.get()));
    m_backingStore.invalidate(box);
}

void CanvasContentsUpdater::refreshFragments() {
    refreshSurroundings();
    refreshShapes();
    if (m_contents.overlays.colouring == CellColouring::Level) refreshDepths();
    refreshBonds();
}

void CanvasContentsUpdater::refreshBonds() {
    const std::shared_ptr<const BondMarks> before = m_contents.bondMarks;
    refreshBondMarks();
    const auto& now = m_contents.bondMarks;
    const bool isSame = before && now ? before->clusterColours == now->clusterColours : before == now;
    if (!isSame && m_contents.overlays.colouring == CellColouring::Cluster) m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::refreshBondMarks() {
    const Asset* asset = m_state.asset();
    const bool isMarked = asset && asset->breakAs == BreakAs::Bonded && !m_contents.compared;
    if (isMarked) refreshBondMarker();
    if (!isMarked || !m_bondMarker) {
        m_contents.bondMarks = nullptr;
        m_bondKey.reset();
        return;
    }
    const BondPainter& painter = m_state.bondPainter;
    const bool paintsStrengths = painter.isOn() && painter.settings().brush == BondBrush::Strength;
    BondKey key{asset->bonding, m_bondMarker->levelStrengthIn(*asset),
                m_contents.overlays.hasBondStrengths || paintsStrengths};
    if (painter.stroke()) key.bonding.strokes.push_back(*painter.stroke());
    if (key == m_bondKey) return;
    Asset shown = *asset;
    shown.bonding = key.bonding;
    m_contents.bondMarks = std::make_shared<const BondMarks>(m_bondMarker->marks(shown, key.showsStrengths));
    m_bondKey = std::move(key);
}

/// The fragments whose bonds are marked: those of the displayed pattern.
void CanvasContentsUpdater::refreshBondMarker() {
    const std::shared_ptr<const BakedAsset> baked = m_state.bakes.find(m_state.selection.asset());
    if (m_bondMarker && baked == m_bondBake && m_contents.pattern == m_bondPattern) return;
    m_bondBake = baked;
    m_bondPattern = m_contents.pattern;
    m_bondMarker = baked && m_contents.pattern ? BondMarker::of(baked->bake, *m_contents.pattern) : nullptr;
    m_bondKey.reset();
}

void CanvasContentsUpdater::refreshSurroundings() {
    if (m_contents.surroundings.empty() && !m_state.isInFragment()) return;
    const auto baked = m_state.bakes.find(m_state.selection.asset());
    if (baked && !baked->bake && m_state.isInFragment()) return;  // keeps the surroundings from before the error
    m_contents.surroundings.clear();
    if (baked && m_state.isInFragment())
        m_contents.surroundings = surroundingEdges(*baked->bake, m_state.selection.enteredFragment());
    m_backingStore.invalidateAll();
}

/// The shapes of the fragments, if those were baked from the displayed pattern.
void CanvasContentsUpdater::refreshShapes() {
    const bool hadShapes = m_contents.shrunk || !m_contents.deeperEdges.empty();
    m_contents.shrunk = nullptr;
    m_contents.deeperEdges.clear();
    const auto baked = m_state.bakes.find(m_state.selection.asset());
    const FragmentPath& entered = m_state.selection.enteredFragment();
    const Fragments* fragments = baked && baked->bake ? fragmentsWithin(*baked->bake, entered) : nullptr;
    const ExtrudedPieces* pieces = fragments ? fragments->extruded() : nullptr;
    if (pieces && m_contents.pattern && areSamePieces(pieces->partition, m_contents.pattern->partition())) {
        m_contents.shrunk = pieces->shrunk;
        if (m_contents.overlays.hasDeeperLevels) m_contents.deeperEdges = deeperEdges(*baked->bake, entered);
    }
    if (hadShapes || m_contents.shrunk || !m_contents.deeperEdges.empty()) m_backingStore.invalidateAll();
}

/// Computes the number of further levels of each displayed fragment, if cells are coloured by it.
void CanvasContentsUpdater::refreshDepths() {
    m_contents.depths.clear();
    const auto baked = m_state.bakes.find(m_state.selection.asset());
    if (m_contents.overlays.colouring == CellColouring::Level && baked && baked->bake) {
        const Bake& bake = *baked->bake;
        const std::optional<std::uint32_t> entered = fragmentAt(bake, m_state.selection.enteredFragment());
        for (const BakedFracture& fracture : bake.fractures) {
            std::uint32_t parent = fracture.parent;
            while (parent != kNone && bake.fragment(parent).parent != entered) parent = bake.fragment(parent).parent;
            if (parent == kNone) continue;
            int& depth = m_contents.depths[bake.fragmentId(parent)];
            depth = std::max(depth, static_cast<int>(fracture.level - bake.fragment(parent).level));
        }
    }
    m_contents.range = scale();
    m_backingStore.invalidateAll();
}

void CanvasContentsUpdater::refreshComparison() { m_contents.compared = m_state.isInFragment() ? nullptr : m_compared; }

DrawablePattern::Range CanvasContentsUpdater::scale() const {
    DrawablePattern::Range range;
    if (!m_contents.pattern) return range;
    if (m_contents.overlays.colouring != CellColouring::Level) {
        return m_contents.pattern->range(m_contents.overlays.colouring);
    }
    for (const auto& [id, depth] : m_contents.depths) range.most = std::max(range.most, static_cast<double>(depth));
    return range;
}

void CanvasContentsUpdater::computeMovedPart() {
    m_contents.moved = m_movedCells && m_state.displayedAsset() && isLocal()
                           ? m_movedCells->movedPart(*m_state.displayedAsset())
                           : nullptr;
}

/// Whether an edit only changes the picture near the changed cells: triangles, bonds and the unclipped diagram reach
/// beyond.
bool CanvasContentsUpdater::isLocal() const {
    const CanvasOverlays& overlays = m_contents.overlays;
    return !overlays.hasTriangles && !overlays.hasBonds && !overlays.hasWholeVoronoi;
}

/// The box that a moved part repaints. If cells are coloured by a quantity, all changed cells are in it.
Box2 CanvasContentsUpdater::movedBox(const MovedPart* part) const {
    if (!part) return {};
    return isQuantity(m_contents.overlays.colouring) ? part->changed : part->moved;
}

}  // namespace rubble
