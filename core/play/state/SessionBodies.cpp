#include "core/play/state/SessionBodies.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/physics/queries/HullDistance.h"
#include "core/play/scene/GroundHull.h"

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

constexpr double kFallDepth = 100.0;   // m below everything placed: bodies below it are removed
constexpr double kThesisMass = 100.0;  // kg per fragment: listing 8 of the thesis

Status placeGround(SessionParts& parts) {
    const Ground& ground = parts.scene().project.ground;
    if (!ground.isOn) return success();
    parts.state().origins.push_back({.name = "ground"});
    const std::shared_ptr<const Polytope> box = groundHull();
    const Result<std::shared_ptr<const Shape>> shape = makeShape({box.get(), 1});
    RUBBLE_ASSERT(shape.hasValue());
    const Result<std::uint32_t> added = addBody(parts,
                                                {.shape = *shape,
                                                 .kind = BodyKind::Static,
                                                 .pose = {.position = {0.0, ground.height, 0.0}},
                                                 .friction = ground.friction,
                                                 .restitution = ground.restitution},
                                                {.role = PlayRole::Ground, .hull = box});
    return added ? success() : Status(added.error());
}

Status placeInstance(SessionParts& parts, const Instance& instance) {
    SessionState& state = parts.state();
    const std::shared_ptr<const PlayAsset>& asset = parts.scene().assets.at(variantOf(instance));
    const BodyMaterial material = bodyMaterial(parts, *asset, kNone, PlayRole::Instance);
    const auto origin = static_cast<std::uint32_t>(state.origins.size());
    state.origins.push_back({instance.name, instance.id, instance.asset, instance.variant});
    if (instance.threshold) state.instanceThresholds[instance.id] = *instance.threshold;
    state.lowest = std::min(state.lowest, instance.pose.position.y - kFallDepth);
    const auto structure = parts.scene().structures.find(instance.id);
    const bool isBonded = structure != parts.scene().structures.end();
    const bool isHeld = isBonded && structure->second->isHeld();
    const Result<std::uint32_t> added =
        addBody(parts,
                {.shape = asset->whole.shape,
                 .kind = isHeld || (instance.isFixed && !isBonded) ? BodyKind::Static : BodyKind::Dynamic,
                 .pose = {instance.pose.position, glm::normalize(instance.pose.orientation)},
                 .density = material.density,
                 .friction = material.friction,
                 .restitution = material.restitution},
                {.role = PlayRole::Instance,
                 .origin = origin,
                 .asset = asset,
                 .isUnbreakable = instance.isUnbreakable,
                 .isHeld = isHeld});
    if (!added)
        return Error{added.error().code, "Instance " + quotedName(instance.name) + ": " + added.error().message};
    return success();
}

/// The body with a number, of `bodies`, const or not; null if it is gone.
template <class Bodies>
auto bodyIn(Bodies& bodies, std::uint32_t number) -> decltype(bodies.data()) {
    // Were no body gone, it would be as far from the first as their numbers are apart: it is there, or not far before.
    if (bodies.empty() || number < bodies.front().number) return nullptr;
    std::size_t end = std::min<std::size_t>(bodies.size(), number - bodies.front().number + std::size_t{1});
    std::size_t step = 1;
    while (end > step && bodies[end - step].number > number) {
        end -= step;
        step *= 2;
    }
    const auto begin = bodies.begin() + static_cast<std::ptrdiff_t>(end > step ? end - step : 0);
    const auto last = bodies.begin() + static_cast<std::ptrdiff_t>(end);
    const auto found = std::ranges::lower_bound(begin, last, number, {}, &PlayBody::number);
    return found != last && found->number == number ? &*found : nullptr;
}

}  // namespace

const Material& materialOf(const SessionState& state, const PlayScene& scene, Id asset) {
    const Id material = findAsset(scene.project, asset)->material;
    return *std::ranges::lower_bound(state.materials, material, {}, &Material::id);
}

BodyMaterial bodyMaterial(const SessionParts& parts, const PlayAsset& asset, std::uint32_t fragment, PlayRole role) {
    const Material& material = materialOf(parts.state(), parts.scene(), asset.bake->asset);
    BodyMaterial made{material.density, material.friction, material.restitution};
    if (parts.scene().project.damage.isThesis && role == PlayRole::Debris) {
        made.density = kThesisMass / asset.solid(fragment).shape->mass.volume;
    }
    return made;
}

double thresholdOf(const SessionState& state, const PlayScene& scene, const PlayBody& body) {
    if (body.fracture() == nullptr) return std::numeric_limits<double>::infinity();
    const Damage& damage = scene.project.damage;
    if (damage.isThesis) return damage.thesisThreshold;
    const PlayOrigin& origin = state.origins[body.origin];
    const auto own = state.instanceThresholds.find(origin.instance);
    const double whole = own != state.instanceThresholds.end() ? own->second : state.assetThresholds.at(origin.asset);
    return thresholdOf(body.asset->solid(body.fragment), whole);
}

const PlayBody* findBody(const SessionState& state, std::uint32_t number) { return bodyIn(state.bodies, number); }
PlayBody* findBody(SessionState& state, std::uint32_t number) { return bodyIn(state.bodies, number); }

double distanceToBody(const World& world, BodyId body, Vec3 point) {
    const BodyState state = world.state(body);
    const Vec3 local = glm::conjugate(state.pose.orientation) * (point - state.centre);
    double least = std::numeric_limits<double>::infinity();
    for (const PlacedHull& placed : world.shape(body).hulls) {
        least = std::min(least, distanceTo(*placed.hull, local - toDouble(placed.offset)));
    }
    return least;
}

double heldPotential(const PlayScene& scene, const SessionState& state, const World& world) {
    double potential = 0.0;
    for (const PlayBody& body : state.bodies) {
        if (!body.isHeld) continue;
        const Pose pose = world.state(body.body).pose;
        const Vec3 frame = frameOf(body);
        double volume = 0.0;
        Vec3 moment(0.0);  // of volume
        const auto add = [&](const MassProperties& mass, Vec3 centre) {
            volume += mass.volume;
            moment += mass.volume * (pose.position + pose.orientation * (centre - frame));
        };
        for (const std::uint32_t fragment : fragmentsOf(body)) {
            const PlaySolid& solid = body.asset->fragments[fragment];
            add(solid.shape->mass, centreInAsset(solid));
        }
        const PlaySolid& whole = body.asset->solid(body.fragment);
        if (volume == 0.0) add(whole.shape->mass, centreInAsset(whole));
        const double density = materialOf(state, scene, body.asset->bake->asset).density;
        potential -= density * glm::dot(world.gravity(), moment);
    }
    return potential;
}

Result<std::uint32_t> addBody(SessionParts& parts, BodyDefinition definition, PlayBody body) {
    SessionState& state = parts.state();
    definition.tag = state.nextNumber;
    const Result<BodyId> id = parts.world().addBody(definition);
    if (!id) return id.error();
    body.number = state.nextNumber++;
    body.body = *id;
    body.born = state.step;
    if (body.role == PlayRole::Instance) body.restCentre = parts.world().state(*id).centre;
    state.bodies.push_back(std::move(body));
    return state.bodies.back().number;
}

PlayRemoval removalOf(const SessionParts& parts, const PlayBody& body, RemovalReason reason) {
    const BodyState state = parts.world().state(body.body);
    return {.body = body,
            .reason = reason,
            .state = state,
            .centre = state.centre,
            .mass = parts.world().mass(body.body),
            .box = parts.world().box(body.body)};
}

void removeFromWorld(SessionParts& parts, std::uint32_t number) {
    PlayBody* body = findBody(parts.state(), number);
    RUBBLE_ASSERT(body != nullptr);
    parts.world().removeBody(body->body);
    body->body = {};
}

std::size_t eraseRemovedBodies(SessionState& state) {
    const std::size_t visited = state.bodies.size();
    std::erase_if(state.bodies, [](const PlayBody& body) { return body.body.index == 0; });
    return visited;
}

Status placeScene(SessionParts& parts) {
    SessionState& state = parts.state();
    const Project& project = parts.scene().project;
    state.materials = project.materials;
    for (const Asset& asset : project.assets) state.assetThresholds[asset.id] = thresholdOf(project, asset);
    state.lowest = project.ground.height - kFallDepth;
    if (const Status placed = placeGround(parts); !placed) return placed.error();
    for (const Instance& instance : project.instances) {
        if (const Status placed = placeInstance(parts, instance); !placed) return placed.error();
    }
    return success();
}

}  // namespace rubble
