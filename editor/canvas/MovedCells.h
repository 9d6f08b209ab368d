#pragma once

#include "core/fracture/LocalDiagram.h"
#include "editor/canvas/ShownPattern.h"

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

/// The seeds that stand elsewhere in another state of the asset, where hands moved them and nothing else of the pattern
/// changed; none where more did, or where it is not known how far that reaches.
std::optional<std::vector<MovedSeed>> movedSeeds(const ShownPattern& before, const Asset& now);

/// The part of a pattern that changed since it was baked, with the cells that it has now.
struct MovedPart {
    std::shared_ptr<const ShownPattern> pattern;  // its own seeds; of its asset's state
    std::vector<bool> isShown;                    // of each of its seeds: it is drawn as it is here
    std::vector<std::uint32_t> replaced;          // those seeds as the baked pattern numbers them, ascending
    Box2 changed;                                 // around all cells that changed, before and after
    Box2 moved;  // what lies beyond belongs to the same pieces as before, by the same names

    bool replaces(std::uint32_t seed) const;
};

/// Makes the cells that follow the hand while a pattern is baked anew: those around a few moved seeds take less time than
/// one picture, however many others there are.
class MovedCells {
public:
    explicit MovedCells(std::shared_ptr<const ShownPattern> baked) : m_baked(std::move(baked)) {}

    /// What has changed in a state of the asset. Null where nothing has, or too much to be done at once.
    std::shared_ptr<const MovedPart> partOf(const Asset& now);

private:
    void findBoxes(MovedPart& part, std::span<const MovedSeed> moved) const;

    const std::shared_ptr<const ShownPattern> m_baked;
    std::optional<LocalDiagram> m_diagram;  // this and the next: when first needed
    Polygon m_outline;                      // validated
};

}  // namespace rubble
