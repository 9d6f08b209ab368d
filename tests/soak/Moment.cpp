#include "tests/soak/Moment.h"

#include <algorithm>
#include <cstdio>

namespace rubble::soak {
namespace {

/// The mass and the centre of mass, in the world, of what is left of a held body.
void addNodes(BodyFacts& facts, double density) {
    const PlayBody& body = facts.body;
    Vec3 moment(0.0);
    double volume = 0.0;
    for (const std::uint32_t fragment : fragmentsOf(body)) {
        const PlaySolid& solid = body.asset->fragments[fragment];
        volume += solid.shape->mass.volume;
        moment += solid.shape->mass.volume * centreInAsset(solid);
    }
    facts.mass = density * volume;
    facts.massCentre = facts.state.pose.position + facts.state.pose.orientation * (moment / volume - frameOf(body));
}

/// The angular momentum about the centre of mass; `unit`: at density 1.
Vec3 spinOf(const BodyFacts& facts, const MassProperties& unit) {
    const Quat& orientation = facts.state.pose.orientation;
    const Vec3 turning = glm::conjugate(orientation) * facts.state.angularVelocity;
    return orientation * ((facts.mass / unit.volume) * unit.inertia * turning);
}

BodyFacts factsOf(const Session& session, const PlayBody& body, const Densities& densities) {
    const World& world = session.world();
    const Shape& shape = world.shape(body.body);
    BodyFacts facts{.body = body, .kind = world.kind(body.body), .state = world.state(body.body)};
    facts.mass = world.mass(body.body);
    facts.massCentre = facts.state.centre;
    facts.boundingRadius = shape.boundingRadius;
    facts.minWidth = shape.minWidth;
    facts.kinetic = kineticEnergy(world, body.body);
    facts.spin = spinOf(facts, shape.mass);
    if (facts.isDynamic() || body.asset == nullptr) return facts;
    const double density = densities.at(findAsset(session.scene().project, body.asset->bake->asset)->material);
    facts.mass = density * shape.mass.volume;
    if (isPartial(body)) addNodes(facts, density);
    return facts;
}

}  // namespace

const BodyFacts* Moment::find(std::uint32_t number) const {
    const auto found = std::ranges::lower_bound(bodies, number, {}, [](const auto& one) { return one.body.number; });
    return found != bodies.end() && found->body.number == number ? &*found : nullptr;
}

const BodyFacts* Moment::find(BodyId id) const {
    const auto found = std::ranges::find_if(bodies, [&](const auto& one) { return one.body.body == id; });
    return found != bodies.end() ? &*found : nullptr;
}

Densities densitiesOf(const Project& project) {
    Densities densities;
    for (const Material& material : project.materials) densities[material.id] = material.density;
    return densities;
}

Moment momentOf(const Session& session, const Densities& densities) {
    Moment moment{.gravity = session.world().gravity()};
    for (const PlayBody& body : session.bodies()) moment.bodies.push_back(factsOf(session, body, densities));
    return moment;
}

std::vector<ThrownBody> thrownBodies(const Session& session, const Densities& densities) {
    std::vector<ThrownBody> thrown;
    const PlayScene& scene = session.scene();
    const PlayEvents& events = session.events();
    for (const TimedInput& timed : events.inputs) {
        const auto* shot = std::get_if<ShotInput>(&timed.input);
        const Throw* const action = shot != nullptr ? std::get_if<Throw>(&shot->action) : nullptr;
        if (action == nullptr) continue;
        ThrownBody body{action->mass, action->from};
        if (action->kind == ProjectileKind::Asset) {
            const double density = densities.at(findAsset(scene.project, action->asset)->material);
            body.mass = density * scene.assets.at({action->asset})->whole.shape->mass.volume;
        }
        thrown.push_back(body);
    }
    return thrown;
}

std::string textOf(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string textOf(Vec3 value) { return "(" + textOf(value.x) + ", " + textOf(value.y) + ", " + textOf(value.z) + ")"; }

std::vector<std::unique_ptr<Invariant>> invariants() {
    std::vector<std::unique_ptr<Invariant>> all;
    for (const auto make : {finiteNumbers, uniqueNumbers, oneComponent, nothingLost, heldByAnchors, heldStays,
                            supportLost, staticOverlap, restingOverlap, nothingTunnels, energyGrowth, energyBalance,
                            energySums, freeMomentum, sleepsSupported, eventsTellAll}) {
        all.push_back(make());
    }
    return all;
}

}  // namespace rubble::soak
