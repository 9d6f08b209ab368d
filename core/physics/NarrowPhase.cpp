#include "core/physics/NarrowPhase.h"

#include "core/physics/Contacts.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// A manifold is kept while its bodies move less against each other than this.
constexpr float kMostSlack = 0.02f;  // m
/// Bodies that are apart are looked at again when they may have closed this share of the gap.
constexpr float kGapShare = 0.75f;
/// Bodies that pass this share of the thinner one's breadth in a step are swept.
constexpr float kSweptShare = 0.5f;
constexpr std::size_t kLeastOpen = 1024;

void sweep(Look& look, const Hull& first, const Hull& second, RelativePlace place, Vec3f way) {
    const SweptTouch touch = sweptTouch(first, second, place, way);
    if (touch.axis.kind == AxisKind::None) return;
    place.offset = place.offset + way * touch.share;
    look.axis = touch.axis;
    look.offset = place.offset;
    look.isSwept = true;
    // What has not arrived yet when the first corner does holds the others back as they turn towards it.
    look.manifold = touchingAlong(touch.axis, first, second, place, 2.0f * std::min(first.reach, second.reach));
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
    const Vec3f tangent = tangentOf(normal);
    const float x = block.frictionX[lane], y = block.frictionY[lane];
    if (x != 0.0f || y != 0.0f) {  // not where it begins to touch
        const Vec3f oldTangent = at(block.tangent, lane), oldNormal = at(block.normal, lane);
        const Vec3f friction = oldTangent * x + cross(oldNormal, oldTangent) * y;
        block.frictionX[lane] = dot(friction, tangent);
        block.frictionY[lane] = dot(friction, cross(normal, tangent));
    }
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

/// Looks along one face. True where that settles it: the face separates the hulls, or a point of one lies so near over the face that no
/// other axis can separate them by clearly more.
bool isSettledBy(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePlace& place,
                 float margin, Look& look) {
    constexpr float kClearly = 2.0f * kAxisPreference;
    look.axis = face;
    look.manifold = {};
    if (face.separation > margin) return true;
    look.manifold = manifoldAlong(face, first, second, place, margin);
    const float enough = face.separation + kClearly;
    const auto isNear = [&](const Manifold::Point& point) { return point.separation <= enough; };
    return enough >= 0.0f &&
           std::any_of(look.manifold.points.begin(), look.manifold.points.begin() + look.manifold.count, isNear);
}

bool isSameFace(const SeparatingAxis& a, const SeparatingAxis& b) {
    return a.kind == b.kind && a.first == b.first && a.second == b.second;
}

void lookAndKeep(WorldState& state, std::uint32_t number, std::vector<Looked>& looks, float dt) {
    const Contact& contact = state.contacts[number];
    looks.push_back({number, lookAt(state, contact, dt)});
    if (contact.slot.isSet() && looks.back().look.manifold.count > 0) keepManifold(state, number, looks.back().look);
}

/// Manifolds that are out of date, each made anew by whoever has its block.
void lookAtStale(WorldState& state, WorkerTeam& team, const Regions& regions, LookScratch& scratch,
                 const SolverKernels& kernels, const SolverStep& step) {
    scratch.stale.resize(regions.count());
    regions.forEach(team, [&](std::size_t region) {
        scratch.stale[region].clear();
        for (std::size_t number = 0; number < ContactColours::kLists; ++number) {
            const ContactColours::List& list = state.colours.lists()[number];
            const std::span blocks = regions.part(number, std::span(list.blocks), region);
            const std::span references = regions.part(number, std::span(list.references), region);
            regions.inTheirOrder(blocks.size(), region, [&](IndexRange range) {
                for (std::size_t i = range.begin; i < range.end; ++i) {
                    const unsigned stale = kernels.staleLanes(blocks[i], references[i], step);
                    for (std::size_t lane = 0; stale >> lane != 0; ++lane) {
                        if ((stale >> lane & 1u) == 0) continue;
                        lookAndKeep(state, blocks[i].contact[lane], scratch.stale[region], step.dt);
                    }
                }
            });
        }
    });
}

/// Contacts without manifold that may touch now.
void lookAtOpen(WorldState& state, WorkerTeam& team, const Regions& regions, LookScratch& scratch, float dt,
                bool newOnly) {
    const std::size_t chunks = regions.count() == 1 ? 1 : team.chunksOf(state.open.size(), kLeastOpen);
    scratch.open.resize(chunks);
    team.share(state.open.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        scratch.open[chunk].clear();
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const OpenContact& contact = state.open[i];
            const float ahead = state.ahead[contact.bodies[0]] + state.ahead[contact.bodies[1]];
            const bool mayTouch = newOnly ? contact.lookAt == kNeverLooked : ahead >= contact.lookAt;
            if (mayTouch) lookAndKeep(state, contact.contact, scratch.open[chunk], dt);
        }
    });
}

/// All that were looked at, in order of their numbers: in which lanes contacts are must not decide who gets which colour.
void sortLooks(LookScratch& scratch) {
    scratch.all.clear();
    for (const auto* some : {&scratch.stale, &scratch.open}) {
        for (const std::vector<Looked>& looks : *some) {
            for (const Looked& looked : looks) scratch.all.push_back(&looked);
        }
    }
    const auto isBefore = [](const Looked* a, const Looked* b) { return a->contact < b->contact; };
    if (!std::is_sorted(scratch.all.begin(), scratch.all.end(), isBefore)) {  // as newcomers come
        std::sort(scratch.all.begin(), scratch.all.end(), isBefore);
    }
}

}  // namespace

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

void keepGap(WorldState& state, std::uint32_t number, const Look& look) {
    Contact& contact = state.contacts[number];
    const float travelled = state.places[contact.bodies[0]].travel + state.places[contact.bodies[1]].travel;
    state.open[contact.openIndex].lookAt = travelled + std::max(0.0f, kGapShare * look.axis.separation);
    contact.axis = look.axis;
}

RelativePlace relativePlace(const BodyPlace& first, const BodyPlace& second) {
    const Mat3f turn = first.turn.matrix();
    return {turn.transposed() * second.turn.matrix(), turn.transposedTimes(second.centre - first.centre)};
}

Look lookAlong(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
               const SeparatingAxis& guess) {
    Look look;
    look.offset = place.offset;
    look.axis = guess.kind == AxisKind::None ? likelyFace(first, second, place) : guess;
    if (look.axis.isFace() &&
        isSettledBy(axisOfFace(look.axis, first, second, place), first, second, place, margin, look)) {
        return look;
    }
    const SeparatingAxis face = bestFaceAxis(first, second, place, margin, look.axis);
    if (!isSameFace(face, look.axis) && isSettledBy(face, first, second, place, margin, look)) return look;
    look.axis = bestEdgesOr(face, first, second, place, margin);
    if (look.axis.kind == AxisKind::Edges) {
        const bool isNear = look.axis.separation <= margin;
        look.manifold = isNear ? manifoldAlong(look.axis, first, second, place, margin) : Manifold{};
    }
    return look;
}

Look lookAt(const WorldState& state, const Contact& contact, float dt) {
    const Hull& first = hullOf(state, state.proxies[contact.proxies[0]]);
    const Hull& second = hullOf(state, state.proxies[contact.proxies[1]]);
    const BodyPlace &firstPlace = state.places[contact.bodies[0]], &secondPlace = state.places[contact.bodies[1]];
    const RelativePlace place = relativePlace(firstPlace, secondPlace);
    const BodyMotion &a = state.motions[contact.bodies[0]], &b = state.motions[contact.bodies[1]];
    const Vec3f way = (b.velocity - a.velocity) * dt;
    const float far = length(way), breadth = std::min(first.breadth, second.breadth);
    const bool isFast = far > kSweptShare * breadth;
    const float margin = kSpeculativeDistance + (isFast ? 0.0f : far);
    Look look = lookAlong(first, second, place, margin, contact.axis);
    if (look.axis.separation > margin && isFast) {
        sweep(look, first, second, place, firstPlace.turn.matrix().transposedTimes(way));
    }
    return look;
}

int findManifolds(WorldState& state, WorkerTeam& team, const Regions& regions, LookScratch& scratch,
                  const SolverKernels& kernels, const SolverStep& step, bool newOnly) {
    for (std::vector<Looked>& looks : scratch.stale) looks.clear();
    if (!newOnly) lookAtStale(state, team, regions, scratch, kernels, step);
    lookAtOpen(state, team, regions, scratch, step.dt, newOnly);
    sortLooks(scratch);
    for (const auto* looked : scratch.all) {
        const auto& [number, look] = *looked;
        const bool touches = look.manifold.count > 0, touched = state.contacts[number].slot.isSet();
        const auto points = static_cast<std::uint32_t>(look.manifold.count);
        if (touches && touched) {
            moveLane(state, number, points);
        } else if (touches) {
            beginTouching(state, number, points);
            keepManifold(state, number, look);
        } else if (!touches) {
            if (touched) endTouching(state, number);
            keepGap(state, number, look);
        }
    }
    return static_cast<int>(scratch.all.size());
}

}  // namespace rubble
