#pragma once

#include "core/physics/broadphase/NearbyBoxes.h"
#include "core/physics/broadphase/SortAndSweep.h"
#include "core/physics/state/Regions.h"

namespace rubble {

/// Memory of findPairs(), reused from step to step.
struct PairScratch {
    std::vector<std::uint32_t> moved;                 // bodies with new fat boxes
    std::vector<std::uint32_t> flying;                // bodies, of the whole step
    std::size_t firstFlying = 0;                      // of those that were found last
    float smallestFlying = kStands;                   // m: their least size
    std::vector<Box> wholeBoxes;                      // by proxy, of what flies: around all of its movement in the step
    std::vector<char> isMoved;                        // by body
    std::vector<std::vector<std::uint32_t>> leaving;  // by region: bodies that may leave their boxes
    std::vector<std::vector<std::uint32_t>> found;    // by chunk: two proxies per pair
    std::vector<std::vector<std::uint32_t>>
        ahead;                      // by chunk: two proxies per pair, of what flies with what is in its way
    std::vector<NearbyBoxes> near;  // by chunk
    SortAndSweep sweep;
    SortAndSweep obstacles;                           // what something that flies is swept against
    std::vector<SortAndSweep::Scratch> sweepScratch;  // by chunk
    std::vector<std::uint32_t> separatedContacts;     // those whose boxes no longer overlap
};

/// The bounding box of a hull, or of a proxy's hull, without margin.
Box tightBox(const PlacedHull& hull, const BodyPose& pose);
Box tightBox(const WorldState& state, const Proxy& proxy);

/// The margin of the fat box of a body with this bounding radius, m.
float boxMargin(float boundingRadius);

/// Adds a body's hulls to the tree, or removes them.
void addProxies(WorldState& state, std::uint32_t body);
void removeProxies(WorldState& state, std::uint32_t body);
/// Adds a proxy for a hull of a body, as the first in its list.
void linkProxy(WorldState& state, std::uint32_t body, std::uint32_t hull);
/// Removes a proxy that is in the list of no body and has no contacts.
void removeProxy(WorldState& state, std::uint32_t proxy);

/// The bodies that findPairs() considers.
enum class PairBodies {
    Changed,  // those added or moved by the caller
    All,      // these and all awake bodies
};

/// Predicts how far bodies can move in dt seconds, updates the fat boxes of those that may leave theirs, adds contacts
/// for boxes that begin to overlap, and removes those of boxes that no longer do.
void findPairs(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch, float dt,
               PairBodies bodies);

/// Adds the contacts with what is not dynamic that findPairs() could not foresee: of bodies that the step being solved
/// moves farther than predicted, since others pushed them.
void findUnforeseenPairs(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch);

}  // namespace rubble
