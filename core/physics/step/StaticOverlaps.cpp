#include "core/physics/step/StaticOverlaps.h"

#include "core/physics/narrowphase/HullRay.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>

namespace rubble {
namespace {

// How deep bodies may be: thin ones less, so that their centres stay outside.
constexpr float kMinDepth = 0.00002f, kMaxDepth = 0.004f;  // m
constexpr float kWidthFraction = 0.4f;
constexpr float kOutSpeed = 0.1f;                             // m/s: of what is deeper already
constexpr float kMaxReach = 0.00025f, kReachFraction = 0.1f;  // m, of the width: what moves less comes no deeper
constexpr float kRounding = 5e-7f;                            // of positions, relative, with that of their sums
constexpr int kRounds = 4;                                    // of displacements, where several bodies displace one

/// Whether the bodies of a contact may come to overlap, or overlap deeper. A manifold that is recycled says nothing of
/// other corners.
bool mayOverlap(const WorldState& state, const Contact& contact) {
    return contact.slot.isSet() || mayHaveTouched(state, state.separated[contact.separatedIndex]);
}

/// A contact of a body with one that is not dynamic.
struct StaticContact {
    const PlacedHull& hull;
    std::uint32_t other = 0;  // body
    const PlacedHull& otherHull;
};

/// The axis of least overlap at poses of both bodies, in the frame of the first: any along which they overlap by less
/// than `depth`, m, if there is one.
SeparatingAxis overlapOf(const StaticContact& contact, const BodyPose& body, const BodyPose& other, float depth) {
    const RelativePose pose = relativePose(body, contact.hull.offset, other, contact.otherHull.offset);
    const Hull &first = *contact.hull.hull, &second = *contact.otherHull.hull;
    return separatingAxis(first, second, pose, -depth, initialGuess(first, second, pose));
}

/// What moves a body out of another, m; zero if it is not too deep.
struct WayOut {
    Vec3f way{0.0f, 0.0f, 0.0f};
    bool isThrough = false;  // it would bring the hull to the other side
};

/// Whether the middle of a hull passes through another on its way from before the step to after it and on.
bool passesThrough(const WorldState& state, std::uint32_t number, const StaticContact& contact, const BodyPose& after,
                   Vec3f way) {
    const Vec3f middle = contact.hull.offset + contact.hull.hull->mean;
    const auto inOther = [&](const BodyPose& body, const BodyPose& other) {
        const Vec3f at = body.centre + body.rotation.matrix() * middle;
        return other.rotation.matrix().transposedTimes(at - other.centre) - contact.otherHull.offset;
    };
    BodyPose last = after;
    last.centre += way;
    const Vec3f from = inOther(state.poses[number], state.poses[contact.other]);
    const Vec3f to = inOther(last, poseAfter(state, contact.other));
    return castRay(*contact.otherHull.hull, from, to - from).fraction <= 1.0f;
}

WayOut wayOut(const WorldState& state, std::uint32_t number, const StaticContact& contact, const SolverStep& step) {
    const float most = std::clamp(kWidthFraction * contact.hull.hull->minWidth, kMinDepth, kMaxDepth);
    const BodyPose pose = poseAfter(state, number);
    const SeparatingAxis axis = overlapOf(contact, pose, poseAfter(state, contact.other), most);
    if (axis.separation >= -most) return {};
    const SeparatingAxis before = overlapOf(contact, state.poses[number], state.poses[contact.other], most);
    const float allowed = std::max(most, -before.separation - kOutSpeed * step.dt);
    const Vec3f size = componentAbs(pose.centre);
    const float rounding = kRounding * std::max({1.0f, size.x, size.y, size.z});
    if (axis.separation >= -allowed - rounding) return {};
    const Vec3f way = pose.rotation.matrix() * axis.normal * (axis.separation + allowed);
    return {way, passesThrough(state, number, contact, pose, way)};
}

/// Calls visit(way) for what moves a body out of what is not dynamic, one after the other.
template <class Visit>
void visitWaysOut(WorldState& state, std::span<const BodyContact> contacts, const SolverStep& step,
                  const Visit& visit) {
    for (const auto [number, index, other] : contacts) {
        const Contact& contact = state.contacts[index];
        if (!mayOverlap(state, contact)) continue;
        const std::size_t side = contact.bodies[0] == number ? 0 : 1;
        const StaticContact one{placedHullOf(state, state.proxies[contact.proxies[side]]), other,
                                placedHullOf(state, state.proxies[contact.proxies[1 - side]])};
        const WayOut way = wayOut(state, number, one, step);
        if (way.way == Vec3f(0.0f)) continue;
        if (contact.slot.isSet()) outdateManifold(state, contact);
        visit(way);
    }
}

/// Returns whether nothing displaces the body any more.
bool displace(WorldState& state, std::span<const BodyContact> contacts, const SolverStep& step) {
    const std::uint32_t number = contacts.front().body;
    for (int round = 0; round < kRounds; ++round) {
        bool isOut = true;
        bool isThrough = false;
        visitWaysOut(state, contacts, step, [&](const WayOut& way) {
            correctDisplacement(state, number, state.motions[number].deltaPosition + way.way);
            isOut = false;
            isThrough |= way.isThrough;
        });
        if (isOut || isThrough) return isOut;
    }
    return false;
}

/// Lets a body move by the largest of some fractions of what it moved that leaves it out of what is not dynamic.
void shorten(WorldState& state, std::span<const BodyContact> contacts, const SolverStep& step,
             const BodyMotion& moved) {
    const std::uint32_t number = contacts.front().body;
    const Quatf turned = moved.deltaRotation.normalized();
    for (const float fraction : {0.5f, 0.25f, 0.0f}) {
        state.motions[number].deltaRotation =
            Quatf{turned.x * fraction, turned.y * fraction, turned.z * fraction, 1.0f - fraction + turned.w * fraction}
                .normalized();
        correctDisplacement(state, number, moved.deltaPosition * fraction);
        bool isOut = true;
        visitWaysOut(state, contacts, step, [&](const WayOut&) { isOut = false; });
        if (isOut) return;
    }
}

}  // namespace

void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step,
                         StaticOverlapScratch& scratch) {
    clearLists(scratch.moving, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t number : regions.bodies(region)) {
            const Body& body = state.bodies[number];
            const float least = std::min(kMaxReach, kReachFraction * body.shape->minWidth);
            if (maxReachOf(state, number) > least && body.isDynamic()) scratch.moving[region].push_back(number);
        }
    });
    const auto isStatic = [&](std::uint32_t, std::uint32_t other, const SeparatedContact*) {
        return state.motions[other].inverseMass == 0.0f;
    };
    const std::span<const BodyContact> contacts = scratch.contacts.of(state, mergeSorted(scratch.moving), isStatic);
    scratch.begins.clear();  // of the contacts of a body
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (i == 0 || contacts[i].body != contacts[i - 1].body) scratch.begins.push_back(i);
    }
    constexpr std::size_t kMinPerChunk = 64;
    const std::size_t chunks = regions.count() == 1 ? 1 : threads.chunkCount(scratch.begins.size(), kMinPerChunk);
    threads.forEachChunk(scratch.begins.size(), chunks, [&](IndexRange range, std::size_t) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::size_t end = i + 1 < scratch.begins.size() ? scratch.begins[i + 1] : contacts.size();
            const auto own = contacts.subspan(scratch.begins[i], end - scratch.begins[i]);
            const BodyMotion moved = state.motions[own.front().body];
            if (!displace(state, own, step)) shorten(state, own, step, moved);
        }
    });
}

}  // namespace rubble
