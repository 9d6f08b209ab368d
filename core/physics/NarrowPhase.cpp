#include "core/physics/NarrowPhase.h"

#include "core/physics/Contacts.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Bodies nearer than this get a manifold before they touch, so that they do not overlap first.
constexpr float kSpeculativeDistance = 0.02f;  // m
/// A manifold is kept while its bodies move less against each other than this.
constexpr float kMostSlack = 0.02f;  // m
/// Bodies that are apart are looked at again when they may have closed this share of the gap.
constexpr float kGapShare = 0.75f;
/// Bodies that pass this share of the thinner one's breadth in a step are swept.
constexpr float kSweptShare = 0.5f;
constexpr std::size_t kLeastLooks = 8;
constexpr std::size_t kLeastBlocks = 32;
constexpr std::size_t kLeastOpen = 1024;

const Hull& hullOf(const WorldState& state, std::uint32_t proxy) {
    return state.bodies[state.proxies[proxy].body].shape->hulls[state.proxies[proxy].hull];
}

RelativePlace relativePlace(const BodyPlace& first, const BodyPlace& second) {
    const Mat3f turn = first.turn.matrix();
    return {turn.transposed() * second.turn.matrix(), turn.transposedTimes(second.centre - first.centre)};
}

/// The point of two hulls that touch at a corner which the clipping lost.
void touchAtCorner(Manifold& manifold, const SeparatingAxis& axis, const Hull& second, const RelativePlace& place) {
    const int corner = second.farthest(place.turn.transposedTimes(axis.normal) * -1.0f);
    manifold.normal = axis.normal;
    manifold.count = 1;
    manifold.points[0] = {place.turn * second.corner(corner) + place.offset, 0.0f, static_cast<std::uint32_t>(corner)};
}

void sweep(Look& look, const Hull& first, const Hull& second, RelativePlace place, Vec3f way) {
    const SweptTouch touch = sweptTouch(first, second, place, way);
    if (touch.axis.kind == AxisKind::None) return;
    place.offset = place.offset + way * touch.share;
    look.axis = touch.axis;
    look.offset = place.offset;
    look.isSwept = true;
    // What has not arrived yet when the first corner does holds the others back as they turn towards it.
    look.manifold = manifoldAlong(touch.axis, first, second, place, 2.0f * std::min(first.reach, second.reach));
    look.manifold.normal = touch.axis.normal;
    if (look.manifold.count == 0) touchAtCorner(look.manifold, touch.axis, second, place);
}

/// A unit vector square to another, the same for the same.
Vec3f tangentOf(Vec3f normal) {
    const Vec3f size = magnitudes(normal);
    const Vec3f other = size.x <= size.y && size.x <= size.z ? Vec3f(1.0f, 0.0f, 0.0f)
                        : size.y <= size.z                   ? Vec3f(0.0f, 1.0f, 0.0f)
                                                             : Vec3f(0.0f, 0.0f, 1.0f);
    return normalized(cross(normal, other));
}

// A lane of rows.
Vec3f at(const Vec3Row& rows, std::size_t lane) { return Vec3f(rows.x[lane], rows.y[lane], rows.z[lane]); }
void put(Vec3f v, Vec3Row& rows, std::size_t lane) {
    rows.x[lane] = v.x;
    rows.y[lane] = v.y;
    rows.z[lane] = v.z;
}
void put(Quatf q, QuatRow& rows, std::size_t lane) {
    rows.x[lane] = q.x;
    rows.y[lane] = q.y;
    rows.z[lane] = q.z;
    rows.w[lane] = q.w;
}

/// The friction of the last step, along the new tangents.
void turnFriction(ContactBlock& block, std::size_t lane, Vec3f normal) {
    const Vec3f oldTangent = at(block.tangent, lane), oldNormal = at(block.normal, lane);
    const Vec3f friction = oldTangent * block.frictionX[lane] + cross(oldNormal, oldTangent) * block.frictionY[lane];
    const Vec3f tangent = tangentOf(normal);
    block.frictionX[lane] = dot(friction, tangent);
    block.frictionY[lane] = dot(friction, cross(normal, tangent));
    put(normal, block.normal, lane);
    put(tangent, block.tangent, lane);
}

/// Impulses of points that were there before stay with them.
void putPoints(Contact& contact, ContactBlock& block, ReferenceBlock& reference, std::size_t lane,
               const Manifold& manifold, const Mat3f& turn) {
    const auto before = static_cast<std::size_t>(block.pointCount[lane]);
    std::array<float, kMostManifoldPoints> impulses{};
    std::array<std::uint32_t, kMostManifoldPoints> features{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        features[i] = manifold.points[i].feature;
        for (std::size_t j = 0; j < before; ++j) {
            if (contact.features[j] == features[i]) impulses[i] = block.points[j].impulse[lane];
        }
    }
    for (std::size_t i = 0; i < kMostManifoldPoints; ++i) {
        const bool isThere = i < static_cast<std::size_t>(manifold.count);
        put(isThere ? turn * manifold.points[i].place : Vec3f(0.0f), block.points[i].place, lane);
        block.points[i].impulse[lane] = impulses[i];
        reference.separation[i][lane] = isThere ? manifold.points[i].separation : 0.0f;
    }
    block.pointCount[lane] = static_cast<std::uint32_t>(manifold.count);
    contact.features = features;
}

/// Writes what was seen into the contact's lane.
void keepManifold(WorldState& state, std::uint32_t number, const Look& look) {
    Contact& contact = state.contacts[number];
    ContactBlock& block = state.colours.block(contact.slot);
    ReferenceBlock& reference = state.colours.reference(contact.slot);
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    const BodyPlace &first = state.places[contact.bodies[0]], &second = state.places[contact.bodies[1]];
    const Mat3f turn = first.turn.matrix();
    turnFriction(block, lane, turn * look.manifold.normal);
    putPoints(contact, block, reference, lane, look.manifold, turn);
    put(first.turn, reference.firstTurn, lane);
    put(second.turn, reference.secondTurn, lane);
    put(look.isSwept ? turn * look.offset * -1.0f : first.centre - second.centre, reference.apart, lane);
    reference.isSwept[lane] = look.isSwept ? 1.0f : 0.0f;
    reference.slack[lane] = look.isSwept ? -1.0f : kMostSlack;
    const Body &a = state.bodies[contact.bodies[0]], &b = state.bodies[contact.bodies[1]];
    block.friction[lane] = std::sqrt(a.friction * b.friction);
    block.restitution[lane] = std::max(a.restitution, b.restitution);
    contact.axis = look.axis;
}

/// Until when bodies that are apart need no look.
void noteGap(WorldState& state, std::uint32_t number, const Look& look) {
    Contact& contact = state.contacts[number];
    const float travelled = state.places[contact.bodies[0]].travel + state.places[contact.bodies[1]].travel;
    state.open[contact.openIndex].lookAt = travelled + std::max(0.0f, kGapShare * look.axis.separation);
    contact.axis = look.axis;
}

void markStale(const WorldState& state, WorkerTeam& team, LookScratch& scratch, const SolverKernels& kernels,
               const SolverStep& step) {
    std::size_t count = 0;
    for (const ContactColours::List& list : state.colours.lists()) count += list.blocks.size();
    scratch.staleLanes.resize(count);
    team.share(count, team.chunksOf(count, kLeastBlocks), [&](IndexRange range, std::size_t) {
        std::size_t first = 0;  // block of this colour
        for (const ContactColours::List& list : state.colours.lists()) {
            const std::size_t end = first + list.blocks.size();
            for (std::size_t i = std::max(first, range.begin); i < std::min(end, range.end); ++i) {
                scratch.staleLanes[i] = static_cast<unsigned char>(
                    kernels.staleLanes(list.blocks[i - first], list.references[i - first], step));
            }
            first = end;
        }
    });
}

void listStale(const WorldState& state, LookScratch& scratch) {
    std::size_t number = 0;
    for (const ContactColours::List& list : state.colours.lists()) {
        for (const ContactBlock& block : list.blocks) {
            const unsigned stale = scratch.staleLanes[number++];
            for (std::size_t lane = 0; stale >> lane != 0; ++lane) {
                if ((stale >> lane & 1u) != 0) scratch.contacts.push_back(block.contact[lane]);
            }
        }
    }
}

void listOpenThatMayTouch(const WorldState& state, WorkerTeam& team, LookScratch& scratch, bool newOnly) {
    const std::size_t chunks = team.chunksOf(state.open.size(), kLeastOpen);
    scratch.open.resize(std::max(chunks, scratch.open.size()));
    for (std::vector<std::uint32_t>& open : scratch.open) open.clear();
    team.share(state.open.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        std::vector<std::uint32_t>& open = scratch.open[chunk];
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const OpenContact& contact = state.open[i];
            const float ahead = state.ahead[contact.bodies[0]] + state.ahead[contact.bodies[1]];
            if (newOnly ? contact.lookAt == kNeverLooked : ahead >= contact.lookAt) open.push_back(contact.contact);
        }
    });
    for (const std::vector<std::uint32_t>& open : scratch.open) {
        scratch.contacts.insert(scratch.contacts.end(), open.begin(), open.end());
    }
}

}  // namespace

Look lookAt(const WorldState& state, const Contact& contact, float dt) {
    const Hull &first = hullOf(state, contact.proxies[0]), &second = hullOf(state, contact.proxies[1]);
    const BodyPlace &firstPlace = state.places[contact.bodies[0]], &secondPlace = state.places[contact.bodies[1]];
    const RelativePlace place = relativePlace(firstPlace, secondPlace);
    const BodyMotion &a = state.motions[contact.bodies[0]], &b = state.motions[contact.bodies[1]];
    const Vec3f way = (b.velocity - a.velocity) * dt;
    const float far = length(way), breadth = std::min(first.breadth, second.breadth);
    const bool isFast = far > kSweptShare * breadth;
    const float margin = kSpeculativeDistance + (isFast ? 0.0f : far);
    Look look;
    look.offset = place.offset;
    look.axis = separatingAxis(first, second, place, margin, contact.axis);
    if (look.axis.separation <= margin) {
        look.manifold = manifoldAlong(look.axis, first, second, place, margin);
    } else if (isFast) {
        sweep(look, first, second, place, firstPlace.turn.matrix().transposedTimes(way));
    }
    return look;
}

int findManifolds(WorldState& state, WorkerTeam& team, LookScratch& scratch, const SolverKernels& kernels,
                  const SolverStep& step, bool newOnly) {
    scratch.contacts.clear();
    if (!newOnly) {
        markStale(state, team, scratch, kernels, step);
        listStale(state, scratch);
    }
    listOpenThatMayTouch(state, team, scratch, newOnly);
    // In which lanes contacts are must not decide who gets which colour.
    std::sort(scratch.contacts.begin(), scratch.contacts.end());
    scratch.looks.resize(scratch.contacts.size());
    const std::size_t chunks = team.chunksOf(scratch.contacts.size(), kLeastLooks);
    team.share(scratch.contacts.size(), chunks, [&](IndexRange range, std::size_t) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::uint32_t number = scratch.contacts[i];
            scratch.looks[i] = lookAt(state, state.contacts[number], step.dt);
            if (state.contacts[number].slot.isSet() && scratch.looks[i].manifold.count > 0) {
                keepManifold(state, number, scratch.looks[i]);
            }
        }
    });
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        const std::uint32_t number = scratch.contacts[i];
        const bool touches = scratch.looks[i].manifold.count > 0, touched = state.contacts[number].slot.isSet();
        const auto points = static_cast<std::uint32_t>(scratch.looks[i].manifold.count);
        if (touches && touched) {
            moveLane(state, number, points);
        } else if (touches) {
            beginTouching(state, number, points);
            keepManifold(state, number, scratch.looks[i]);
        } else if (!touches) {
            if (touched) endTouching(state, number);
            noteGap(state, number, scratch.looks[i]);
        }
    }
    return static_cast<int>(scratch.contacts.size());
}

}  // namespace rubble
