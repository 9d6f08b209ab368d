#include "core/play/session/SavedSession.h"

#include "core/base/MessageText.h"
#include "core/physics/state/VerifyState.h"
#include "core/play/scene/PlayBodyShape.h"
#include "core/play/scene/Projectile.h"
#include "core/play/session/VerifySession.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

Error unusable(const std::string& what) {
    return {ErrorCode::BadInput, "The state cannot be used: " + what + "; save it again."};
}

std::map<AssetVariant, ContentHash> bakesOf(const PlayScene& scene) {
    std::map<AssetVariant, ContentHash> bakes;
    for (const auto& [variant, asset] : scene.assets) {
        bakes[variant] = damageHash(*findAsset(scene.project, variant.asset), *asset->bake);
    }
    return bakes;
}

Status checkBakes(const PlayScene& scene, const std::map<AssetVariant, ContentHash>& saved) {
    for (const auto& [variant, hash] : bakesOf(scene)) {
        const auto found = saved.find(variant);
        if (found != saved.end() && found->second == hash) continue;
        const std::string name = nameOfVariant(findAsset(scene.project, variant.asset)->name, variant.variant);
        return Error{ErrorCode::BadInput, "The state is of another bake of asset " + quotedName(name) + ", " +
                                              (found != saved.end() ? found->second.hex() : std::string("none")) +
                                              " instead of " + hash.hex() +
                                              "; use the version of Rubble that saved it."};
    }
    return success();
}

RestingWorld restingWorld(const SessionState& state, const WorldState& world) {
    RestingWorld resting{.gravity = world.gravity, .sleeping = world.sleeping};
    for (const PlayBody& body : state.bodies) {
        const BodyPose& pose = world.poses[body.body.index];
        resting.poses.push_back({pose.centre, pose.rotation});
    }
    return resting;
}

BodyKind kindOf(const PlayScene& scene, const SessionState& state, const PlayBody& body) {
    if (body.role == PlayRole::Ground || body.isHeld) return BodyKind::Static;
    if (body.role != PlayRole::Instance) return BodyKind::Dynamic;
    const Id id = state.origins[body.origin].instance;
    const bool isFixed = findInstance(scene.project, id)->isFixed && !scene.structures.contains(id);
    return isFixed ? BodyKind::Static : BodyKind::Dynamic;
}

std::shared_ptr<const Shape> shapeOf(const SessionState& state, const PlayBody& body) {
    if (body.asset) return shapeOf(body);
    if (body.role == PlayRole::Ground) return *makeShape({body.hull.get(), 1});
    return projectileBody(*state.origins[body.origin].thrown, nullptr, nullptr)->shape;
}

/// Lets the ground of a state that was saved when it ended 200 m from the origin reach as far as now.
void widenGround(WorldState& world, std::uint32_t index, const Shape& ground) {
    if (index >= world.poses.size() || !(world.poses[index].boundingRadius < ground.boundingRadius)) return;
    world.poses[index].boundingRadius = ground.boundingRadius;
    world.rebox.push_back(index);
}

/// Gives the bodies of a world their shapes. Returns the place of a body that is not one of the session's.
std::optional<std::string> addShapes(const PlayScene& scene, const SessionState& state, WorldState& world) {
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        const PlayBody& body = state.bodies[k];
        const std::string place = "bodies[" + std::to_string(k) + "].body";
        const std::uint32_t index = body.body.index;
        if (index == 0 || index >= world.bodies.size()) return place;
        Body& home = world.bodies[index];
        const bool isOwn = home.generation == body.body.generation && home.tag == body.number;
        if (!isOwn || home.shape != nullptr || home.kind != kindOf(scene, state, body)) return place;
        home.shape = shapeOf(state, body);
        if (body.role == PlayRole::Ground) widenGround(world, index, *home.shape);
    }
    return std::nullopt;
}

/// The definition of a resting body.
Result<BodyDefinition> restingBody(const SessionParts& parts, const PlayBody& body, const RestingPose& at) {
    BodyDefinition definition;
    const Ground& ground = parts.scene().project.ground;
    if (body.role == PlayRole::Ground) {
        definition.friction = ground.friction;
        definition.restitution = ground.restitution;
    } else if (body.asset) {
        const BodyMaterial material = bodyMaterial(parts, *body.asset, body.fragment, body.role);
        definition.density = material.density;
        definition.friction = material.friction;
        definition.restitution = material.restitution;
    } else {
        definition = *projectileBody(*parts.state().origins[body.origin].thrown, nullptr, nullptr);
        definition.velocity = Vec3(0.0);
    }
    definition.shape = shapeOf(parts.state(), body);
    definition.kind = kindOf(parts.scene(), parts.state(), body);
    const Quat rotation = glm::normalize(toDouble(at.rotation));
    definition.pose = {toDouble(at.centre) - rotation * definition.shape->mass.centre, rotation};
    definition.tag = body.number;
    definition.isBullet = body.role == PlayRole::Projectile;
    return definition;
}

/// The world of a small state: its bodies added anew, with the exact bits of their poses.
Result<WorldState> worldOf(const PlayScene& scene, const SessionSettings& settings, SessionState& state,
                           const RestingWorld& resting) {
    if (resting.poses.size() != state.bodies.size()) return unusable("world.poses are not one for each body");
    World world({.gravity = toDouble(resting.gravity), .sleeping = resting.sleeping});
    const SessionParts parts{scene, settings, state, world};
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        const Result<BodyDefinition> definition = restingBody(parts, state.bodies[k], resting.poses[k]);
        if (!definition) return definition.error();
        const Result<BodyId> added = world.addBody(*definition);
        if (!added) return unusable("world.poses[" + std::to_string(k) + "]: " + added.error().message);
        state.bodies[k].body = *added;
    }
    WorldState moved = world.snapshot()->state;
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
        const std::uint32_t index = state.bodies[k].body.index;
        BodyPose& pose = moved.poses[index];
        pose.centre = resting.poses[k].centre;
        pose.rotation = resting.poses[k].rotation;
        pose.inverseInertia = rotated(moved.bodies[index].inverseInertia, pose.rotation.matrix());
    }
    return moved;
}

/// Gives a session the saved moment, whose state is complete.
Status restoreSmall(Session& session, const SessionSettings& settings, SessionState state,
                    const RestingWorld& resting) {
    if (!std::ranges::all_of(std::array{resting.gravity.x, resting.gravity.y, resting.gravity.z},
                             [](float g) { return std::abs(g) <= static_cast<float>(kMaxSpeed); })) {
        return unusable("world.gravity is out of range");
    }
    Result<WorldState> world = worldOf(session.scene(), settings, state, resting);
    if (!world) return world.error();
    if (const auto fault = verifyState(*world)) return unusable("world." + *fault + " is wrong");
    session.restore({std::move(state), std::make_shared<const Snapshot>(Snapshot{std::move(*world)})});
    session.sleepInPlace();
    return success();
}

Status restoreWhole(Session& session, SessionState state, WorldState world, ContentHash hash) {
    if (const auto fault = addShapes(session.scene(), state, world)) return unusable(*fault + " is wrong");
    if (const auto fault = verifyState(world)) return unusable("world." + *fault + " is wrong");
    session.restore({std::move(state), std::make_shared<const Snapshot>(Snapshot{std::move(world)})});
    if (session.hash() != hash) {
        return unusable("its bodies have the hash " + session.hash().hex() + " instead of " + hash.hex());
    }
    return success();
}

}  // namespace

SavedSession savedSession(const Session& session, StateKind kind) {
    const std::shared_ptr<const SessionSnapshot> snapshot = session.snapshot();
    SavedSession saved{.dt = session.stepLength(), .bakes = bakesOf(session.scene()), .state = snapshot->state};
    saved.state.events = {};
    for (PlayBody& body : saved.state.bodies) {
        body.asset.reset();
        body.hull.reset();
    }
    for (StructureState& structure : saved.state.structures) {
        structure.structure.reset();
        structure.bodyOfNode.clear();
    }
    if (kind == StateKind::Whole) {
        saved.hash = session.hash();
        auto& world = saved.world.emplace<WorldState>(snapshot->world->state);
        world.events = {};
        for (Body& body : world.bodies) body.shape.reset();
        return saved;
    }
    saved.world = restingWorld(saved.state, snapshot->world->state);
    saved.state.pending.clear();
    for (PlayBody& body : saved.state.bodies) body.body = {};
    return saved;
}

Result<SavedSession> withBake(SavedSession saved, const Asset& variant, const Bake& bake) {
    for (const auto& [index, damage] : saved.state.damage) {
        if (index >= saved.state.origins.size() || saved.state.origins[index].asset != variant.id) continue;
        return Error{ErrorCode::BadInput, quotedName(saved.state.origins[index].name) +
                                              " is broken in the state, but variants need one in which asset " +
                                              quotedName(variant.name) + " is intact."};
    }
    std::erase_if(saved.bakes, [&](const auto& one) { return one.first.asset == variant.id; });
    saved.bakes[{variant.id}] = damageHash(variant, bake);
    for (PlayOrigin& origin : saved.state.origins) {
        if (origin.asset == variant.id) origin.variant = 0;
    }
    return saved;
}

Result<Session> resumedSession(std::shared_ptr<const PlayScene> scene, SavedSession saved, SessionSettings settings) {
    const auto* resting = std::get_if<RestingWorld>(&saved.world);
    settings.dt = saved.dt;
    settings.sleeping = resting != nullptr ? resting->sleeping : std::get<WorldState>(saved.world).sleeping;
    if (const Status checked = checkBakes(*scene, saved.bakes); !checked) return checked.error();
    if (const auto fault = completeState(*scene, saved.state)) return unusable(*fault);
    Result<Session> session = Session::start(std::move(scene), settings);
    if (!session) return session.error();
    const Status restored = resting != nullptr ? restoreSmall(*session, settings, std::move(saved.state), *resting)
                                               : restoreWhole(*session, std::move(saved.state),
                                                              std::move(std::get<WorldState>(saved.world)), saved.hash);
    if (!restored) return restored.error();
    return session;
}

}  // namespace rubble
