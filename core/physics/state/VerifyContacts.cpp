#include "core/physics/state/VerifyContacts.h"

#include <algorithm>
#include <cstddef>

namespace rubble {
namespace {

using Place = std::optional<std::string>;

bool isLive(const Contact& contact) { return contact.proxies[0] != kNone; }

/// Whether the axis is of faces and edges that the hulls have.
bool isAxisOf(const SeparatingAxis& axis, const Hull& first, const Hull& second) {
    switch (axis.kind) {
        case AxisKind::None: return true;
        case AxisKind::FirstFace: return axis.first < first.planes.size();
        case AxisKind::SecondFace: return axis.second < second.planes.size();
        case AxisKind::Edges: return axis.first < first.edges.size() && axis.second < second.edges.size();
    }
    return false;
}

/// The field of a contact that does not fit the proxies and bodies.
const char* faultyPair(const WorldState& state, std::uint32_t number) {
    const Contact& contact = state.contacts[number];
    if (contact.proxies[0] >= contact.proxies[1] || contact.proxies[1] >= state.proxies.size()) return "proxies";
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint32_t body = state.proxies[contact.proxies[side]].body;
        if (body == kNone || contact.bodies[side] != body) return "bodies";
    }
    const auto [first, second] = contact.bodies;
    if (first == second || (!state.bodies[first].isDynamic() && !state.bodies[second].isDynamic())) return "bodies";
    if (state.pairs.find(contact.proxies[0], contact.proxies[1]) != number) return "proxies";
    const Hull& firstHull = hullOf(state, state.proxies[contact.proxies[0]]);
    const Hull& secondHull = hullOf(state, state.proxies[contact.proxies[1]]);
    return isAxisOf(contact.axis, firstHull, secondHull) ? nullptr : "axis";
}

/// Whether a contact's lane is where its slot says.
bool hasLane(const WorldState& state, std::uint32_t number) {
    const Contact& contact = state.contacts[number];
    if (contact.slot.list >= ContactColours::kLists) return false;
    if (contact.slot.index >= state.colours.lists()[contact.slot.list].count) return false;
    const ContactBlock& home = state.colours.block(contact.slot);
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    return home.contact[lane] == number && home.first[lane] == contact.bodies[0] &&
           home.second[lane] == contact.bodies[1];
}

std::uint32_t storedWord(const StoredContact& stored, std::size_t offset) {
    return stored.block[offset / sizeof(IndexRow)];
}

/// Whether a contact's stored lane is its own.
bool hasStored(const WorldState& state, std::uint32_t number) {
    const Contact& contact = state.contacts[number];
    if (contact.stored >= state.stored.size()) return false;
    const StoredContact& stored = state.stored[contact.stored];
    return storedWord(stored, offsetof(ContactBlock, contact)) == number &&
           storedWord(stored, offsetof(ContactBlock, first)) == contact.bodies[0] &&
           storedWord(stored, offsetof(ContactBlock, second)) == contact.bodies[1] &&
           storedWord(stored, offsetof(ContactBlock, pointCount)) <= 4;
}

bool hasSeparated(const WorldState& state, std::uint32_t number) {
    const Contact& contact = state.contacts[number];
    return contact.separatedIndex < state.separated.size() &&
           state.separated[contact.separatedIndex].contact == number &&
           state.separated[contact.separatedIndex].bodies == contact.bodies;
}

bool hasAwakeDynamic(const WorldState& state, const Contact& contact) {
    return std::ranges::any_of(contact.bodies, [&](std::uint32_t number) {
        return state.bodies[number].isDynamic() && state.bodies[number].isAwake;
    });
}

/// The field by which a contact is not where it must be: an awake one in a lane or among the separated ones, a sleeping
/// one with its lane stored or, without a manifold, in none of them. Kinematic bodies never sleep: one of theirs with a
/// sleeping body has its lane stored or is among the separated ones.
const char* faultyHome(const WorldState& state, std::uint32_t number) {
    const Contact& contact = state.contacts[number];
    const bool isSolved = hasAwakeDynamic(state, contact), isStored = contact.stored != kNone;
    const bool isSeparated = contact.separatedIndex != kNone;
    if (contact.slot.isSet() && (!isSolved || isStored || isSeparated || !hasLane(state, number))) return "slot";
    if (isStored && (isSolved || isSeparated || !hasStored(state, number))) return "stored";
    if (isSeparated && !hasSeparated(state, number)) return "separatedIndex";
    if (state.isAwake(contact) && !contact.slot.isSet() && !isSeparated && !isStored) return "slot";
    return nullptr;
}

/// Each body's list has all of its contacts, linked both ways.
Place verifyLinks(const WorldState& state, std::size_t liveCount) {
    std::vector<bool> isLinked(2 * state.contacts.size(), false);
    std::size_t count = 0;
    for (std::uint32_t number = 1; number < state.bodies.size(); ++number) {
        std::uint32_t previous = kNone;
        for (std::uint32_t key = state.bodies[number].firstContact; key != kNone;) {
            if (key >= isLinked.size() || isLinked[key]) return placeIn("bodies", number, "firstContact");
            const Contact& contact = state.contacts[key / 2];
            if (!isLive(contact) || contact.bodies[key % 2] != number || contact.previous[key % 2] != previous) {
                return placeIn("contacts", key / 2, "previous");
            }
            isLinked[key] = true;
            previous = key;
            key = contact.next[key % 2];
            ++count;
        }
    }
    return count == 2 * liveCount ? Place() : Place("contacts");
}

/// Each sleeping body and each stored contact is in one island, of which others are free.
Place verifyIslands(const WorldState& state, std::size_t storedCount) {
    std::vector<bool> isFree(state.sleepingIslands.size(), false), isListed(state.contacts.size(), false);
    std::vector<bool> isIn(state.bodies.size(), false);
    std::size_t bodies = 0, contacts = 0, sleeping = 0;
    for (std::uint32_t k = 0; k < isFree.size(); ++k) {
        const SleepingIsland& island = state.sleepingIslands[k];
        isFree[k] = island.bodies.empty();
        if (isFree[k] && !island.contacts.empty()) return placeIn("sleepingIslands", k, "contacts");
        for (const std::uint32_t body : island.bodies) {
            const bool isSleeping = body < isIn.size() && !isIn[body] && state.bodies[body].sleepingIsland == k;
            if (!isSleeping) return placeIn("sleepingIslands", k, "bodies");
            isIn[body] = true;
            ++bodies;
        }
        for (const std::uint32_t contact : island.contacts) {
            const bool isStored = contact < isListed.size() && !isListed[contact] && isLive(state.contacts[contact]) &&
                                  state.contacts[contact].stored != kNone;
            if (!isStored) return placeIn("sleepingIslands", k, "contacts");
            const auto [first, second] = state.contacts[contact].bodies;
            if (state.bodies[first].sleepingIsland != k && state.bodies[second].sleepingIsland != k) {
                return placeIn("sleepingIslands", k, "contacts");
            }
            isListed[contact] = true;
            ++contacts;
        }
    }
    for (const Body& body : state.bodies) sleeping += body.sleepingIsland != kNone ? 1 : 0;
    if (bodies != sleeping || contacts != storedCount) return "sleepingIslands";
    return verifyFree("freeSleepingIslands", state.freeSleepingIslands, isFree);
}

Place verifyLanes(const WorldState& state) {
    std::vector<bool> isDynamic(state.bodies.size(), false), isFree(state.stored.size(), true);
    for (std::size_t k = 0; k < isDynamic.size(); ++k) isDynamic[k] = state.bodies[k].isDynamic();
    std::size_t lanes = 0, separated = 0, stored = 0, live = 0;
    if (const Place fault = state.colours.verifyColours(isDynamic)) return "colours." + *fault;
    for (std::uint32_t k = 0; k < state.contacts.size(); ++k) {
        const Contact& contact = state.contacts[k];
        if (!isLive(contact)) {
            if (contact.slot.isSet() || contact.stored != kNone || contact.separatedIndex != kNone) {
                return placeIn("contacts", k);
            }
            continue;
        }
        if (const char* field = faultyHome(state, k)) return placeIn("contacts", k, field);
        ++live;
        lanes += contact.slot.isSet() ? 1 : 0;
        separated += contact.separatedIndex != kNone ? 1 : 0;
        if (contact.stored == kNone) continue;
        if (!isFree[contact.stored]) return placeIn("contacts", k, "stored");
        isFree[contact.stored] = false;
        ++stored;
    }
    if (lanes != state.colours.contactCount()) return "colours";
    if (separated != state.separated.size()) return "separated";
    if (live != state.pairs.size()) return "pairs";
    if (Place fault = verifyFree("freeStored", state.freeStored, isFree)) return fault;
    if (Place fault = verifyLinks(state, live)) return fault;
    return verifyIslands(state, stored);
}

}  // namespace

std::string placeIn(const char* table, std::size_t element, const char* field) {
    return std::string(table) + '[' + std::to_string(element) + ']' + (field ? '.' + std::string(field) : "");
}

Place verifyFree(const char* list, const std::vector<std::uint32_t>& free, const std::vector<bool>& isFree) {
    std::vector<bool> isListed(isFree.size(), false);
    for (std::size_t k = 0; k < free.size(); ++k) {
        if (free[k] >= isFree.size() || !isFree[free[k]] || isListed[free[k]]) return placeIn(list, k);
        isListed[free[k]] = true;
    }
    return isListed == isFree ? Place() : Place(list);
}

Place verifyContacts(const WorldState& state) {
    if (const Place fault = state.pairs.verifyTable()) return "pairs." + *fault;
    std::vector<bool> isFree(state.contacts.size(), false);
    for (std::uint32_t k = 0; k < state.contacts.size(); ++k) {
        isFree[k] = !isLive(state.contacts[k]);
        if (isFree[k]) {
            if (state.contacts[k].proxies[1] != kNone) return placeIn("contacts", k, "proxies");
            continue;
        }
        if (const char* field = faultyPair(state, k)) return placeIn("contacts", k, field);
    }
    if (Place fault = verifyFree("freeContacts", state.freeContacts, isFree)) return fault;
    return verifyLanes(state);
}

}  // namespace rubble
