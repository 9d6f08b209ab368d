#include "core/physics/step/NarrowPhase.h"

#include "core/physics/islands/Sleeping.h"
#include "core/physics/narrowphase/SlidingAxis.h"
#include "core/physics/narrowphase/TimeOfImpact.h"
#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

/// A manifold is recycled while its bodies move less than this relative to each other. Small bodies would slide off
/// their points, which then rotate them and falsify their friction.
constexpr float kMaxSlack = 0.02f;      // m
constexpr float kSlackFraction = 0.2f;  // of the smaller bounding radius
/// They turn at most by half of the least angle between two faces of a hull, or by this: one of many faces rolls on to
/// the next.
constexpr float kMinTurn = 0.002f;  // rad
/// Bodies that move less than this in a step are not stopped by a contact ahead of them.
constexpr float kMinSliding = 0.001f;  // m
/// Separated bodies are collided again when they may have closed this fraction of the gap.
constexpr float kGapFraction = 0.75f;
/// Bodies that move more than this fraction of the thinner one's width in a step get a swept manifold.
constexpr float kSweptFraction = 0.5f;
constexpr float kSpinFraction = 0.5f;  // rad per step, from which on tangents lead too far out
constexpr std::size_t kMinContactsPerChunk = 1024;

/// False if hulls that are separated along an axis stay so while the second moves: a sweep would find nothing.
bool mayMeet(const SeparatingAxis& axis, Vec3f displacement) {
    constexpr float kRounding = 1e-4f;  // m: more than that of a sweep
    return axis.separation + dot(axis.normal, displacement) <= kRounding;
}

/// Replaces the manifold by that of the time of impact, if the hulls touch within the displacement.
void sweep(HullCollision& collision, const Hull& first, const Hull& second, RelativePose pose, Vec3f displacement) {
    const TimeOfImpact impact = timeOfImpact(first, second, pose, displacement);
    if (impact.axis.kind == AxisKind::None) return;
    pose.offset = pose.offset + displacement * impact.fraction;
    collision.axis = impact.axis;
    collision.offset = pose.offset;
    collision.isSwept = true;
    // With a wide margin: corners behind the first one resist the rotation towards them.
    collision.manifold = touchingManifold(impact.axis, first, second, pose,
                                          2.0f * std::min(first.boundingRadius, second.boundingRadius));
}

/// Replaces the manifold by that of the face along which the hulls slide. Without one, the contact is collided again in
/// the next step.
void slideAlong(HullCollision& collision, const SeparatingAxis& axis, const Hull& first, const Hull& second,
                const RelativePose& pose, float margin) {
    collision.axis = axis;
    collision.axis.separation = std::min(axis.separation, 0.0f);
    collision.manifold = axis.separation > margin ? Manifold{} : manifoldAlong(axis, first, second, pose, margin);
}

/// How far the rotation of a body in a step can move one of its points along a direction, m: no point leaves the sphere
/// around the body. `point` is relative to its centre.
float reachOfRotation(const BodyMotion& motion, const BodyPose& pose, Vec3f point, Vec3f direction, float dt) {
    const float radius = pose.boundingRadius;
    return std::min(length(motion.angularVelocity) * dt * radius, radius - dot(point, direction));
}

/// Removes the points that cannot touch in the step, however fast their bodies spin: taken as moving on along tangents,
/// they would collide in the air.
void removeOutOfReach(const WorldState& state, const Contact& contact, Manifold& manifold, Vec3f firstOffset,
                      float dt) {
    constexpr float kMargin = 2.0f;  // of what the bodies approach: what else they touch may push them
    const BodyPose &first = state.poses[contact.bodies[0]], &second = state.poses[contact.bodies[1]];
    const BodyMotion &a = state.motions[contact.bodies[0]], &b = state.motions[contact.bodies[1]];
    const Mat3f rotation = first.rotation.matrix();
    const Vec3f normal = rotation * manifold.normal;
    const float approach = (length(b.velocity - a.velocity) + length(state.gravity) * dt) * dt;
    int kept = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const float separation = manifold.points[i].separation;
        const Vec3f point = rotation * (manifold.points[i].position + firstOffset), half = normal * (0.5f * separation);
        const Vec3f ofSecond = point + half + first.centre - second.centre;
        const float reach = kMargin * approach + reachOfRotation(a, first, point - half, normal, dt) +
                            reachOfRotation(b, second, ofSecond, normal * -1.0f, dt);
        if (separation <= reach) manifold.points[kept++] = manifold.points[i];
    }
    manifold.count = kept;
}

/// A unit vector perpendicular to another, a function of it only.
Vec3f tangentOf(Vec3f normal) {
    const Vec3f size = componentAbs(normal);
    const Vec3f other = size.x <= size.y && size.x <= size.z ? Vec3f(1.0f, 0.0f, 0.0f)
                        : size.y <= size.z                   ? Vec3f(0.0f, 1.0f, 0.0f)
                                                             : Vec3f(0.0f, 0.0f, 1.0f);
    return normalized(cross(normal, other));
}

/// The velocity of a hull's origin.
Vec3f velocityOf(const BodyMotion& motion, const BodyPose& pose, const PlacedHull& placed) {
    return motion.velocity + cross(motion.angularVelocity, pose.rotation.matrix() * placed.offset);
}

/// Writes one lane.
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

/// Transforms the friction impulse of the last step to the tangents of a new normal.
void rotateFriction(ContactBlock& block, std::size_t lane, Vec3f normal) {
    const Vec3f tangent = tangentOf(normal);
    const float x = block.frictionX[lane], y = block.frictionY[lane];
    if (x != 0.0f || y != 0.0f) {  // zero for new contacts
        const Vec3f oldTangent = block.tangent.at(lane), oldNormal = block.normal.at(lane);
        const Vec3f friction = oldTangent * x + cross(oldNormal, oldTangent) * y;
        block.frictionX[lane] = dot(friction, tangent);
        block.frictionY[lane] = dot(friction, cross(normal, tangent));
    }
    put(normal, block.normal, lane);
    put(tangent, block.tangent, lane);
}

/// The overlap, m, up to which a contact is as soft as all; at twice of it, it is rigid. Thin bodies under many others
/// would sink into each other or into the ground by much of their width. Relative to the width, since rigid contacts
/// of a stack do not come to rest.
float softDepth(const WorldState& state, const Contact& contact) {
    constexpr float kMinDepth = 0.003f, kWidthFraction = 0.2f, kMaxFraction = 0.4f;
    const float width = std::min(hullOf(state, state.proxies[contact.proxies[0]]).minWidth,
                                 hullOf(state, state.proxies[contact.proxies[1]]).minWidth);
    return std::max(std::min(kMinDepth, kMaxFraction * width), kWidthFraction * width);
}

/// How far the bodies of a contact may move relative to each other before its manifold is outdated, m.
float maxSlack(const WorldState& state, const Contact& contact) {
    const float size = std::min(hullOf(state, state.proxies[contact.proxies[0]]).boundingRadius,
                                hullOf(state, state.proxies[contact.proxies[1]]).boundingRadius);
    const float turn = std::min(hullOf(state, state.proxies[contact.proxies[0]]).coarseTurn,
                                hullOf(state, state.proxies[contact.proxies[1]]).coarseTurn);
    return std::min(kMaxSlack, std::clamp(0.5f * turn, kMinTurn, kSlackFraction) * size);
}

/// Writes the points; those with a feature of the last manifold keep their impulses (warm starting). `offset` is that
/// of the manifold's frame in the first body, whose rotation is given.
void putPoints(Contact& contact, ContactBlock& block, ReferenceBlock& reference, std::size_t lane,
               const Manifold& manifold, const Mat3f& rotation, Vec3f offset) {
    const auto before = static_cast<std::size_t>(block.pointCount[lane]);
    std::array<float, kMaxManifoldPoints> impulses{};
    std::array<std::uint32_t, kMaxManifoldPoints> features{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        features[i] = manifold.points[i].feature;
        for (std::size_t j = 0; j < before; ++j) {
            if (contact.features[j] == features[i]) impulses[i] = block.points[j].impulse[lane];
        }
    }
    for (std::size_t i = 0; i < kMaxManifoldPoints; ++i) {
        const bool isThere = i < static_cast<std::size_t>(manifold.count);
        put(isThere ? rotation * (manifold.points[i].position + offset) : Vec3f(0.0f), block.points[i].position, lane);
        block.points[i].impulse[lane] = impulses[i];
        reference.separation[i][lane] = isThere ? manifold.points[i].separation : 0.0f;
    }
    block.pointCount[lane] = static_cast<std::uint32_t>(manifold.count);
    contact.features = features;
}

void collideAndStore(WorldState& state, std::uint32_t number, std::vector<ContactCollision>& collisions, float dt) {
    const Contact& contact = state.contacts[number];
    collisions.push_back({number, collideContact(state, contact, dt)});
    if (contact.slot.isSet() && collisions.back().collision.manifold.count > 0)
        storeManifold(state, number, collisions.back().collision);
}

/// Collides contacts whose manifold is outdated, each on the thread of its region.
void collideStale(WorldState& state, ThreadPool& threads, const Regions& regions, NarrowPhaseScratch& scratch,
                  const SolverKernels& kernels, const SolverStep& step) {
    clearLists(scratch.stale, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (std::size_t number = 0; number < ContactColours::kLists; ++number) {
            const ContactColours::List& list = state.colours.lists()[number];
            const std::span blocks = regions.part(number, std::span(list.blocks), region);
            const std::span references = regions.part(number, std::span(list.references), region);
            regions.forEachBlockRange(blocks.size(), region, [&](IndexRange range) {
                for (std::size_t i = range.begin; i < range.end; ++i) {
                    const unsigned stale = kernels.staleLanes(blocks[i], references[i], step);
                    for (std::size_t lane = 0; stale >> lane != 0; ++lane) {
                        if ((stale >> lane & 1u) == 0) continue;
                        collideAndStore(state, blocks[i].contact[lane], scratch.stale[region], step.dt);
                    }
                }
            });
        }
    });
}

/// Whether the bodies of a contact without a manifold may touch at the end of the coming step, where one may fall by
/// `fall`, m, more than the other.
bool mayTouch(const WorldState& state, const SeparatedContact& contact, float fall) {
    const Prediction &first = state.predictions[contact.bodies[0]], &second = state.predictions[contact.bodies[1]];
    return dot(contact.gapNormal, second.centre - first.centre) - first.arc - second.arc - fall <= contact.apart;
}

/// Collides contacts without manifold whose bodies may touch now.
void collideSeparated(WorldState& state, ThreadPool& threads, const Regions& regions, NarrowPhaseScratch& scratch,
                      float dt, bool newOnly) {
    const std::size_t chunks =
        regions.count() == 1 ? 1 : threads.chunkCount(state.separated.size(), kMinContactsPerChunk);
    clearLists(scratch.separated, chunks);
    const float fall = length(state.gravity) * dt * dt;
    threads.forEachChunk(state.separated.size(), chunks, [&](IndexRange range, std::size_t chunk) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const SeparatedContact& contact = state.separated[i];
            const bool isWanted = newOnly ? contact.apart == kNeverCollided : mayTouch(state, contact, fall);
            if (isWanted) collideAndStore(state, contact.contact, scratch.separated[chunk], dt);
        }
    });
}

/// Sorts all collisions by contact: colours must not depend on the lanes that contacts are in.
void sortCollisions(NarrowPhaseScratch& scratch) {
    scratch.all.clear();
    for (const auto* some : {&scratch.stale, &scratch.separated}) {
        for (const std::vector<ContactCollision>& collisions : *some) {
            for (const ContactCollision& one : collisions) scratch.all.push_back(&one);
        }
    }
    const auto isBefore = [](const ContactCollision* a, const ContactCollision* b) { return a->contact < b->contact; };
    if (!std::is_sorted(scratch.all.begin(), scratch.all.end(), isBefore)) {  // after insertions
        std::sort(scratch.all.begin(), scratch.all.end(), isBefore);
    }
}

/// The first body's centre relative to the second's, in world space, where the second hull is at `offset` in the
/// first's frame.
Vec3f sweptCentreOffset(const WorldState& state, const Contact& contact, Vec3f offset) {
    const Vec3f firstOffset = placedHullOf(state, state.proxies[contact.proxies[0]]).offset;
    const Vec3f secondOffset = placedHullOf(state, state.proxies[contact.proxies[1]]).offset;
    return state.poses[contact.bodies[0]].rotation.matrix() * (offset + firstOffset) * -1.0f +
           state.poses[contact.bodies[1]].rotation.matrix() * secondOffset;
}

}  // namespace

void storeManifold(WorldState& state, std::uint32_t number, const HullCollision& collision) {
    Contact& contact = state.contacts[number];
    ContactBlock& block = state.colours.block(contact.slot);
    ReferenceBlock& reference = state.colours.reference(contact.slot);
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    const BodyPose &first = state.poses[contact.bodies[0]], &second = state.poses[contact.bodies[1]];
    const Mat3f rotation = first.rotation.matrix();
    const Vec3f offset = placedHullOf(state, state.proxies[contact.proxies[0]]).offset;
    rotateFriction(block, lane, rotation * collision.manifold.normal);
    putPoints(contact, block, reference, lane, collision.manifold, rotation, offset);
    put(first.rotation, reference.firstRotation, lane);
    put(second.rotation, reference.secondRotation, lane);
    put(collision.isSwept ? sweptCentreOffset(state, contact, collision.offset) : first.centre - second.centre,
        reference.centreOffset, lane);
    reference.isSwept[lane] = collision.isSwept ? 1.0f : 0.0f;
    reference.slack[lane] = collision.isSwept ? -1.0f : maxSlack(state, contact);
    const Body &a = state.bodies[contact.bodies[0]], &b = state.bodies[contact.bodies[1]];
    block.stiffening[lane] = 1.0f / softDepth(state, contact);
    block.friction[lane] = std::sqrt(a.friction * b.friction);
    block.restitution[lane] = std::max(a.restitution, b.restitution);
    contact.axis = collision.axis;
}

void storeGap(WorldState& state, std::uint32_t number, const HullCollision& collision) {
    Contact& contact = state.contacts[number];
    SeparatedContact& separated = state.separated[contact.separatedIndex];
    contact.axis = collision.axis;
    separated.apart = kNeverCollided;
    if (collision.axis.separation <= 0.0f) return;
    const BodyPose &first = state.poses[contact.bodies[0]], &second = state.poses[contact.bodies[1]];
    separated.gapNormal = first.rotation.matrix() * collision.axis.normal;
    const float closing =
        std::max(kGapFraction * collision.axis.separation, collision.axis.separation - kSpeculativeDistance);
    separated.apart = dot(separated.gapNormal, second.centre - first.centre) - first.arc - second.arc - closing;
}

bool isApart(const WorldState& state, const Contact& contact) {
    const ContactBlock& block = state.colours.block(contact.slot);
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        if (block.points[i].separation[lane] <= 0.0f) return false;
    }
    return true;
}

void outdateManifold(WorldState& state, const Contact& contact) {
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    state.colours.reference(contact.slot).slack[lane] = -1.0f;
}

RelativePose relativePose(const BodyPose& first, Vec3f firstOffset, const BodyPose& second, Vec3f secondOffset) {
    const Mat3f rotation = first.rotation.matrix(), secondRotation = second.rotation.matrix();
    return {rotation.transposed() * secondRotation,
            rotation.transposedTimes(second.centre - first.centre + secondRotation * secondOffset) - firstOffset};
}

HullCollision collideContact(const WorldState& state, const Contact& contact, float dt) {
    const PlacedHull& firstPlaced = placedHullOf(state, state.proxies[contact.proxies[0]]);
    const PlacedHull& secondPlaced = placedHullOf(state, state.proxies[contact.proxies[1]]);
    const Hull &first = *firstPlaced.hull, &second = *secondPlaced.hull;
    const BodyPose &firstPose = state.poses[contact.bodies[0]], &secondPose = state.poses[contact.bodies[1]];
    const RelativePose pose = relativePose(firstPose, firstPlaced.offset, secondPose, secondPlaced.offset);
    const BodyMotion &a = state.motions[contact.bodies[0]], &b = state.motions[contact.bodies[1]];
    Vec3f velocity = b.velocity - a.velocity;
    if (firstPlaced.offset != Vec3f(0.0f) || secondPlaced.offset != Vec3f(0.0f))  // hulls of compounds only
        velocity = velocityOf(b, secondPose, secondPlaced) - velocityOf(a, firstPose, firstPlaced);
    const Vec3f displacement = velocity * dt;
    const float far = length(displacement), minWidth = std::min(first.minWidth, second.minWidth);
    const bool isFast = far > kSweptFraction * minWidth;
    const bool isSwept = state.isSwept(contact.bodies[0], contact.bodies[1]);
    const float swing =
        length(b.angularVelocity - a.angularVelocity) * dt * std::min(first.boundingRadius, second.boundingRadius);
    const float margin = kSpeculativeDistance + (isFast ? 0.0f : far) + swing;
    const Vec3f turn = firstPose.rotation.matrix().transposedTimes(b.angularVelocity - a.angularVelocity) * dt;
    HullCollision collision = collideHulls(first, second, pose, margin, contact.axis, turn);
    const Vec3f inFirst = firstPose.rotation.matrix().transposedTimes(displacement);
    // The manifold may be recycled until its bodies have moved that far.
    const Vec3f recycled = far > kMinSliding ? inFirst * ((far + kMaxSlack) / far) : Vec3f(0.0f);
    std::optional<SeparatingAxis> sliding;
    if (isSwept || !isFast) sliding = slidingAxis(collision.axis, first, second, pose, recycled);
    if (sliding) {
        slideAlong(collision, *sliding, first, second, pose, margin);
    } else if (isSwept && isFast && collision.axis.separation > margin && mayMeet(collision.axis, inFirst)) {
        sweep(collision, first, second, pose, inFirst);
    }
    const bool isSpinning = swing > kSpinFraction * std::min(first.boundingRadius, second.boundingRadius);
    if (isSpinning && !collision.isSwept) removeOutOfReach(state, contact, collision.manifold, firstPlaced.offset, dt);
    return collision;
}

int findManifolds(WorldState& state, ThreadPool& threads, const Regions& regions, NarrowPhaseScratch& scratch,
                  const SolverKernels& kernels, const SolverStep& step, bool newOnly) {
    for (std::vector<ContactCollision>& collisions : scratch.stale) collisions.clear();
    if (!newOnly) collideStale(state, threads, regions, scratch, kernels, step);
    collideSeparated(state, threads, regions, scratch, step.dt, newOnly);
    sortCollisions(scratch);
    for (const auto* collided : scratch.all) {
        const auto& [number, collision] = *collided;
        const bool touches = collision.manifold.count > 0, touched = state.contacts[number].slot.isSet();
        const auto points = static_cast<std::uint32_t>(collision.manifold.count);
        if (touches && touched) {
            moveLane(state, number, points);
        } else if (touches) {
            wakeBodies(state, number);
            beginTouching(state, number, points);
            storeManifold(state, number, collision);
        } else if (!touches) {
            if (touched) endTouching(state, number);
            storeGap(state, number, collision);
        }
    }
    return static_cast<int>(scratch.all.size());
}

}  // namespace rubble
