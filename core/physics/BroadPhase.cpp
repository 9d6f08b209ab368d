#include "core/physics/BroadPhase.h"

#include "core/physics/Contacts.h"
#include "core/physics/Sleeping.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr std::size_t kLeastBodies = 64;  // a worker's share of a search

/// The most that gravity can add to a way, and a little for what contacts do.
float foreseenWay(const WorldState& state, std::uint32_t body, float dt) {
    const BodyMotion& motion = state.motions[body];
    const float speed = length(motion.velocity) + length(motion.spin) * state.places[body].reach;
    return (speed + length(state.gravity) * dt) * dt;
}

void rebox(WorldState& state, std::uint32_t number, float dt) {
    Body& body = state.bodies[number];
    const BodyPlace& place = state.places[number];
    const float margin = boxMargin(place.reach);
    const Vec3f way = state.motions[number].velocity * dt;
    // What turning adds to the way is in the margin, or it is added to it.
    const float extra = std::max(0.0f, state.ahead[number] - place.travel - length(way));
    for (std::uint32_t proxy = body.firstProxy; proxy != kNone; proxy = state.proxies[proxy].next) {
        const Box tight = tightBox(state, state.proxies[proxy]);
        state.tree.move(state.proxies[proxy].leaf, widened(swept(tight, way), margin + extra));
    }
    body.boxedUntil = place.travel + margin + extra;
    if (length(way) > margin) body.boxedUntil = place.travel;  // on its way through the box: again next time
}

void markMoved(PairScratch& scratch, std::uint32_t body) {
    if (scratch.isMoved[body] != 0) return;
    scratch.isMoved[body] = 1;
    scratch.moved.push_back(body);
}

/// Foresees how far awake bodies can move, and lists those that may leave their boxes.
void listLeaving(WorldState& state, WorkerTeam& team, const Regions& regions, PairScratch& scratch, float dt) {
    scratch.leaving.resize(regions.count());
    regions.forEach(team, [&](std::size_t region) {
        std::vector<std::uint32_t>& leaving = scratch.leaving[region];
        leaving.clear();
        for (std::uint32_t body : regions.bodies(region)) {
            state.ahead[body] = state.places[body].travel + foreseenWay(state, body, dt);
            if (state.ahead[body] > state.bodies[body].boxedUntil) leaving.push_back(body);
        }
    });
}

void widenBoxes(WorldState& state, WorkerTeam& team, const Regions& regions, PairScratch& scratch, float dt, bool all) {
    scratch.moved.clear();
    scratch.isMoved.assign(state.bodies.size(), 0);
    for (std::uint32_t body : state.rebox) {
        if (state.bodies[body].shape == nullptr) continue;
        state.ahead[body] = state.places[body].travel + foreseenWay(state, body, dt);
        rebox(state, body, dt);
        markMoved(scratch, body);
    }
    state.rebox.clear();
    if (!all) return;
    listLeaving(state, team, regions, scratch, dt);
    for (std::uint32_t body : mergedAscending(scratch.leaving)) {
        if (scratch.isMoved[body] != 0) continue;
        rebox(state, body, dt);
        markMoved(scratch, body);
    }
}

/// Lists the pairs of a box with others that overlap it, those left out that can never touch. `isWanted` says which of the others'
/// bodies count.
template <class IsWanted>
void listPairs(const WorldState& state, std::uint32_t proxy, std::span<const std::uint32_t> others,
               const IsWanted& isWanted, std::vector<std::uint32_t>& found) {
    const std::uint32_t body = state.proxies[proxy].body;
    const bool isDynamic = state.bodies[body].isDynamic();
    const std::size_t before = found.size();
    std::size_t end = before;
    found.resize(before + 2 * others.size());
    for (const std::uint32_t otherProxy : others) {
        const std::uint32_t other = state.proxies[otherProxy].body;
        const bool canTouch = (other != body) & (isDynamic | state.bodies[other].isDynamic());
        // Written in any case, and kept by counting: what is near cannot be foreseen.
        found[end] = proxy;
        found[end + 1] = otherProxy;
        end += canTouch & isWanted(other) ? 2 : 0;
    }
    found.resize(end);
}

/// The pairs of a moved body's box; of two bodies that both moved, the lower looks.
void pairWithNear(const WorldState& state, const PairScratch& scratch, std::uint32_t proxy, NearBoxes& near,
                  std::vector<std::uint32_t>& found) {
    const std::uint32_t body = state.proxies[proxy].body;
    const auto looks = [&](std::uint32_t other) { return (scratch.isMoved[other] == 0) | (body < other); };
    listPairs(state, proxy, near.overlapping(state.tree.box(state.proxies[proxy].leaf)), looks, found);
}

/// The pairs of some moved bodies. Boxes in a row that lie close together, as those of the pieces of one body, search the tree
/// together: as long as a box around them all is not much larger than they are themselves.
void searchAround(const WorldState& state, const PairScratch& scratch, IndexRange range, NearBoxes& near,
                  std::vector<std::uint32_t>& found) {
    constexpr std::size_t kMostTogether = 16;
    constexpr float kMuchLarger = 1.5f;
    std::array<std::uint32_t, kMostTogether> together{};
    std::size_t count = 0;
    Box around;
    const auto search = [&] {
        if (count > 0) near.gather(state.tree, around);
        for (std::size_t i = 0; i < count; ++i) pairWithNear(state, scratch, together[i], near, found);
        count = 0;
    };
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const Body& body = state.bodies[scratch.moved[i]];
        for (std::uint32_t proxy = body.firstProxy; proxy != kNone; proxy = state.proxies[proxy].next) {
            const Box& box = state.tree.box(state.proxies[proxy].leaf);
            const Box all = count == 0 ? box : joined(around, box);
            if (count == kMostTogether || (count > 0 && all.area() > kMuchLarger * (around.area() + box.area()))) {
                search();
                around = box;
            } else {
                around = all;
            }
            together[count++] = proxy;
        }
    }
    search();
}

/// Where at least half of all boxes moved, the tree would be built anew to be asked once.
bool isSweepQuicker(const WorldState& state, const PairScratch& scratch) {
    constexpr std::size_t kFew = 64, kMany = 8192;  // a sweep's time grows as the 5/3rd power of the number of boxes
    return state.tree.size() >= kFew && state.tree.size() <= kMany && 2 * scratch.moved.size() >= state.tree.size();
}

/// All pairs of which one moved, by a sweep over all boxes.
void sweepForPairs(const WorldState& state, WorkerTeam& team, PairScratch& scratch, std::size_t chunks) {
    scratch.sweep.clear();
    for (std::uint32_t proxy = 0; proxy < state.proxies.size(); ++proxy) {
        const std::uint32_t leaf = state.proxies[proxy].leaf;
        if (leaf != BoxTree::kNone) scratch.sweep.add(proxy, state.tree.box(leaf));
    }
    scratch.sweep.sort();
    scratch.swept.resize(scratch.found.size());
    team.share(scratch.sweep.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        for (std::size_t place = range.begin; place < range.end; ++place) {
            const std::uint32_t proxy = scratch.sweep.number(place);
            const bool hasMoved = scratch.isMoved[state.proxies[proxy].body] != 0;
            const auto oneMoved = [&](std::uint32_t other) { return hasMoved | (scratch.isMoved[other] != 0); };
            listPairs(state, proxy, scratch.sweep.overlappingLater(place, scratch.swept[chunk]), oneMoved,
                      scratch.found[chunk]);
        }
    });
}

/// The pairs of all moved bodies, by the tree.
void searchForPairs(const WorldState& state, WorkerTeam& team, PairScratch& scratch, std::size_t chunks) {
    scratch.near.resize(scratch.found.size());
    team.share(scratch.moved.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        searchAround(state, scratch, range, scratch.near[chunk], scratch.found[chunk]);
    });
}

bool boxesOverlap(const WorldState& state, const Contact& contact) {
    return state.tree.box(state.proxies[contact.proxies[0]].leaf)
        .overlaps(state.tree.box(state.proxies[contact.proxies[1]].leaf));
}

void removeParted(WorldState& state, PairScratch& scratch) {
    scratch.gone.clear();
    for (std::uint32_t body : scratch.moved) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
            if (scratch.isMoved[other] != 0 && other < body) return;
            if (!boxesOverlap(state, state.contacts[contact])) scratch.gone.push_back(contact);
        });
    }
    for (std::uint32_t contact : scratch.gone) {
        for (std::uint32_t body : state.contacts[contact].bodies) {
            if (state.contacts[contact].stored != kNone) wakeBody(state, body);
        }
        removeContact(state, contact);
    }
}

}  // namespace

float boxMargin(float reach) {
    constexpr float kMost = 0.05f;      // m
    constexpr float kOfReach = 0.125f;  // small bodies have narrower ones
    return std::min(kMost, kOfReach * reach);
}

Box tightBox(const Hull& hull, const BodyPlace& place) {
    const Mat3f turn = place.turn.matrix();
    const Vec3f middle = place.centre + turn * hull.middle;
    const Vec3f half =
        magnitudes(turn.x) * hull.extents.x + magnitudes(turn.y) * hull.extents.y + magnitudes(turn.z) * hull.extents.z;
    return {middle - half, middle + half};
}

Box tightBox(const WorldState& state, const Proxy& proxy) {
    return tightBox(hullOf(state, proxy), state.places[proxy.body]);
}

void addProxies(WorldState& state, std::uint32_t body) {
    const auto hulls = static_cast<std::uint32_t>(state.bodies[body].shape->hulls.size());
    for (std::uint32_t hull = hulls; hull-- > 0;) {
        if (state.freeProxies.empty()) {
            state.freeProxies.push_back(static_cast<std::uint32_t>(state.proxies.size()));
            state.proxies.emplace_back();
        }
        const std::uint32_t number = state.freeProxies.back();
        state.freeProxies.pop_back();
        Proxy& proxy = state.proxies[number];
        proxy = {body, hull, BoxTree::kNone, state.bodies[body].firstProxy};
        proxy.leaf = state.tree.insert(tightBox(state, proxy), number);
        state.bodies[body].firstProxy = number;
    }
    state.rebox.push_back(body);
}

void removeProxies(WorldState& state, std::uint32_t body) {
    for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone;) {
        const std::uint32_t next = state.proxies[proxy].next;
        state.tree.remove(state.proxies[proxy].leaf);
        state.proxies[proxy] = {};
        state.freeProxies.push_back(proxy);
        proxy = next;
    }
    state.bodies[body].firstProxy = kNone;
}

void findPairs(WorldState& state, WorkerTeam& team, const Regions& regions, PairScratch& scratch, float dt, bool all) {
    widenBoxes(state, team, regions, scratch, dt, all);
    if (scratch.moved.empty()) return;
    removeParted(state, scratch);
    const std::size_t chunks = regions.count() == 1 ? 1 : team.chunksOf(scratch.moved.size(), kLeastBodies);
    scratch.found.resize(std::max(chunks, scratch.found.size()));
    for (std::vector<std::uint32_t>& found : scratch.found) found.clear();
    if (isSweepQuicker(state, scratch)) {
        sweepForPairs(state, team, scratch, chunks);
    } else {
        state.tree.tidy();
        searchForPairs(state, team, scratch, chunks);
    }
    for (const std::vector<std::uint32_t>& found : scratch.found) {
        for (std::size_t i = 0; i < found.size(); i += 2) addContact(state, found[i], found[i + 1]);
    }
}

}  // namespace rubble
