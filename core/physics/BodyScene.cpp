#include "core/physics/BodyScene.h"

#include "core/base/MessageText.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

constexpr double kOffUnit = 1e-3;  // how far an orientation's length may be off 1: numbers written with four digits

std::string ownerText(const SceneBody& body) { return "Body \"" + body.name + "\""; }

std::string outOfRange(const char* what, double value, const std::string& range) {
    return std::string("the ") + what + " is " + messageText(value) + ", but it must be " + range + ".";
}

Sentence rangeFault(const char* what, double value, double min, double max) {
    if (value >= min && value <= max) return std::nullopt;
    return outOfRange(what, value, "from " + messageText(min) + " to " + messageText(max));
}

Sentence densityFault(const SceneBody& body) {
    const bool isFree = body.kind == BodyKind::Dynamic;
    const bool isEnough = isFree ? body.density > 0.0 : body.density >= 0.0;
    if (isEnough && body.density <= kDensest) return std::nullopt;
    return outOfRange("density", body.density,
                      (isFree ? "above 0 and at most " : "from 0 to ") + messageText(kDensest));
}

/// A vector that is not finite or longer than `most`.
Sentence vectorFault(const char* what, Vec3 value, double most) {
    if (glm::length(value) <= most) return std::nullopt;
    return std::string("the ") + what + " is (" + messageText(value.x) + ", " + messageText(value.y) + ", " +
           messageText(value.z) + "), but its length must be at most " + messageText(most) + ".";
}

Sentence orientationFault(const Quat& orientation) {
    const double length = glm::length(orientation);
    if (std::abs(length - 1.0) <= kOffUnit) return std::nullopt;
    return outOfRange("length of the orientation", length, "1");
}

Sentence valueFault(const SceneBody& body) {
    if (Sentence fault = densityFault(body)) return fault;
    if (Sentence fault = rangeFault("friction", body.friction, 0.0, kRoughest)) return fault;
    if (Sentence fault = rangeFault("restitution", body.restitution, 0.0, 1.0)) return fault;
    if (Sentence fault = vectorFault("position", body.pose.position, kFarthest)) return fault;
    if (Sentence fault = orientationFault(body.pose.orientation)) return fault;
    if (Sentence fault = vectorFault("velocity", body.velocity, kFastest)) return fault;
    return vectorFault("angular velocity", body.angularVelocity, kFastest);
}

Sentence hullFault(const Polytope& hull) {
    if (Sentence fault = verifyPolytope(hull)) return fault;
    for (const Vec3& vertex : hull.vertices) {
        if (Sentence fault = vectorFault("place of a corner", vertex, kFarthest)) return fault;
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

/// Every shape by the first body that has it.
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
            return "Two bodies have the name \"" + name + "\": numbers " + std::to_string(order[k - 1]) + " and " +
                   std::to_string(order[k]) + ", counted from 0.";
        }
    }
    return std::nullopt;
}

Error about(const SceneBody& body, const Error& error) { return {error.code, ownerText(body) + ": " + error.message}; }

Result<BodyId> addTo(World& world, const SceneBody& body, const std::shared_ptr<const Shape>& shape) {
    const bool isFree = body.kind == BodyKind::Dynamic;
    if (isFree) {
        const Sentence fault = rangeFault("mass", shape->mass.volume * body.density, kLightest, kHeaviest);
        if (fault) return Error{ErrorCode::BadInput, *fault};
    }
    return world.addBody({.shape = shape,
                          .kind = body.kind,
                          .pose = {body.pose.position, glm::normalize(body.pose.orientation)},
                          .velocity = body.velocity,
                          .angularVelocity = body.angularVelocity,
                          .density = isFree ? body.density : BodyDefinition{}.density,
                          .friction = body.friction,
                          .restitution = body.restitution});
}

}  // namespace

Sentence verifyBodyScene(const BodyScene& scene) {
    if (Sentence fault = vectorFault("gravity", scene.gravity, kFastest)) return "Scene: " + *fault;
    if (Sentence fault = nameFault(scene.bodies)) return fault;
    for (const SceneBody& body : scene.bodies) {
        if (const Sentence fault = valueFault(body)) return ownerText(body) + ": " + *fault;
    }
    return shapeFault(scene);
}

Result<SceneWorld> makeWorld(const BodyScene& scene, const WorldSettings& settings) {
    if (const Sentence fault = verifyBodyScene(scene)) return Error{ErrorCode::BadInput, *fault};
    WorldSettings here = settings;
    here.gravity = scene.gravity;
    SceneWorld made{World(here), {}};
    std::vector<std::shared_ptr<const Shape>> shapes(scene.shapes.size());
    for (const SceneBody& body : scene.bodies) {
        if (!shapes[body.shape]) {
            Result<std::shared_ptr<const Shape>> shape = makeShape(scene.shapes[body.shape]);
            if (!shape) return about(body, shape.error());
            shapes[body.shape] = std::move(*shape);
        }
        const Result<BodyId> id = addTo(made.world, body, shapes[body.shape]);
        if (!id) return about(body, id.error());
        made.bodies.push_back(*id);
    }
    return made;
}

}  // namespace rubble
