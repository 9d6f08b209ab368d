#include "core/physics/world/BodyScene.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/physics/state/VerifyBody.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

std::string ownerText(const SceneBody& body) { return "Body " + quotedName(body.name); }

std::string rangeSentence(const char* what, double value, const std::string& range) {
    return std::string("the ") + what + " is " + messageText(value) + ", but it must be " + range + ".";
}

Sentence rangeFault(const char* what, double value, double min, double max) {
    if (value >= min && value <= max) return std::nullopt;
    return rangeSentence(what, value, "from " + messageText(min) + " to " + messageText(max));
}

Sentence densityFault(const SceneBody& body) {
    const bool isDynamic = body.kind == BodyKind::Dynamic;
    const bool isEnough = isDynamic ? body.density > 0.0 : body.density >= 0.0;
    if (isEnough && body.density <= kMaxDensity) return std::nullopt;
    return rangeSentence("density", body.density,
                         (isDynamic ? "above 0 and at most " : "from 0 to ") + messageText(kMaxDensity));
}

/// A vector that is not finite or longer than `most`.
Sentence vectorFault(const char* what, Vec3 value, double most) {
    if (glm::length(value) <= most) return std::nullopt;
    return std::string("the ") + what + " is (" + messageText(value.x) + ", " + messageText(value.y) + ", " +
           messageText(value.z) + "), but its length must be at most " + messageText(most) + ".";
}

Sentence orientationFault(const Quat& orientation) {
    const double length = glm::length(orientation);
    if (std::abs(length - 1.0) <= kUnitTolerance) return std::nullopt;
    return rangeSentence("length of the orientation", length, "1");
}

Sentence valueFault(const SceneBody& body) {
    if (Sentence fault = densityFault(body)) return fault;
    if (Sentence fault = rangeFault("friction", body.friction, 0.0, kMaxFriction)) return fault;
    if (Sentence fault = rangeFault("restitution", body.restitution, 0.0, 1.0)) return fault;
    if (Sentence fault = vectorFault("position", body.pose.position, kMaxCoordinate)) return fault;
    if (Sentence fault = orientationFault(body.pose.orientation)) return fault;
    if (Sentence fault = vectorFault("velocity", body.velocity, kMaxSpeed)) return fault;
    return vectorFault("angular velocity", body.angularVelocity, kMaxSpeed);
}

Sentence hullFault(const Polytope& hull) {
    if (Sentence fault = verifyPolytope(hull)) return fault;
    for (const Vec3& vertex : hull.vertices) {
        if (Sentence fault = vectorFault("position of a corner", vertex, kMaxCoordinate)) return fault;
    }
    return std::nullopt;
}

Sentence shapeFault(const std::vector<Polytope>& hulls) {
    if (hulls.empty()) return "it has no hulls.";
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        if (const Sentence fault = hullFault(hulls[k])) return "hull " + std::to_string(k) + ": " + *fault;
    }
    return std::nullopt;
}

/// Checks every shape used by a body; names the first such body.
Sentence shapeFault(const BodyScene& scene) {
    std::vector<bool> isChecked(scene.shapes.size(), false);
    for (const SceneBody& body : scene.bodies) {
        if (body.shape >= scene.shapes.size())
            return ownerText(body) + ": there is no shape " + std::to_string(body.shape) + ".";
        if (isChecked[body.shape]) continue;
        if (const Sentence fault = shapeFault(scene.shapes[body.shape])) return ownerText(body) + ": " + *fault;
        isChecked[body.shape] = true;
    }
    return std::nullopt;
}

Sentence nameFault(const std::vector<SceneBody>& bodies) {
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bodies[a].name < bodies[b].name; });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::string& name = bodies[order[k]].name;
        if (name.empty()) return "Body " + std::to_string(order[k]) + " has no name.";
        if (k > 0 && name == bodies[order[k - 1]].name) {
            return "Two bodies have the name " + quotedName(name) + ": numbers " + std::to_string(order[k - 1]) +
                   " and " + std::to_string(order[k]) + ", counted from 0.";
        }
    }
    return std::nullopt;
}

Error withOwner(const SceneBody& body, const Error& error) {
    return {error.code, ownerText(body) + ": " + error.message};
}

Result<BodyId> addTo(World& world, const SceneBody& body, const std::shared_ptr<const Shape>& shape) {
    const bool isDynamic = body.kind == BodyKind::Dynamic;
    if (isDynamic) {
        const Sentence fault = rangeFault("mass", shape->mass.volume * body.density, kMinBodyMass, kMaxBodyMass);
        if (fault) return Error{ErrorCode::BadInput, *fault};
    }
    return world.addBody({.shape = shape,
                          .kind = body.kind,
                          .pose = {body.pose.position, glm::normalize(body.pose.orientation)},
                          .velocity = body.velocity,
                          .angularVelocity = body.angularVelocity,
                          .density = isDynamic ? body.density : BodyDefinition{}.density,
                          .friction = body.friction,
                          .restitution = body.restitution});
}

}  // namespace

Sentence verifyBodyScene(const BodyScene& scene) {
    if (Sentence fault = vectorFault("gravity", scene.gravity, kMaxSpeed)) return "Scene: " + *fault;
    if (Sentence fault = nameFault(scene.bodies)) return fault;
    for (const SceneBody& body : scene.bodies) {
        if (const Sentence fault = valueFault(body)) return ownerText(body) + ": " + *fault;
    }
    return shapeFault(scene);
}

Result<SceneWorld> makeWorld(const BodyScene& scene, const WorldSettings& settings) {
    if (const Sentence fault = verifyBodyScene(scene)) return Error{ErrorCode::BadInput, *fault};
    WorldSettings sceneSettings = settings;
    sceneSettings.gravity = scene.gravity;
    SceneWorld made{World(sceneSettings), {}};
    std::vector<std::shared_ptr<const Shape>> shapes(scene.shapes.size());
    for (const SceneBody& body : scene.bodies) {
        if (!shapes[body.shape]) {
            Result<std::shared_ptr<const Shape>> shape = makeShape(scene.shapes[body.shape]);
            if (!shape) return withOwner(body, shape.error());
            shapes[body.shape] = std::move(*shape);
        }
        const Result<BodyId> id = addTo(made.world, body, shapes[body.shape]);
        if (!id) return withOwner(body, id.error());
        made.bodies.push_back(*id);
    }
    return made;
}

Penetration penetrationOf(const BodyScene& scene, std::span<const Pose> poses) {
    RUBBLE_ASSERT(poses.size() == scene.bodies.size());
    std::vector<PosedHulls> bodies;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const SceneBody& body = scene.bodies[k];
        bodies.push_back({scene.shapes[body.shape], poses[k], body.kind == BodyKind::Dynamic});
    }
    return penetrationOf(bodies);
}

}  // namespace rubble
