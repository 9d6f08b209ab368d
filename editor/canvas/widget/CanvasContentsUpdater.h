#pragma once

#include "editor/canvas/painting/CanvasBackingStore.h"
#include "editor/canvas/tools/CanvasTool.h"

namespace rubble {

/// Keeps the contents of a canvas up to date with document, selection and bakes, and invalidates only the parts of the
/// picture that change. Each refresh…() function updates the part that it is named after.
class CanvasContentsUpdater {
public:
    explicit CanvasContentsUpdater(const CanvasState& state) : m_state(state) {}

    const CanvasContents& contents() const { return m_contents; }
    /// The painted contents, up to date; `ratio` is the device pixel ratio.
    const QImage& image(double ratio, const CanvasColours& colours) {
        return m_backingStore.at(m_state.view, ratio, m_contents, colours);
    }
    void invalidateAll() { m_backingStore.invalidateAll(); }

    void setOverlays(const CanvasOverlays& overlays);
    void setUnits(const Units& units) { m_contents.units = units; }
    /// The changes since an earlier state of the whole asset; null shows none.
    void setCompared(std::shared_ptr<const ComparedAsset> compared);

    void refreshAll();
    void refreshHidden();
    void refreshMaterial();
    void refreshPattern();
    /// The cells that moved since the pattern was baked.
    void refreshMovedPart();
    /// Updates what depends on the fragments: the surroundings of an entered one, and the number of levels below each.
    void refreshFragments();
    /// The marks of an asset that breaks as bonded, with the stroke that is being painted.
    void refreshBonds();

private:
    void refreshSurroundings();
    void refreshShapes();
    void refreshDepths();
    void refreshComparison();
    DrawablePattern::Range scale() const;
    void refreshBondMarks();
    void refreshBondMarker();
    void computeMovedPart();
    bool isLocal() const;
    Box2 movedBox(const MovedPart* part) const;

    const CanvasState& m_state;
    CanvasContents m_contents;
    CanvasBackingStore m_backingStore;
    std::shared_ptr<const ComparedAsset> m_compared;  // of the whole asset; null: none
    /// What the bond marks depend on, besides the pattern and the bake.
    struct BondKey {
        Bonding bonding;  // with the stroke
        double levelStrength = 1.0;
        bool showsStrengths = false;
        bool operator==(const BondKey&) const = default;
    };
    std::optional<BondKey> m_bondKey;              // of m_contents.bondMarks
    std::shared_ptr<const BakedAsset> m_bondBake;  // of m_bondMarker, as m_bondPattern
    std::shared_ptr<const DrawablePattern> m_bondPattern;
    std::unique_ptr<BondMarker> m_bondMarker;  // null: there are no fragments of the pattern
    std::unique_ptr<MovedCells> m_movedCells;  // of the pattern in m_contents
};

}  // namespace rubble
