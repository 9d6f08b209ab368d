#pragma once

#include "editor/background/ComparedAsset.h"
#include "editor/canvas/painting/BondMarks.h"
#include "editor/canvas/painting/MovedCells.h"
#include "editor/document/FragmentSelection.h"
#include "editor/widgets/numbers/Units.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rubble {

/// The contents of a canvas; repainted only where they change.
struct CanvasContents {
    std::shared_ptr<const DrawablePattern> pattern;  // as baked; may be null
    std::shared_ptr<const MovedPart> moved;          // changed since; null if nothing did
    std::vector<std::array<Vec2, 2>> surroundings;   // edges around the entered fragment, m
    std::vector<std::array<Vec2, 2>> deeperEdges;    // of deeper levels, m; empty if they are not shown
    std::shared_ptr<const BondMarks> bondMarks;      // null: the asset breaks whole, or has no fragments yet
    std::shared_ptr<const Partition> shrunk;         // the pieces less the gap; null: there is none, or not known yet
    CanvasOverlays overlays;
    Units units;                   // of the legend and of labels
    DrawablePattern::Range range;  // of overlays.colouring
    FragmentSelection hidden;
    double density = 0.0;               // kg/m³
    double threshold = 0.0;             // N·s, effective
    std::map<std::string, int> depths;  // for Level: the number of further levels of each fractured fragment, by id
    std::shared_ptr<const ComparedAsset> compared;  // changes since an earlier state; null if not shown

    /// The effective colouring: none while changes are shown, so that these stand out.
    CellColouring colouring() const { return compared ? CellColouring::None : overlays.colouring; }

    /// Whether cells are coloured by a scale, which has dark colours.
    bool isOnScale() const { return overlays.hasCells && !compared && range.most > range.least; }

    QColor colour(const DrawablePattern& from, std::uint32_t piece) const;
    /// The area of a baked piece less the gap, m^2.
    double area(std::uint32_t piece) const;
    /// The displayed state of the asset; null if there is no pattern.
    const Asset* asset() const;
    /// The pattern that a seed is drawn from, and its index there; kNone if it does not exist.
    std::pair<const DrawablePattern*, std::uint32_t> find(SeedId seed) const;
};

}  // namespace rubble
