#pragma once

#include "core/base/Index.h"
#include "core/physics/BodyRows.h"
#include "core/physics/BoxTree.h"
#include "core/physics/ContactColours.h"
#include "core/physics/PairTable.h"
#include "core/physics/SeparatingAxis.h"
#include "core/physics/World.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

inline constexpr float kNeverLooked = -1e30f;  // OpenContact::lookAt of a new one

/// What a body is, beside its rows; number 0 is the nobody in empty lanes.
struct Body {
    std::shared_ptr<const Shape> shape;  // none: the place is free
    std::uint32_t generation = 0;
    BodyKind kind = BodyKind::Static;
    bool isAwake = false;                // always false for static bodies
    float mass = 0.0f;                   // kg; 0 unless dynamic
    SymMat3f inertia;                    // kg m^2, in the body's axes
    SymMat3f inverseInertia;             // 0 unless dynamic
    Vec3f centreRest{0.0f, 0.0f, 0.0f};  // m: what rounding left out of the place's centre
    Vec3f momentum{0.0f, 0.0f, 0.0f};    // kg m^2/s about its centre, in world axes, as it was with spinThen
    Vec3f spinThen{0.0f, 0.0f, 0.0f};    // rad/s
    float friction = 0.0f;
    float restitution = 0.0f;
    float boxedUntil = 0.0f;         // m: its fat boxes hold until it has travelled that far
    float restTime = 0.0f;           // s: how long it has hardly moved
    std::uint32_t sleepers = kNone;  // the island it sleeps in
    std::uint32_t firstProxy = kNone;
    std::uint32_t firstContact = kNone;  // 2 * contact + side
    std::uint64_t tag = 0;

    bool isDynamic() const { return kind == BodyKind::Dynamic; }
};

/// A hull of a body in the tree.
struct Proxy {
    std::uint32_t body = kNone;  // kNone: the place is free
    std::uint32_t hull = 0;
    std::uint32_t leaf = BoxTree::kNone;
    std::uint32_t next = kNone;  // of the same body
};

/// Two proxies whose fat boxes overlap.
struct Contact {
    std::array<std::uint32_t, 2> proxies{kNone, kNone};  // first < second; kNone: the place is free
    std::array<std::uint32_t, 2> bodies{};
    std::array<std::uint32_t, 2> next{kNone, kNone};  // 2 * contact + side, of the same body
    std::array<std::uint32_t, 2> previous{kNone, kNone};
    ContactSlot slot;                         // set where it has a manifold and is awake
    std::uint32_t stored = kNone;             // its lane while it sleeps
    std::uint32_t openIndex = kNone;          // its place in WorldState::open
    SeparatingAxis axis;                      // the last
    std::array<std::uint32_t, 4> features{};  // of the manifold's points
};

/// An awake contact without manifold.
struct OpenContact {
    std::uint32_t contact = kNone;
    std::array<std::uint32_t, 2> bodies{};
    float lookAt = kNeverLooked;  // m: they cannot touch before both together have travelled that far
};

/// Bodies that came to rest together.
struct Sleepers {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> contacts;
};

/// The lanes of a sleeping contact.
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
    std::vector<BodyPlace> places = std::vector<BodyPlace>(1);
    std::vector<float> ahead = std::vector<float>(1);  // m: what BodyPlace::travel can be when the coming step ends
    std::size_t bouncyBodies = 0;                      // of restitution
    std::vector<std::uint32_t> freeBodies;
    std::vector<std::uint32_t> awake;  // dynamic and kinematic, ascending

    std::vector<Proxy> proxies;
    std::vector<std::uint32_t> freeProxies;
    BoxTree tree;
    std::vector<std::uint32_t> rebox;  // bodies put in or moved since the last collide()

    std::vector<Contact> contacts;
    std::vector<std::uint32_t> freeContacts;
    PairTable pairs;
    ContactColours colours;
    std::vector<OpenContact> open;

    std::vector<Sleepers> sleepers;
    std::vector<std::uint32_t> freeSleepers;
    std::vector<StoredContact> stored;
    std::vector<std::uint32_t> freeStored;

    // The spring of grab().
    BodyId grabbed;
    Vec3f grabPlace{0.0f, 0.0f, 0.0f};   // in the body's axes, from its centre
    Vec3f grabTarget{0.0f, 0.0f, 0.0f};  // in the world
    float grabForce = 0.0f;              // N

    StepEvents events;  // contacts that end are told when they do

    bool isAwake(const Contact& contact) const {
        return bodies[contact.bodies[0]].isAwake || bodies[contact.bodies[1]].isAwake;
    }
    BodyId idOf(std::uint32_t body) const { return {body, bodies[body].generation}; }
};

inline const Hull& hullOf(const WorldState& state, const Proxy& proxy) {
    return state.bodies[proxy.body].shape->hulls[proxy.hull];
}

struct Snapshot {
    WorldState state;
};

}  // namespace rubble
