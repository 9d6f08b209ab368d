#include "core/physics/world/Split.h"

#include "core/base/Assert.h"
#include "core/physics/islands/Rest.h"
#include "core/physics/islands/Sleeping.h"
#include "core/physics/queries/HullDistance.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/state/VerifyBody.h"
#include "core/physics/step/BroadPhase.h"
#include "core/physics/world/Bodies.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace rubble {
namespace {

/// A contact of the body that splits, taken out of the world while its body changes.
struct MovingContact {
    std::uint32_t contact = 0;
    std::uint32_t side = 0;  // of the body
    bool hasLane = false;
    StoredContact lane;
};

/// The body that splits, as it was.
struct SplittingBody {
    std::uint32_t number = 0;
    Pose pose;
    Vec3 centre{0.0, 0.0, 0.0};  // m, of mass, in the shape's frame
    Quatf rotation;
    std::shared_ptr<const Shape> shape;
    BodyKind kind = BodyKind::Dynamic;
    float mass = 0.0f;                       // kg; 0: it is fixed
    std::vector<std::uint32_t> proxyOfHull;  // kNone: a part has it
    std::size_t proxies = 0;                 // those that no part has
};

SplittingBody splittingBody(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    SplittingBody splitting{.number = number,
                            .pose = poseOf(state, number),
                            .centre = body.shape->mass.centre,
                            .rotation = state.poses[number].rotation,
                            .shape = body.shape,
                            .kind = body.kind,
                            .mass = body.mass,
                            .proxies = body.shape->hulls.size()};
    splitting.proxyOfHull.resize(splitting.proxies);
    const std::span<const Proxy> proxies = state.proxies;
    const std::span<std::uint32_t> proxyOfHull = splitting.proxyOfHull;
    for (std::uint32_t proxy = body.firstProxy; proxy != kNone; proxy = proxies[proxy].next) {
        proxyOfHull[proxies[proxy].hull] = proxy;
    }
    return splitting;
}

/// Whether the body is fixed and remains so: nothing changes for the contacts of the hulls that it keeps.
bool isHeld(const SplittingBody& body, std::span<const SplitPart> parts) {
    return body.kind == BodyKind::Static && parts[0].kind == BodyKind::Static;
}

/// Where the centre of mass of a part was in the body, m, in its axes, from the body's own.
Vec3 centreIn(const SplittingBody& body, const SplitPart& part) {
    return part.offset + part.shape->mass.centre - body.centre;
}

/// Gives the body that splits the shape and motion of the part that keeps its number.
void becomePart(WorldState& state, const SplittingBody& splitting, const SplitPart& part) {
    const std::uint32_t number = splitting.number;
    Body& body = state.bodies[number];
    BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    if (body.shape->hulls.size() > 1) --state.compoundBodies;
    if (part.shape->hulls.size() > 1) ++state.compoundBodies;
    body.shape = part.shape;
    body.tag = part.tag;
    const Vec3 moved = centreIn(splitting, part);
    if (moved != Vec3(0.0)) {
        pose.centre = toFloat(toDouble(pose.centre) + glm::normalize(toDouble(pose.rotation)) * moved);
        body.centreRemainder = Vec3f(0.0f);
    }
    pose.boundingRadius = part.shape->boundingRadius;
    if (body.kind != part.kind) {
        RUBBLE_ASSERT(body.kind == BodyKind::Static && part.kind == BodyKind::Dynamic);
        body.kind = part.kind;
        state.rebox.push_back(number);  // two static bodies have no contact
    }
    setMaterial(state, number, part.material);
    if (body.isDynamic()) {
        motion.velocity = toFloat(part.velocity);
        motion.angularVelocity = toFloat(part.angularVelocity);
        restartRest(state, number);
    }
}

/// The body of a part, at the origin. It does not own the shape, which the part does: counting owners is atomic, and
/// slow for many parts.
BodyDefinition definitionOf(const SplitPart& part) {
    return {.shape = {std::shared_ptr<const Shape>(), part.shape.get()},
            .kind = part.kind,
            .velocity = part.velocity,
            .angularVelocity = part.angularVelocity,
            .density = part.material.density,
            .friction = part.material.friction,
            .restitution = part.material.restitution,
            .tag = part.tag};
}

/// Adds the body of another part, without proxies.
std::uint32_t addPart(WorldState& state, const SplittingBody& splitting, const SplitPart& part) {
    const std::uint32_t number = addUnplacedBody(state, definitionOf(part));
    state.bodies[number].shape = part.shape;
    BodyPose& pose = state.poses[number];
    pose.centre =
        toFloat(splitting.pose.position + splitting.pose.orientation * (part.offset + part.shape->mass.centre));
    pose.rotation = splitting.rotation;
    pose.inverseInertia = rotated(state.bodies[number].inverseInertia, pose.rotation.matrix());
    state.rebox.push_back(number);
    return number;
}

/// Takes contacts of the body out of the colours and lists: all, or, if it is held, those of the hulls that it loses.
std::vector<MovingContact> takeContacts(WorldState& state, const SplittingBody& splitting,
                                        std::span<const SplitPart> parts) {
    std::vector<bool> isLost;  // by proxy
    if (isHeld(splitting, parts)) {
        isLost.assign(state.proxies.size(), false);
        for (const SplitPart& part : parts.subspan(1)) {
            for (const std::uint32_t hull : part.hulls) {
                if (hull != kNone) isLost[splitting.proxyOfHull[hull]] = true;
            }
        }
    }
    std::vector<std::uint32_t> numbers;
    visitContacts(state, splitting.number, [&](std::uint32_t number, std::uint32_t) {
        const Contact& contact = state.contacts[number];
        const std::size_t side = contact.bodies[0] == splitting.number ? 0 : 1;
        if (isLost.empty() || isLost[contact.proxies[side]]) numbers.push_back(number);
    });
    std::ranges::sort(numbers);
    std::vector<MovingContact> taken(numbers.size());  // large ones, which are not moved around
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        taken[k].contact = numbers[k];
        taken[k].side = state.contacts[numbers[k]].bodies[0] == splitting.number ? 0 : 1;
    }
    for (MovingContact& moving : taken) {
        Contact& contact = state.contacts[moving.contact];
        if (contact.stored != kNone) wakeBodies(state, moving.contact);
        moving.hasLane = contact.slot.isSet();
        if (moving.hasLane) moving.lane = takeLane(state, moving.contact);
        unlinkContact(state, moving.contact, moving.side);
    }
    return taken;
}

/// Where the rows of a block at an offset in bytes are in a stored lane.
constexpr std::size_t wordOf(std::size_t offset) { return offset / sizeof(IndexRow); }

float floatAt(std::span<const std::uint32_t> words, std::size_t word) { return std::bit_cast<float>(words[word]); }
void setFloat(std::span<std::uint32_t> words, std::size_t word, float value) {
    words[word] = std::bit_cast<std::uint32_t>(value);
}

/// Adds to a vector of a stored lane, whose x is the word `first`.
void addToVector(std::span<std::uint32_t> words, std::size_t first, Vec3f v) {
    setFloat(words, first, floatAt(words, first) + v.x);
    setFloat(words, first + 1, floatAt(words, first + 1) + v.y);
    setFloat(words, first + 2, floatAt(words, first + 2) + v.z);
}

constexpr std::size_t kPoints = std::tuple_size_v<decltype(ContactBlock::points)>;
constexpr std::size_t wordOfPoint(std::size_t point, std::size_t offset) {
    return wordOf(offsetof(ContactBlock, points) + point * sizeof(PointRows) + offset);
}

/// Scales the impulses of a contact to a part by its mass: warm starting changes the velocity of the part as that of
/// the whole. What holds or stops the whole would throw the part.
void scaleImpulses(StoredContact& stored, float factor) {
    const auto scale = [&](std::size_t word) { setFloat(stored.block, word, floatAt(stored.block, word) * factor); };
    for (std::size_t point = 0; point < kPoints; ++point) scale(wordOfPoint(point, offsetof(PointRows, impulse)));
    scale(wordOf(offsetof(ContactBlock, frictionX)));
    scale(wordOf(offsetof(ContactBlock, frictionY)));
    scale(wordOf(offsetof(ContactBlock, torsionalImpulse)));
}

/// Expresses a lane from a body's new centre of mass, which moved by `moved`, m, in the body's axes.
void shiftLane(StoredContact& stored, std::uint32_t side, Vec3f moved) {
    constexpr std::size_t kFirst = wordOf(offsetof(ReferenceBlock, firstRotation));
    constexpr std::size_t kSecond = wordOf(offsetof(ReferenceBlock, secondRotation));
    const auto rotation = [&](std::size_t k) { return floatAt(stored.reference, (side == 0 ? kFirst : kSecond) + k); };
    const Vec3f shift = Quatf{rotation(0), rotation(1), rotation(2), rotation(3)}.matrix() * moved;
    addToVector(stored.reference, wordOf(offsetof(ReferenceBlock, centreOffset)), side == 0 ? shift : shift * -1.0f);
    if (side != 0) return;
    for (std::size_t point = 0; point < kPoints; ++point)
        addToVector(stored.block, wordOfPoint(point, offsetof(PointRows, position)), shift * -1.0f);
}

/// Puts a contact back, at the body that its proxy belongs to now.
void returnContact(WorldState& state, const SplittingBody& splitting, MovingContact& moving) {
    Contact& contact = state.contacts[moving.contact];
    const std::uint32_t body = state.proxies[contact.proxies[moving.side]].body;
    contact.bodies[moving.side] = body;
    linkContact(state, moving.contact, moving.side);
    if (!moving.hasLane) {
        // Its gap was measured by the travel of the body that it had: it is collided again.
        removeSeparated(state, moving.contact);
        if (state.isAwake(contact)) addSeparated(state, moving.contact);
        return;
    }
    const Vec3 centre = toDouble(state.poses[body].centre) - splitting.pose.position;
    const Vec3f moved = toFloat(glm::conjugate(splitting.pose.orientation) * centre - splitting.centre);
    shiftLane(moving.lane, moving.side, moved);
    if (splitting.mass > 0.0f) scaleImpulses(moving.lane, state.bodies[body].mass / splitting.mass);
    returnLane(state, moving.contact, moving.lane);
    wakeBodies(state, moving.contact);
}

/// Gives the hulls of a part their proxies: those that they had, or new ones. True if any is new.
bool assignProxies(WorldState& state, SplittingBody& splitting, const SplitPart& part, std::uint32_t body) {
    RUBBLE_ASSERT(part.hulls.size() == part.shape->hulls.size());
    bool isAnyNew = false;
    std::uint32_t next = kNone;  // the first in the list of the body so far
    std::span<Proxy> proxies = state.proxies;
    const std::span<std::uint32_t> proxyOfHull = splitting.proxyOfHull;
    const std::span<const std::uint32_t> hulls = part.hulls;
    for (auto hull = static_cast<std::uint32_t>(hulls.size()); hull-- > 0;) {
        const std::uint32_t before = hulls[hull];
        const std::uint32_t number = before == kNone ? kNone : proxyOfHull[before];
        if (number != kNone) {
            Proxy& proxy = proxies[number];
            proxy.body = body;
            proxy.hull = hull;
            proxy.next = std::exchange(next, number);
            proxyOfHull[before] = kNone;
            --splitting.proxies;
        } else {
            isAnyNew = true;
            state.bodies[body].firstProxy = next;
            linkProxy(state, body, hull);
            next = state.bodies[body].firstProxy;
            proxies = state.proxies;
        }
    }
    state.bodies[body].firstProxy = next;
    return isAnyNew;
}

/// Removes the proxies that no part has, with their contacts.
void removeUnused(WorldState& state, const SplittingBody& splitting) {
    if (splitting.proxies == 0) return;
    std::vector<bool> isUnused(state.proxies.size(), false);
    for (const std::uint32_t proxy : splitting.proxyOfHull) {
        if (proxy != kNone) isUnused[proxy] = true;
    }
    visitContacts(state, splitting.number, [&](std::uint32_t number, std::uint32_t) {
        const Contact& contact = state.contacts[number];
        if (!isUnused[contact.proxies[0]] && !isUnused[contact.proxies[1]]) return;
        if (contact.slot.isSet() || contact.stored != kNone) wakeBodies(state, number);
        removeContact(state, number);
    });
    for (const std::uint32_t proxy : splitting.proxyOfHull) {
        if (proxy != kNone) removeProxy(state, proxy);
    }
}

/// The spring of World::grab() holds the hull that is nearest to its point.
void moveGrab(WorldState& state, const SplittingBody& splitting, std::span<const std::uint32_t> bodies) {
    if (state.grabbed.index != splitting.number) return;
    const Vec3 inShape = toDouble(state.grabPoint) + splitting.centre;
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t number : bodies) {
        const Vec3 centre = toDouble(state.poses[number].centre) - splitting.pose.position;
        const Vec3 local = inShape - glm::conjugate(splitting.pose.orientation) * centre;
        for (const PlacedHull& placed : state.bodies[number].shape->hulls) {
            const double distance = distanceTo(*placed.hull, local - toDouble(placed.offset));
            if (distance >= least) continue;
            least = distance;
            state.grabbed = state.idOf(number);
            state.grabPoint = toFloat(local);
        }
    }
    if (!state.bodies[state.grabbed.index].isDynamic()) state.grabbed = {};
}

}  // namespace

std::optional<std::string> verifyPart(const SplitPart& part) { return verifyBodyDefinition(definitionOf(part)); }

std::vector<std::uint32_t> splitBody(WorldState& state, std::uint32_t number, std::span<const SplitPart> parts) {
    RUBBLE_ASSERT(!parts.empty());
    wakeBody(state, number);
    SplittingBody splitting = splittingBody(state, number);
    RUBBLE_ASSERT(!isHeld(splitting, parts) || centreIn(splitting, parts[0]) == Vec3(0.0));
    if (!isHeld(splitting, parts)) wakeNeighbours(state, number);
    std::vector<MovingContact> contacts = takeContacts(state, splitting, parts);
    std::vector<std::uint32_t> bodies{number};
    bodies.reserve(parts.size());
    for (const SplitPart& part : parts.subspan(1)) bodies.push_back(addPart(state, splitting, part));
    becomePart(state, splitting, parts[0]);
    wakeBody(state, number);
    state.bodies[number].firstProxy = kNone;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (assignProxies(state, splitting, parts[k], bodies[k]) && k == 0) state.rebox.push_back(number);
    }
    for (MovingContact& moving : contacts) returnContact(state, splitting, moving);
    removeUnused(state, splitting);
    moveGrab(state, splitting, bodies);
    return bodies;
}

}  // namespace rubble
