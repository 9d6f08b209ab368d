#pragma once

#include "core/physics/BoxSweep.h"
#include "core/physics/NearBoxes.h"
#include "core/physics/Regions.h"

namespace rubble {

/// Memory that the search for pairs uses again from step to step.
struct PairScratch {
    std::vector<std::uint32_t> moved;                 // bodies with new fat boxes
    std::vector<char> isMoved;                        // by body
    std::vector<std::vector<std::uint32_t>> leaving;  // by region: bodies that may leave their boxes
    std::vector<std::vector<std::uint32_t>> found;    // by chunk: proxies, two a pair
    std::vector<NearBoxes> near;                      // by chunk
    BoxSweep sweep;
    std::vector<BoxSweep::Scratch> swept;  // by chunk
    std::vector<std::uint32_t> gone;       // contacts
};

/// The box of a hull, or of a proxy's where it is now, without any margin.
Box tightBox(const Hull& hull, const BodyPlace& place);
Box tightBox(const WorldState& state, const Proxy& proxy);

/// By how much the box of a body of such a reach is widened, so that what jitters stays in it, m.
float boxMargin(float reach);

/// Puts a body's hulls in the tree, or takes them out.
void addProxies(WorldState& state, std::uint32_t body);
void removeProxies(WorldState& state, std::uint32_t body);

/// Foresees how far bodies can move in dt seconds, widens the boxes of those that may leave theirs, makes contacts for boxes that
/// came to overlap, and removes those of boxes that no longer do. `all` looks at every awake body, else at those that were put in
/// or moved by hand.
void findPairs(WorldState& state, WorkerTeam& team, const Regions& regions, PairScratch& scratch, float dt, bool all);

}  // namespace rubble
