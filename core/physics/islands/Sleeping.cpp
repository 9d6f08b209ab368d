#include "core/physics/islands/Sleeping.h"

#include "core/base/Assert.h"
#include "core/base/DisjointSets.h"
#include "core/physics/islands/Rest.h"
#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

bool hasManifold(const Contact& contact) { return contact.slot.isSet() || contact.stored != kNone; }

void setAwake(WorldState& state, std::uint32_t body) {
    state.bodies[body].isAwake = true;
    restartRest(state, body);
    state.woken.push_back(body);
}

void wakeIsland(WorldState& state, std::uint32_t island) {
    const SleepingIsland woken = std::exchange(state.sleepingIslands[island], {});
    state.freeSleepingIslands.push_back(island);
    for (std::uint32_t body : woken.bodies) {
        state.bodies[body].sleepingIsland = kNone;
        setAwake(state, body);
    }
    for (std::uint32_t contact : woken.contacts) restoreContact(state, contact);
    for (std::uint32_t body : woken.bodies) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
            if (!hasManifold(state.contacts[contact])) addSeparated(state, contact);
        });
    }
}

template <class Visit>
void visitLanes(const ContactColours& colours, const Visit& visit) {
    for (const ContactColours::List& list : colours.lists()) {
        for (const ContactBlock& block : list.blocks) {
            for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                if (block.first[lane] != 0) visit(block, lane);
            }
        }
    }
}

DisjointSets findIslands(const WorldState& state) {
    DisjointSets islands(state.bodies.size());
    visitLanes(state.colours, [&](const ContactBlock& block, std::size_t lane) {
        if (block.againstFixed[lane] == 0.0f) islands.merge(block.first[lane], block.second[lane]);
    });
    return islands;
}

bool isMoving(const BodyMotion& motion) {
    return motion.velocity != Vec3f(0.0f) || motion.angularVelocity != Vec3f(0.0f);
}

/// Marks the islands that must stay awake: those of which `rests` denies a body, those that a moving kinematic body
/// touches, and that of the grabbed body, which its spring accelerates.
template <class Rests>
std::vector<char> findActiveIslands(const WorldState& state, DisjointSets& islands, const Rests& rests) {
    std::vector<char> isActive(state.bodies.size(), 0);
    if (state.grabbed.index != 0) isActive[islands.rootOf(state.grabbed.index)] = 1;
    for (const std::uint32_t body : state.awake) {
        if (state.bodies[body].isDynamic()) {
            if (!rests(body)) isActive[islands.rootOf(body)] = 1;
        } else if (isMoving(state.motions[body])) {
            visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
                if (state.contacts[contact].slot.isSet()) isActive[islands.rootOf(other)] = 1;
            });
        }
    }
    return isActive;
}

std::uint32_t newSleepingIsland(WorldState& state) {
    if (state.freeSleepingIslands.empty()) {
        state.sleepingIslands.emplace_back();
        return static_cast<std::uint32_t>(state.sleepingIslands.size() - 1);
    }
    const std::uint32_t island = state.freeSleepingIslands.back();
    state.freeSleepingIslands.pop_back();
    return island;
}

void putToSleep(WorldState& state, std::uint32_t number, std::uint32_t island) {
    Body& body = state.bodies[number];
    body.isAwake = false;
    state.obstacleSizes[number] = kStands;
    body.sleepingIsland = island;
    state.motions[number].velocity = state.motions[number].angularVelocity = Vec3f(0.0f);
    body.angularMomentum = body.referenceAngularVelocity = Vec3f(0.0f);
    state.sleepingIslands[island].bodies.push_back(number);
    state.events.fellAsleep.push_back(state.idOf(number));
}

/// Stores the contacts of an island that just fell asleep, and removes its other contacts from the separated ones.
void storeContacts(WorldState& state, std::uint32_t island) {
    SleepingIsland& asleep = state.sleepingIslands[island];
    for (std::uint32_t body : asleep.bodies) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
            if (state.contacts[contact].slot.isSet()) {
                storeContact(state, contact);
                asleep.contacts.push_back(contact);
            } else if (!state.isAwake(state.contacts[contact])) {
                removeSeparated(state, contact);
            }
        });
    }
}

}  // namespace

void wakeBody(WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    if (body.kind == BodyKind::Static) return;
    if (body.sleepingIsland != kNone) wakeIsland(state, body.sleepingIsland);
    if (!body.isAwake) return setAwake(state, number);
    restartRest(state, number);
}

void wakeBodies(WorldState& state, std::uint32_t contact) {
    const std::array<std::uint32_t, 2> bodies = state.contacts[contact].bodies;
    for (std::uint32_t body : bodies) {
        if (state.bodies[body].isAwake)
            interruptRest(state, body);
        else
            wakeBody(state, body);
    }
}

void wakeNeighbours(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
        if (hasManifold(state.contacts[contact])) wakeBody(state, other);
    });
}

std::size_t updateAwakeBodies(WorldState& state) {
    if (state.woken.empty() && !state.hasRemovedAwake) return 0;
    const auto isAsleep = [&](std::uint32_t body) { return !state.bodies[body].isAwake; };
    std::erase_if(state.awake, isAsleep);
    std::erase_if(state.woken, isAsleep);
    std::sort(state.woken.begin(), state.woken.end());
    // Merged from the back, in place.
    std::size_t old = state.awake.size(), added = state.woken.size();
    state.awake.resize(old + added);
    for (std::size_t end = old + added; added > 0;) {
        const bool isOld = old > 0 && state.awake[old - 1] > state.woken[added - 1];
        state.awake[--end] = isOld ? state.awake[--old] : state.woken[--added];
    }
    // An index that was removed and reused may be in both lists.
    state.awake.erase(std::unique(state.awake.begin(), state.awake.end()), state.awake.end());
    state.woken.clear();
    state.hasRemovedAwake = false;
    return state.awake.size();
}

int sleepRestingIslands(WorldState& state) {
    const auto rests = [&](std::uint32_t body) { return isAtRest(state, body); };
    if (!state.sleeping || std::none_of(state.awake.begin(), state.awake.end(), rests)) return 0;
    DisjointSets islands = findIslands(state);
    const std::vector<char> isActive = findActiveIslands(state, islands, rests);
    std::vector<std::uint32_t> islandOfRoot(state.bodies.size(), kNone), newIslands, stillAwake;
    int count = 0;
    for (std::uint32_t body : state.awake) {
        const std::uint32_t root = islands.rootOf(body);
        count += root == body ? 1 : 0;
        if (!state.bodies[body].isDynamic() || isActive[root] != 0) {
            stillAwake.push_back(body);
            continue;
        }
        if (islandOfRoot[root] == kNone) newIslands.push_back(islandOfRoot[root] = newSleepingIsland(state));
        putToSleep(state, body, islandOfRoot[root]);
    }
    state.awake = std::move(stillAwake);
    for (std::uint32_t island : newIslands) storeContacts(state, island);
    return count;
}

void sleepAllIslands(WorldState& state) {
    updateAwakeBodies(state);
    for (const std::uint32_t body : state.awake) {
        if (state.bodies[body].isDynamic()) setAtRest(state, body);
    }
    sleepRestingIslands(state);
}

std::vector<std::uint32_t> islandsOf(const WorldState& state) {
    DisjointSets islands = findIslands(state);
    for (const SleepingIsland& asleep : state.sleepingIslands) {
        for (const std::uint32_t body : asleep.bodies) islands.merge(asleep.bodies.front(), body);
    }
    std::vector<std::uint32_t> roots(state.bodies.size(), 0);
    for (std::uint32_t body = 1; body < roots.size(); ++body) {
        if (state.bodies[body].shape != nullptr && state.bodies[body].isDynamic()) roots[body] = islands.rootOf(body);
    }
    return roots;
}

}  // namespace rubble
