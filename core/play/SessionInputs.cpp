#include "core/asset/PlayFaults.h"
#include "core/base/Assert.h"
#include "core/play/Missile.h"
#include "core/play/SessionState.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

constexpr double kHammerReach = 0.1;  // m before and behind the place where it is aimed

bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isLiving(const SessionState& state, std::uint32_t number) {
    return std::ranges::binary_search(state.bodies, number, {}, &PlayBody::number);
}

/// What is thrown, as a body to be.
Result<BodyDefinition> missileOf(const Throw& thrown, const PlayScene& scene, const SessionState& state) {
    if (thrown.kind != ProjectileKind::Asset) return missile(thrown, nullptr, nullptr);
    return missile(thrown, scene.assets.at({thrown.asset})->whole.shape, &materialOf(state, scene, thrown.asset));
}

Sentence inputFault(const ShotInput& shot, const PlayScene& scene, const SessionState& state) {
    if (Sentence fault = rubble::faultOf(Shot{.name = shot.name, .action = shot.action})) return fault;
    const Throw* thrown = std::get_if<Throw>(&shot.action);
    if (thrown == nullptr) return std::nullopt;
    if (thrown->kind == ProjectileKind::Asset && !scene.assets.contains({thrown->asset})) {
        return "Shot \"" + shot.name + "\" throws asset " + std::to_string(thrown->asset) + ", which is not there.";
    }
    const Result<BodyDefinition> body = missileOf(*thrown, scene, state);
    if (!body) return "Shot \"" + shot.name + "\": " + body.error().message;
    return std::nullopt;
}

Sentence inputFault(const ThresholdInput& input, const PlayScene& scene, const SessionState&) {
    if (!(input.threshold > 0.0 && std::isfinite(input.threshold))) return "A threshold must be positive.";
    if (input.instance == 0 && !scene.assets.contains({input.asset})) {
        return "There is no asset " + std::to_string(input.asset) + " whose threshold could be changed.";
    }
    const auto isMeant = [&](const Instance& instance) { return instance.id == input.instance; };
    if (input.instance != 0 && std::ranges::none_of(scene.project.instances, isMeant)) {
        return "There is no instance " + std::to_string(input.instance) + " whose threshold could be changed.";
    }
    return std::nullopt;
}

Sentence inputFault(const MaterialInput& input, const PlayScene& scene, const SessionState&) {
    Project changed = scene.project;
    const auto found = std::ranges::find(changed.materials, input.material.id, &Material::id);
    if (found == changed.materials.end()) {
        return "There is no material " + std::to_string(input.material.id) + " to be changed.";
    }
    *found = input.material;
    return verifyProject(changed);
}

Sentence inputFault(const BreakInput& input, const PlayScene&, const SessionState& state) {
    if (!isLiving(state, input.body)) return "There is no body " + std::to_string(input.body) + " to break.";
    return std::nullopt;
}

Sentence inputFault(const GravityInput& input, const PlayScene&, const SessionState&) {
    return isFinite(input.gravity) ? std::nullopt : Sentence("Gravity must be finite.");
}

Sentence inputFault(const DestructionInput&, const PlayScene&, const SessionState&) { return std::nullopt; }

Sentence inputFault(const GrabInput& input, const PlayScene&, const SessionState& state) {
    if (!isLiving(state, input.body)) return "There is no body " + std::to_string(input.body) + " to take hold of.";
    if (!isFinite(input.point) || !(input.force > 0.0 && std::isfinite(input.force))) {
        return "What is taken hold of needs a finite place and a positive force.";
    }
    return std::nullopt;
}

Sentence inputFault(const DragInput& input, const PlayScene&, const SessionState&) {
    return isFinite(input.to) ? std::nullopt : Sentence("What is dragged needs a finite place to go to.");
}

Sentence inputFault(const LetGoInput&, const PlayScene&, const SessionState&) { return std::nullopt; }

void act(const SessionParts& parts, const std::string& name, const Throw& thrown) {
    Result<BodyDefinition> definition = missileOf(thrown, parts.scene, parts.state);
    RUBBLE_ASSERT(definition.hasValue());
    PlayBody body{.role = PlayRole::Missile, .origin = static_cast<std::uint32_t>(parts.state.origins.size())};
    PlayOrigin origin{.name = name};
    if (thrown.kind == ProjectileKind::Asset) {
        origin.asset = thrown.asset;
        body.asset = parts.scene.assets.at({thrown.asset});
    } else {
        body.hull = std::make_shared<const Polytope>(missileHull(thrown));
    }
    const Result<std::uint32_t> added = addBody(parts, *definition, std::move(body));
    if (!added) {
        parts.state.events.notices.push_back("Shot \"" + name + "\": " + added.error().message);
        return;
    }
    parts.state.origins.push_back(std::move(origin));
    parts.state.events.born.push_back(parts.state.bodies.back());
}

/// The body that a hammer meets, and where.
std::optional<CastHit> struckBy(const World& world, const Hammer& hammer, Vec3 direction) {
    return world.castRay(hammer.at - kHammerReach * direction, hammer.at + kHammerReach * direction);
}

void act(const SessionParts& parts, const std::string& name, const Hammer& hammer) {
    const double size = std::sqrt(glm::dot(hammer.impulse, hammer.impulse));
    if (size == 0.0) return;
    const Vec3 direction = hammer.impulse / size;
    std::optional<CastHit> hit = struckBy(parts.world, hammer, direction);
    if (!hit) {
        parts.state.events.notices.push_back("The blow \"" + name + "\" met nothing.");
        return;
    }
    double rest = size;
    const PlayBody body = *findBody(parts.state, static_cast<std::uint32_t>(parts.world.tag(hit->body)));
    const double threshold = thresholdOf(parts.state, parts.scene, body);
    if (body.breaking() != nullptr) parts.state.events.impacts.push_back({body.number, size, threshold, hit->point});
    if (parts.state.hasDestruction && size >= threshold) {
        PendingBreak broken = pendingBreak(parts, body);
        broken.told.impact = size;
        broken.told.point = hit->point;
        broken.told.normal = direction;
        broken.mass.push(threshold * direction, hit->point);  // the whole takes what breaks it, a piece the rest
        rest = size - threshold;
        carryOut(parts, {broken});
        hit = struckBy(parts.world, hammer, direction);
    }
    if (hit && parts.world.kind(hit->body) == BodyKind::Dynamic) {
        parts.world.applyImpulse(hit->body, rest * direction, hit->point);
    }
}

void act(const SessionParts& parts, const std::string&, const Explosion& explosion) {
    std::vector<PendingBreak> breaks;
    for (const BlastPush& push : parts.world.blast(explosion.at, explosion.radius, explosion.impulse)) {
        const PlayBody body = *findBody(parts.state, static_cast<std::uint32_t>(parts.world.tag(push.body)));
        const double size = std::sqrt(glm::dot(push.impulse, push.impulse));
        if (body.breaking() == nullptr || size == 0.0) continue;
        const double threshold = thresholdOf(parts.state, parts.scene, body);
        parts.state.events.impacts.push_back({body.number, size, threshold, push.point});
        if (!parts.state.hasDestruction || size < threshold) continue;
        breaks.push_back(pendingBreak(parts, body));
        breaks.back().told.impact = size;
        breaks.back().told.point = push.point;
        breaks.back().told.normal = push.impulse / size;
    }
    std::ranges::sort(breaks, {}, [](const PendingBreak& one) { return one.told.body.number; });
    carryOut(parts, std::move(breaks));
    parts.world.explode(explosion.at, explosion.radius, explosion.impulse);
}

void follow(const SessionParts& parts, const ShotInput& shot) {
    std::visit([&](const auto& action) { act(parts, shot.name, action); }, shot.action);
}

void follow(const SessionParts& parts, const ThresholdInput& input) {
    std::map<Id, double>& thresholds =
        input.instance != 0 ? parts.state.instanceThresholds : parts.state.assetThresholds;
    thresholds[input.instance != 0 ? input.instance : input.asset] = input.threshold;
}

void follow(const SessionParts& parts, const MaterialInput& input) {
    *std::ranges::lower_bound(parts.state.materials, input.material.id, {}, &Material::id) = input.material;
    for (const PlayBody& body : parts.state.bodies) {
        if (body.asset == nullptr) continue;
        if (materialOf(parts.state, parts.scene, body.asset->bake->asset).id != input.material.id) continue;
        parts.world.setMaterial(body.body, bodyMaterial(parts, *body.asset, body.fragment, body.role));
    }
}

/// The break that an input asks for, added to those of the inputs just before it.
void addBreak(const SessionParts& parts, const BreakInput& input, std::vector<PendingBreak>& breaks) {
    const PlayBody* body = findBody(parts.state, input.body);
    const auto isTold = [&](const PendingBreak& one) { return one.told.body.number == input.body; };
    if (body == nullptr || body->breaking() == nullptr || std::ranges::any_of(breaks, isTold)) {
        parts.state.events.notices.push_back("There is nothing to break: it has no pieces, or it is gone.");
        return;
    }
    breaks.push_back(pendingBreak(parts, *body));
    breaks.back().told.point = breaks.back().mass.centre;
}

void follow(const SessionParts& parts, const GravityInput& input) { parts.world.setGravity(input.gravity); }

void follow(const SessionParts& parts, const DestructionInput& input) { parts.state.hasDestruction = input.isOn; }

void follow(const SessionParts& parts, const GrabInput& input) {
    const PlayBody* body = findBody(parts.state, input.body);
    if (body == nullptr || parts.world.kind(body->body) != BodyKind::Dynamic) {
        parts.state.events.notices.push_back("There is nothing to take hold of: it is fixed, or it broke.");
        return;
    }
    parts.world.grab(body->body, input.point, input.force);
}

void follow(const SessionParts& parts, const DragInput& input) { parts.world.dragTo(input.to); }

void follow(const SessionParts& parts, const LetGoInput&) { parts.world.letGo(); }

void follow(const SessionParts& parts, const PlayInput& input) {
    std::visit(
        [&](const auto& one) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, BreakInput>) follow(parts, one);
        },
        input);
}

}  // namespace

std::optional<std::string> faultOf(const PlayInput& input, const PlayScene& scene, const SessionState& state) {
    return std::visit([&](const auto& one) { return inputFault(one, scene, state); }, input);
}

void followInputs(const SessionParts& parts) {
    std::vector<TimedInput>& pending = parts.state.pending;
    std::size_t due = 0;
    while (due < pending.size() && pending[due].step <= parts.state.step) ++due;
    const auto end = pending.begin() + static_cast<std::ptrdiff_t>(due);
    std::vector<TimedInput> inputs(std::make_move_iterator(pending.begin()), std::make_move_iterator(end));
    pending.erase(pending.begin(), end);
    std::vector<PendingBreak> breaks;  // of inputs in a row: those bodies break at once
    breaks.reserve(inputs.size());
    for (TimedInput& timed : inputs) {
        if (const auto* input = std::get_if<BreakInput>(&timed.input)) {
            addBreak(parts, *input, breaks);
        } else {
            carryOut(parts, std::exchange(breaks, {}));
            follow(parts, timed.input);
        }
        parts.state.events.inputs.push_back(std::move(timed));
    }
    carryOut(parts, std::move(breaks));
}

}  // namespace rubble
