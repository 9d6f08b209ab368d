#pragma once

#include "core/fracture/voronoi/LocalDiagram.h"
#include "editor/canvas/painting/DrawablePattern.h"

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

/// The seeds that were moved by hand between a baked pattern and a state of its asset; none if anything else of the
/// pattern changed, or if the effect of the moves is not local.
std::optional<std::vector<MovedSeed>> movedSeeds(const DrawablePattern& before, const Asset& now);

/// The part of a pattern that changed since it was baked, with its current cells.
struct MovedPart {
    std::shared_ptr<const DrawablePattern> pattern;  // with seeds of its own, of the current state
    std::vector<bool> isShown;                       // for each of its seeds: draw it from here
    std::vector<std::uint32_t> replaced;             // those seeds' indices in the baked pattern, ascending
    Box2 changed;                                    // bounds of all changed cells, before and after
    Box2 moved;  // bounds of the moved seeds' cells; pieces outside keep their names

    bool replaces(std::uint32_t seed) const;
};

/// Computes the cells around a few moved seeds while the whole pattern is baked in the background. This takes less than
/// a frame, whatever the number of seeds.
class MovedCells {
public:
    explicit MovedCells(std::shared_ptr<const DrawablePattern> baked) : m_baked(std::move(baked)) {}

    /// The changed part for a state of the asset; null if nothing changed, or too much to compute at once.
    std::shared_ptr<const MovedPart> movedPart(const Asset& now);

private:
    void findBoxes(MovedPart& part, std::span<const MovedSeed> moved) const;

    const std::shared_ptr<const DrawablePattern> m_baked;
    std::optional<LocalDiagram> m_diagram;  // this and m_outline are set on first use
    Polygon m_outline;                      // validated
};

}  // namespace rubble
