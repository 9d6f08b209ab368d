#pragma once

#include "core/base/Index.h"
#include "core/physics/broadphase/DynamicBoxTree.h"
#include "core/physics/broadphase/PairTable.h"
#include "core/physics/narrowphase/SeparatingAxis.h"
#include "core/physics/solver/BodyMotion.h"
#include "core/physics/solver/ContactColours.h"
#include "core/physics/state/BodyDefinition.h"
#include "core/physics/state/StepResults.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

inline constexpr float kNeverCollided = 1e30f;  // SeparatedContact::apart of a new contact
inline constexpr float kStands = 1e30f;         // WorldState::obstacleSizes of what does not fly

/// The data of a body other than its motion and pose. Body 0 is the placeholder in empty lanes.
struct Body {
    std::shared_ptr<const Shape> shape;  // null: the slot is free
    std::uint32_t generation = 0;
    BodyKind kind = BodyKind::Static;
    bool isAwake = false;                     // always false for static bodies
    bool isBullet = false;                    // it is swept against everything, however fast that moves
    float mass = 0.0f;                        // kg; 0 unless dynamic
    SymMat3f inertia;                         // kg·m², in the body's axes
    SymMat3f inverseInertia;                  // 0 unless dynamic
    Vec3f centreRemainder{0.0f, 0.0f, 0.0f};  // m: the rounding error of the pose's centre (compensated summation)
    Vec3f angularMomentum{0.0f, 0.0f, 0.0f};  // kg·m²/s about its centre, in world axes
    Vec3f referenceAngularVelocity{0.0f, 0.0f, 0.0f};  // rad/s: the one that it belongs to
    bool isFastRotating = false;                       // in this step: its angular momentum is kept
    bool isTouched = false;                            // in this step: impulses changed its angular velocity
    float friction = 0.0f;
    float restitution = 0.0f;
    float boxValidUntil = 0.0f;                // m: BodyPose::travel up to which its fat boxes are valid
    float restTime = 0.0f;                     // s: how long it has been at rest
    Vec3f restDisplacement{0.0f, 0.0f, 0.0f};  // m: of its centre meanwhile
    Vec3f restRotation{0.0f, 0.0f, 0.0f};      // rad, meanwhile, a small angle
    float stayTime = 0.0f;                     // s: how long it has stayed within about stayReach of one place
    float stayReach = 0.0f;                    // m: how far any of its points has been from there
    float stayPath = 0.0f;                     // m: the length of their path meanwhile
    Vec3f stayCentre{0.0f, 0.0f, 0.0f};        // m, and the rotation: its pose at the beginning of the stay
    Quatf stayRotation;
    std::uint32_t sleepingIsland = kNone;  // the island that it sleeps in
    std::uint32_t firstProxy = kNone;
    std::uint32_t firstContact = kNone;  // 2 * contact + side
    std::uint64_t tag = 0;

    bool isDynamic() const { return kind == BodyKind::Dynamic; }
};

/// A hull of a body in the broad phase.
struct Proxy {
    std::uint32_t body = kNone;  // kNone: the slot is free
    std::uint32_t hull = 0;
    std::uint32_t leaf = kNone;
    std::uint32_t next = kNone;  // next of the same body
};

/// Two proxies whose fat boxes overlap.
struct Contact {
    std::array<std::uint32_t, 2> proxies{kNone, kNone};  // first < second; kNone: the slot is free
    std::array<std::uint32_t, 2> bodies{};
    std::array<std::uint32_t, 2> next{kNone, kNone};  // 2 * contact + side, next of the same body
    std::array<std::uint32_t, 2> previous{kNone, kNone};
    ContactSlot slot;                         // set if it has a manifold and is awake
    std::uint32_t stored = kNone;             // index of its stored lane while it sleeps
    std::uint32_t separatedIndex = kNone;     // index in WorldState::separated
    SeparatingAxis axis;                      // of the last collision
    std::array<std::uint32_t, 4> features{};  // of the manifold's points
};

/// An awake contact without a manifold.
struct SeparatedContact {
    std::uint32_t contact = kNone;
    std::array<std::uint32_t, 2> bodies{};
    // m: how far apart the centres must be along the normal for the bodies not to touch, less both arcs.
    float apart = kNeverCollided;
    Vec3f gapNormal{0.0f, 1.0f, 0.0f};  // from the first body to the second, in world axes
};

/// Where a body is expected at the end of the coming step, if it accelerates no more than by gravity.
struct Prediction {
    Vec3f centre{0.0f, 0.0f, 0.0f};  // m: without gravity
    float arc = 0.0f;                // m: an upper bound of BodyPose::arc
};

/// Bodies that fell asleep together.
struct SleepingIsland {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> contacts;
};

/// The stored lanes of a sleeping contact.
struct StoredContact {
    StoredLane<ContactBlock> block{};
    StoredLane<ReferenceBlock> reference{};
};

/// Everything that the next step depends on.
struct WorldState {
    Vec3f gravity{0.0f, 0.0f, 0.0f};
    bool sleeping = true;

    std::vector<Body> bodies = std::vector<Body>(1);
    std::vector<BodyMotion> motions = std::vector<BodyMotion>(1);
    std::vector<BodyPose> poses = std::vector<BodyPose>(1);
    std::vector<float> predictedTravel =
        std::vector<float>(1);  // m: an upper bound of BodyPose::travel at the end of the coming step
    std::vector<Prediction> predictions = std::vector<Prediction>(1);  // as of the last findPairs()
    // m: the bounding radius of what flies: it moves far for its size in the coming step; kStands for all else.
    std::vector<float> obstacleSizes = std::vector<float>(1, kStands);
    std::size_t bouncyBodies = 0;    // bodies with restitution
    std::size_t compoundBodies = 0;  // bodies of several hulls
    std::vector<std::uint32_t> freeBodies;
    std::vector<std::uint32_t> awake;  // dynamic and kinematic, ascending; as of the last updateAwakeBodies()
    std::vector<std::uint32_t> woken;  // bodies that woke since, in any order
    bool hasRemovedAwake = false;      // whether an awake body was removed since

    std::vector<Proxy> proxies;
    std::vector<std::uint32_t> freeProxies;
    DynamicBoxTree tree;
    std::vector<std::uint32_t> rebox;  // bodies added, moved or pushed by the caller since the last collide()

    std::vector<Contact> contacts;
    std::vector<std::uint32_t> freeContacts;
    PairTable pairs;
    ContactColours colours;
    std::vector<SeparatedContact> separated;

    std::vector<SleepingIsland> sleepingIslands;
    std::vector<std::uint32_t> freeSleepingIslands;
    std::vector<StoredContact> stored;
    std::vector<std::uint32_t> freeStored;

    // The spring of World::grab().
    BodyId grabbed;
    Vec3f grabPoint{0.0f, 0.0f, 0.0f};   // in the body's axes, from its centre
    Vec3f grabTarget{0.0f, 0.0f, 0.0f};  // in the world
    float grabForce = 0.0f;              // N
    double grabWork = 0.0;               // J, of the step being solved

    StepEvents events;  // ended contacts are added as they end

    bool isAwake(const Contact& contact) const {
        return bodies[contact.bodies[0]].isAwake || bodies[contact.bodies[1]].isAwake;
    }
    bool isFlying(std::uint32_t body) const { return obstacleSizes[body] < kStands; }
    /// Whether the hulls of two bodies are swept: one stands, or is so much larger that the other could cross it.
    bool isSwept(std::uint32_t first, std::uint32_t second) const {
        return areSwept(obstacleSizes[first], obstacleSizes[second]);
    }
    static bool areSwept(float first, float second) {
        constexpr float kMuchLarger = 4.0f;
        return std::max(first, second) >= std::min(kStands, kMuchLarger * std::min(first, second));
    }
    BodyId idOf(std::uint32_t body) const { return {body, bodies[body].generation}; }
};

inline const PlacedHull& placedHullOf(const WorldState& state, const Proxy& proxy) {
    return state.bodies[proxy.body].shape->hulls[proxy.hull];
}
inline const Hull& hullOf(const WorldState& state, const Proxy& proxy) { return *placedHullOf(state, proxy).hull; }

struct Snapshot {
    WorldState state;
};

}  // namespace rubble
