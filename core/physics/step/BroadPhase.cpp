#include "core/physics/step/BroadPhase.h"

#include "core/physics/islands/Sleeping.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kMinBodiesPerChunk = 64;

constexpr float kFlyingFraction = 0.5f;    // of its width: what moves farther in a step may fly
constexpr float kStandingFraction = 0.1f;  // of its bounding radius: but what moves no farther stands

/// Predicts the movement of a body in the coming step of dt seconds.
void predict(WorldState& state, std::uint32_t number, float dt) {
    const Body& body = state.bodies[number];
    const BodyMotion& motion = state.motions[number];
    const BodyPose& pose = state.poses[number];
    const float distance = length(motion.velocity) * dt;
    const float arc = std::min(length(motion.angularVelocity) * dt, 2.0f) * pose.boundingRadius;
    state.predictedTravel[number] = pose.travel + distance + arc + length(state.gravity) * dt * dt;
    state.predictions[number] = {pose.centre + motion.velocity * dt, pose.arc + arc};
    const bool isFlying =
        body.isDynamic() && !body.isBullet &&
        distance > std::max(kFlyingFraction * body.shape->minWidth, kStandingFraction * pose.boundingRadius);
    state.obstacleSizes[number] = isFlying ? pose.boundingRadius : kStands;
}

/// The box of a hull that rotates by up to `arc`, m: no point leaves the sphere around the body.
Box rotating(const Box& tight, const BodyPose& pose, float arc) {
    const Vec3f radius(pose.boundingRadius);
    return {componentMax(tight.low - Vec3f(arc), componentMin(tight.low, pose.centre - radius)),
            componentMin(tight.high + Vec3f(arc), componentMax(tight.high, pose.centre + radius))};
}

/// Updates the fat boxes of a moved body. What flies is swept by a fraction of its size, but by all of its movement for
/// what it is swept against.
void updateFatBoxes(WorldState& state, PairScratch& scratch, std::uint32_t number, float dt) {
    Body& body = state.bodies[number];
    const BodyPose& pose = state.poses[number];
    const float margin = boxMargin(pose.boundingRadius), fall = length(state.gravity) * dt * dt;
    const Vec3f displacement = state.motions[number].velocity * dt;
    const float distance = length(displacement), arc = state.predictions[number].arc - pose.arc;
    const bool isFlying = state.isFlying(number);
    const float most = kFlyingFraction * body.shape->minWidth;
    for (std::uint32_t proxy = body.firstProxy; proxy != kNone; proxy = state.proxies[proxy].next) {
        const Box tight = tightBox(state, state.proxies[proxy]);
        const Box whole = widened(swept(rotating(tight, pose, arc), displacement), margin + fall);
        if (isFlying) {
            const Vec3f part = displacement * std::min(1.0f, most / distance);
            const Box limited = widened(swept(rotating(tight, pose, std::min(arc, most)), part), margin + fall);
            state.tree.move(state.proxies[proxy].leaf, limited);
            scratch.wholeBoxes[proxy] = whole;
        } else {
            state.tree.move(state.proxies[proxy].leaf, whole);
        }
    }
    // What moves out of the margin is updated again in the next step.
    body.boxValidUntil = pose.travel + (isFlying || distance > margin ? 0.0f : margin + arc + fall);
}

void markMoved(WorldState& state, PairScratch& scratch, std::uint32_t body, float dt) {
    if (scratch.isMoved[body] != 0) return;
    updateFatBoxes(state, scratch, body, dt);
    scratch.isMoved[body] = 1;
    scratch.moved.push_back(body);
    if (state.isFlying(body)) scratch.flying.push_back(body);
}

/// Predicts how far awake bodies can move, and lists those that may leave their boxes.
void findLeaving(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch, float dt) {
    clearLists(scratch.leaving, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        std::vector<std::uint32_t>& leaving = scratch.leaving[region];
        for (std::uint32_t body : regions.bodies(region)) {
            predict(state, body, dt);
            const bool isLeaving = state.predictedTravel[body] > state.bodies[body].boxValidUntil;
            if (isLeaving || state.isFlying(body)) leaving.push_back(body);
        }
    });
}

void updateBoxes(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch, float dt,
                 PairBodies bodies) {
    scratch.moved.clear();
    if (bodies == PairBodies::All) scratch.flying.clear();
    scratch.firstFlying = scratch.flying.size();
    scratch.isMoved.assign(state.bodies.size(), 0);
    scratch.wholeBoxes.resize(state.proxies.size());
    for (std::uint32_t body : state.rebox) {
        if (state.bodies[body].shape == nullptr || scratch.isMoved[body] != 0) continue;
        predict(state, body, dt);
        markMoved(state, scratch, body, dt);
    }
    state.rebox.clear();
    if (bodies == PairBodies::Changed) return;
    findLeaving(state, threads, regions, scratch, dt);
    for (std::uint32_t body : mergeSorted(scratch.leaving)) markMoved(state, scratch, body, dt);
}

/// The box of a proxy's whole movement in the step.
const Box& wholeBox(const WorldState& state, const PairScratch& scratch, std::uint32_t proxy) {
    const auto& [body, hull, leaf, next] = state.proxies[proxy];
    return state.isFlying(body) ? scratch.wholeBoxes[proxy] : state.tree.box(leaf);
}

/// Lists the pairs of a proxy with others, except those that can never touch. `isWanted` accepts the other body.
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
        const bool canTouch = (other != body) & (isDynamic | (state.motions[other].inverseMass > 0.0f));
        // Branchless: written unconditionally, kept by counting, since the outcome is unpredictable.
        found[end] = proxy;
        found[end + 1] = otherProxy;
        end += canTouch & isWanted(other) ? 2 : 0;
    }
    found.resize(end);
}

/// The pairs of a moved body's proxy; a pair of two moved bodies is listed by the lower.
void pairWithNear(const WorldState& state, const PairScratch& scratch, std::uint32_t proxy, NearbyBoxes& near,
                  std::vector<std::uint32_t>& found) {
    const std::uint32_t body = state.proxies[proxy].body;
    const auto isWanted = [&](std::uint32_t other) { return (scratch.isMoved[other] == 0) | (body < other); };
    listPairs(state, proxy, near.overlapping(state.tree.box(state.proxies[proxy].leaf)), isWanted, found);
}

/// The pairs of a range of moved bodies. Consecutive boxes that lie close together, such as those of sibling fragments,
/// query the tree together, as long as their common bounding box is not much larger than themselves.
void searchAround(const WorldState& state, const PairScratch& scratch, IndexRange range, NearbyBoxes& near,
                  std::vector<std::uint32_t>& found) {
    constexpr std::size_t kMaxGroup = 16;
    constexpr float kMaxGrowth = 1.5f;
    std::array<std::uint32_t, kMaxGroup> group{};
    std::size_t count = 0;
    Box around;
    const auto search = [&] {
        if (count > 0) near.gather(state.tree, around);
        for (std::size_t i = 0; i < count; ++i) pairWithNear(state, scratch, group[i], near, found);
        count = 0;
    };
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const Body& body = state.bodies[scratch.moved[i]];
        for (std::uint32_t proxy = body.firstProxy; proxy != kNone; proxy = state.proxies[proxy].next) {
            const Box& box = state.tree.box(state.proxies[proxy].leaf);
            const Box all = count == 0 ? box : joined(around, box);
            const float separate = around.halfSurfaceArea() + box.halfSurfaceArea();
            if (count == kMaxGroup || (count > 0 && all.halfSurfaceArea() > kMaxGrowth * separate)) {
                search();
                around = box;
            } else {
                around = all;
            }
            group[count++] = proxy;
        }
    }
    search();
}

/// If at least half of all boxes moved, the tree would be rebuilt for one query.
bool isSweepFaster(const WorldState& state, const PairScratch& scratch) {
    constexpr std::size_t kMin = 64, kMax = 32768;  // a sweep takes O(n^(5/3)) in a uniform volume
    return state.tree.size() >= kMin && state.tree.size() <= kMax && 2 * scratch.moved.size() >= state.tree.size();
}

/// Whether something that flies is swept against a body.
bool isObstacle(const WorldState& state, const PairScratch& scratch, std::uint32_t body) {
    return !scratch.flying.empty() && WorldState::areSwept(state.obstacleSizes[body], scratch.smallestFlying);
}

/// The pairs of a body that flies with what its whole movement may lead through, of which near(box) returns the proxies
/// in a box.
template <class Near>
void pairWithObstacles(const WorldState& state, const PairScratch& scratch, std::uint32_t body, const Near& near,
                       std::vector<std::uint32_t>& found) {
    const auto isWanted = [&](std::uint32_t other) { return state.isSwept(body, other); };
    for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone; proxy = state.proxies[proxy].next)
        listPairs(state, proxy, near(scratch.wholeBoxes[proxy]), isWanted, found);
}

/// The pairs of all moved bodies, by a sweep over all boxes.
void findPairsBySweep(const WorldState& state, ThreadPool& threads, PairScratch& scratch, std::size_t chunks) {
    scratch.sweep.clear();
    scratch.obstacles.clear();
    for (std::uint32_t proxy = 0; proxy < state.proxies.size(); ++proxy) {
        const auto& [body, hull, leaf, next] = state.proxies[proxy];
        if (leaf == kNone) continue;
        scratch.sweep.add(proxy, state.tree.box(leaf));
        if (isObstacle(state, scratch, body)) scratch.obstacles.add(proxy, state.tree.box(leaf));
    }
    scratch.sweep.sort();
    scratch.obstacles.sort();
    scratch.sweepScratch.resize(scratch.found.size());
    threads.forEachChunk(scratch.sweep.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        for (std::size_t rank = range.begin; rank < range.end; ++rank) {
            const std::uint32_t proxy = scratch.sweep.number(rank);
            const bool hasMoved = scratch.isMoved[state.proxies[proxy].body] != 0;
            const auto oneMoved = [&](std::uint32_t other) { return hasMoved | (scratch.isMoved[other] != 0); };
            listPairs(state, proxy, scratch.sweep.overlappingLater(rank, scratch.sweepScratch[chunk]), oneMoved,
                      scratch.found[chunk]);
        }
    });
    threads.forEachChunk(scratch.flying.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        const auto near = [&](const Box& box) {
            return scratch.obstacles.overlapping(box, scratch.sweepScratch[chunk]);
        };
        for (std::size_t i = range.begin; i < range.end; ++i)
            pairWithObstacles(state, scratch, scratch.flying[i], near, scratch.ahead[chunk]);
    });
}

/// The pairs of what flew already before a change within the step with the obstacles that moved by it.
void findMovedObstacles(const WorldState& state, PairScratch& scratch) {
    if (scratch.firstFlying == 0) return;
    scratch.obstacles.clear();
    for (const std::uint32_t body : scratch.moved) {
        if (!isObstacle(state, scratch, body)) continue;
        for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone; proxy = state.proxies[proxy].next)
            scratch.obstacles.add(proxy, state.tree.box(state.proxies[proxy].leaf));
    }
    scratch.obstacles.sort();
    scratch.sweepScratch.resize(std::max<std::size_t>(1, scratch.sweepScratch.size()));
    const auto near = [&](const Box& box) { return scratch.obstacles.overlapping(box, scratch.sweepScratch[0]); };
    for (const std::uint32_t body : std::span(scratch.flying).first(scratch.firstFlying)) {
        if (state.isFlying(body)) pairWithObstacles(state, scratch, body, near, scratch.ahead.back());
    }
}

/// The bounding box of the fat boxes of a body.
Box boundsOf(const WorldState& state, std::uint32_t body) {
    const std::span<const Proxy> proxies = state.proxies;
    Box bounds = state.tree.box(proxies[state.bodies[body].firstProxy].leaf);
    for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone; proxy = proxies[proxy].next)
        bounds = joined(bounds, state.tree.box(proxies[proxy].leaf));
    return bounds;
}

/// Whether what is near a body searches for its pairs: it has many hulls, most of them far from anything.
bool isSearchedFor(const WorldState& state, std::uint32_t body) {
    constexpr std::size_t kManyHulls = 32;
    return !state.bodies[body].isDynamic() && state.bodies[body].shape->hulls.size() >= kManyHulls;
}

/// Has what is near moved bodies of many hulls search in their place: counts as moved, or as begun to fly.
void listSearching(WorldState& state, PairScratch& scratch) {
    const auto isSearched = [&](std::uint32_t body) { return isSearchedFor(state, body); };
    const auto large = std::ranges::stable_partition(scratch.moved, std::not_fn(isSearched));
    std::vector<Box> bounds;
    for (const std::uint32_t body : large) {
        bounds.push_back(boundsOf(state, body));
        scratch.isMoved[body] = 0;
    }
    scratch.moved.erase(large.begin(), large.end());
    if (bounds.empty()) return;
    for (std::uint32_t body = 1; body < state.bodies.size(); ++body) {
        if (state.bodies[body].shape == nullptr || !state.bodies[body].isDynamic()) continue;
        const auto isNear = [&](std::uint32_t proxy) {
            const Box& whole = wholeBox(state, scratch, proxy);
            return std::ranges::any_of(bounds, [&](const Box& box) { return box.overlaps(whole); });
        };
        std::uint32_t proxy = state.bodies[body].firstProxy;
        while (proxy != kNone && !isNear(proxy)) proxy = state.proxies[proxy].next;
        if (proxy == kNone) continue;
        if (scratch.isMoved[body] == 0) scratch.moved.push_back(body);
        scratch.isMoved[body] = 1;
    }
    // Those that flew already search along all of their movement again.
    const auto begin = scratch.flying.begin(), first = begin + static_cast<std::ptrdiff_t>(scratch.firstFlying);
    const auto again = std::partition(begin, first, [&](std::uint32_t body) { return scratch.isMoved[body] == 0; });
    scratch.firstFlying = static_cast<std::size_t>(again - begin);
}

/// The pairs of all moved bodies, by the tree.
void findPairsByTree(WorldState& state, ThreadPool& threads, PairScratch& scratch, std::size_t chunks) {
    scratch.near.resize(scratch.found.size());
    listSearching(state, scratch);
    threads.forEachChunk(scratch.moved.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        searchAround(state, scratch, range, scratch.near[chunk], scratch.found[chunk]);
    });
    const std::span newFlying = std::span(scratch.flying).subspan(scratch.firstFlying);
    threads.forEachChunk(newFlying.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        std::vector<std::uint32_t> proxies;
        const auto near = [&](const Box& box) {
            proxies.clear();
            state.tree.visitOverlapping(box, [&](std::uint32_t proxy, const Box&) { proxies.push_back(proxy); });
            return std::span<const std::uint32_t>(proxies);
        };
        for (std::size_t i = range.begin; i < range.end; ++i)
            pairWithObstacles(state, scratch, newFlying[i], near, scratch.ahead[chunk]);
    });
    findMovedObstacles(state, scratch);
}

bool boxesOverlap(const WorldState& state, const PairScratch& scratch, const Contact& contact) {
    const auto [first, second] = contact.proxies;
    if (state.tree.box(state.proxies[first].leaf).overlaps(state.tree.box(state.proxies[second].leaf))) return true;
    return state.isSwept(contact.bodies[0], contact.bodies[1]) &&
           wholeBox(state, scratch, first).overlaps(wholeBox(state, scratch, second));
}

void listSeparatedContacts(const WorldState& state, PairScratch& scratch) {
    scratch.separatedContacts.clear();
    const auto add = [&](std::uint32_t contact) {
        if (!boxesOverlap(state, scratch, state.contacts[contact])) scratch.separatedContacts.push_back(contact);
    };
    // A walk along the contacts of a body waits for memory at each one.
    constexpr std::size_t kContactsPerWalk = 200;
    if (scratch.moved.size() * kContactsPerWalk > state.contacts.size()) {
        for (std::uint32_t number = 0; number < state.contacts.size(); ++number) {
            const Contact& contact = state.contacts[number];
            if (contact.proxies[0] == kNone) continue;
            if ((scratch.isMoved[contact.bodies[0]] | scratch.isMoved[contact.bodies[1]]) != 0) add(number);
        }
        return;
    }
    for (std::uint32_t body : scratch.moved) {
        visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t other) {
            if (scratch.isMoved[other] == 0 || body < other) add(contact);
        });
    }
}

void removeSeparatedContacts(WorldState& state, PairScratch& scratch) {
    listSeparatedContacts(state, scratch);
    for (std::uint32_t contact : scratch.separatedContacts) {
        for (std::uint32_t body : state.contacts[contact].bodies) {
            if (state.contacts[contact].stored != kNone) wakeBody(state, body);
        }
        removeContact(state, contact);
    }
}

/// Whether the step being solved moves a body as it was predicted, up to the margin of its boxes.
bool movesAsPredicted(const WorldState& state, std::uint32_t body) {
    const BodyPose& pose = state.poses[body];
    const Prediction& predicted = state.predictions[body];
    const Vec3f unforeseen = pose.centre + state.motions[body].deltaPosition - predicted.centre;
    return length(unforeseen) <= boxMargin(pose.boundingRadius) && arcOf(state, body) <= predicted.arc - pose.arc;
}

}  // namespace

float boxMargin(float boundingRadius) {
    constexpr float kMaxMargin = 0.05f;          // m
    constexpr float kFractionOfRadius = 0.125f;  // for small bodies
    return std::min(kMaxMargin, kFractionOfRadius * boundingRadius);
}

Box tightBox(const PlacedHull& placed, const BodyPose& pose) {
    const Hull& hull = *placed.hull;
    const Mat3f rotation = pose.rotation.matrix();
    const Vec3f middle = pose.centre + rotation * (placed.offset + hull.middle);
    const Vec3f half = componentAbs(rotation.x) * hull.extents.x + componentAbs(rotation.y) * hull.extents.y +
                       componentAbs(rotation.z) * hull.extents.z;
    return {middle - half, middle + half};
}

Box tightBox(const WorldState& state, const Proxy& proxy) {
    return tightBox(placedHullOf(state, proxy), state.poses[proxy.body]);
}

void addProxies(WorldState& state, std::uint32_t body) {
    const auto hulls = static_cast<std::uint32_t>(state.bodies[body].shape->hulls.size());
    for (std::uint32_t hull = hulls; hull-- > 0;) linkProxy(state, body, hull);
    state.rebox.push_back(body);
}

void linkProxy(WorldState& state, std::uint32_t body, std::uint32_t hull) {
    if (state.freeProxies.empty()) {
        state.freeProxies.push_back(static_cast<std::uint32_t>(state.proxies.size()));
        state.proxies.emplace_back();
    }
    const std::uint32_t number = state.freeProxies.back();
    state.freeProxies.pop_back();
    Proxy& proxy = state.proxies[number];
    proxy = {body, hull, kNone, std::exchange(state.bodies[body].firstProxy, number)};
    proxy.leaf = state.tree.insert(tightBox(state, proxy), number);
}

void removeProxy(WorldState& state, std::uint32_t proxy) {
    state.tree.remove(state.proxies[proxy].leaf);
    state.proxies[proxy] = {};
    state.freeProxies.push_back(proxy);
}

void removeProxies(WorldState& state, std::uint32_t body) {
    for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone;) {
        const std::uint32_t next = state.proxies[proxy].next;
        removeProxy(state, proxy);
        proxy = next;
    }
    state.bodies[body].firstProxy = kNone;
}

void findPairs(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch, float dt,
               PairBodies bodies) {
    updateBoxes(state, threads, regions, scratch, dt, bodies);
    if (scratch.moved.empty()) return;
    scratch.smallestFlying = kStands;
    for (const std::uint32_t body : scratch.flying)
        scratch.smallestFlying = std::min(scratch.smallestFlying, state.obstacleSizes[body]);
    removeSeparatedContacts(state, scratch);
    const std::size_t chunks = regions.count() == 1 ? 1 : threads.chunkCount(scratch.moved.size(), kMinBodiesPerChunk);
    clearLists(scratch.found, chunks);
    clearLists(scratch.ahead, chunks);
    if (isSweepFaster(state, scratch)) {
        findPairsBySweep(state, threads, scratch, chunks);
    } else {
        state.tree.update();
        findPairsByTree(state, threads, scratch, chunks);
    }
    // All of one kind, then all of the other: contacts have the same numbers on any number of chunks.
    for (const auto* lists : {&scratch.found, &scratch.ahead}) {
        for (const std::vector<std::uint32_t>& found : *lists)
            for (std::size_t i = 0; i < found.size(); i += 2) addContact(state, found[i], found[i + 1]);
    }
}

void findUnforeseenPairs(WorldState& state, ThreadPool& threads, const Regions& regions, PairScratch& scratch) {
    clearLists(scratch.leaving, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t body : regions.bodies(region)) {
            const float left = state.bodies[body].boxValidUntil - state.poses[body].travel;
            if (maxReachOf(state, body) <= left || reachOf(state, body) <= left) continue;
            // With nothing left, its boxes are of this step: around the predicted movement and a margin.
            if (left != 0.0f || !movesAsPredicted(state, body)) scratch.leaving[region].push_back(body);
        }
    });
    for (const std::uint32_t body : mergeSorted(scratch.leaving)) {
        if (!state.bodies[body].isDynamic()) continue;
        const BodyPose after = poseAfter(state, body);
        for (std::uint32_t proxy = state.bodies[body].firstProxy; proxy != kNone; proxy = state.proxies[proxy].next) {
            const PlacedHull& hull = placedHullOf(state, state.proxies[proxy]);
            const Box path = joined(tightBox(hull, state.poses[body]), tightBox(hull, after));
            if (wholeBox(state, scratch, proxy).contains(path)) continue;
            state.tree.visitOverlapping(path, [&](std::uint32_t other, const Box&) {
                if (!state.bodies[state.proxies[other].body].isDynamic()) addContact(state, proxy, other);
            });
        }
    }
}

}  // namespace rubble
