#include "core/play/session/SessionInputs.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/checks/PlayFaults.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Ranges.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/play/breaking/Blow.h"
#include "core/play/breaking/BondBreaking.h"
#include "core/play/breaking/PartRemoval.h"
#include "core/play/breaking/Splitting.h"
#include "core/play/breaking/Swap.h"
#include "core/play/scene/Projectile.h"
#include "core/play/session/ApplyBlast.h"
#include "core/play/state/InputDiagnostics.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

constexpr std::size_t kMaxBodiesInPlace = 64;

bool isAlive(const SessionState& state, std::uint32_t number) {
    return std::ranges::binary_search(state.bodies, number, {}, &PlayBody::number);
}

/// The body that a throw starts with.
Result<BodyDefinition> projectileBodyOf(const Throw& thrown, const PlayScene& scene, const SessionState& state) {
    if (thrown.kind != ProjectileKind::Asset) return projectileBody(thrown, nullptr, nullptr);
    return projectileBody(thrown, scene.assets.at({thrown.asset})->whole.shape,
                          &materialOf(state, scene, thrown.asset));
}

Sentence faultOfInput(const ShotInput& shot, const PlayScene& scene, const SessionState& state) {
    if (Sentence fault = rubble::faultOf(Shot{.name = shot.name, .action = shot.action})) return fault;
    const Throw* thrown = std::get_if<Throw>(&shot.action);
    if (thrown == nullptr) return std::nullopt;
    if (thrown->kind == ProjectileKind::Asset && !scene.assets.contains({thrown->asset})) {
        return "Saved throw " + quotedName(shot.name) + " throws asset " + std::to_string(thrown->asset) +
               ", which does not exist.";
    }
    const Result<BodyDefinition> body = projectileBodyOf(*thrown, scene, state);
    if (!body) return "Saved throw " + quotedName(shot.name) + ": " + body.error().message;
    return std::nullopt;
}

Sentence faultOfInput(const ThresholdInput& input, const PlayScene& scene, const SessionState&) {
    if (Sentence fault = rangeFault("Cannot set a threshold", {{ProjectNumber::Threshold, input.threshold}})) {
        return fault;
    }
    if (input.instance == 0 && !scene.assets.contains({input.asset})) {
        return "Cannot set a threshold: there is no asset " + std::to_string(input.asset) + ".";
    }
    const auto isMeant = [&](const Instance& instance) { return instance.id == input.instance; };
    if (input.instance != 0 && std::ranges::none_of(scene.project.instances, isMeant)) {
        return "Cannot set a threshold: there is no instance " + std::to_string(input.instance) + ".";
    }
    return std::nullopt;
}

Sentence faultOfInput(const MaterialInput& input, const PlayScene& scene, const SessionState&) {
    Project changed = scene.project;
    const auto found = std::ranges::find(changed.materials, input.material.id, &Material::id);
    if (found == changed.materials.end()) {
        return "Cannot set a material: there is no material " + std::to_string(input.material.id) + ".";
    }
    *found = input.material;
    return verifyProject(changed);
}

Sentence faultOfInput(const BreakInput& input, const PlayScene&, const SessionState& state) {
    if (!isAlive(state, input.body)) return "Cannot break: there is no body " + std::to_string(input.body) + ".";
    return std::nullopt;
}

Sentence faultOfInput(const GravityInput& input, const PlayScene&, const SessionState&) {
    return rangeFault("Cannot set gravity", ProjectNumber::Gravity, input.gravity);
}

Sentence faultOfInput(const DestructionInput&, const PlayScene&, const SessionState&) { return std::nullopt; }

Sentence faultOfInput(const GrabInput& input, const PlayScene&, const SessionState& state) {
    if (!isAlive(state, input.body)) return "Cannot grab: there is no body " + std::to_string(input.body) + ".";
    if (Sentence fault = rangeFault("Cannot grab", ProjectNumber::ShotPosition, input.point)) return fault;
    return rangeFault("Cannot grab", {{ProjectNumber::GrabForce, input.force}});
}

Sentence faultOfInput(const DragInput& input, const PlayScene&, const SessionState&) {
    return rangeFault("Cannot drag", ProjectNumber::ShotPosition, input.to, "target");
}

Sentence faultOfInput(const ReleaseInput&, const PlayScene&, const SessionState&) { return std::nullopt; }

Sentence faultOfInput(const RemoveInput& input, const PlayScene& scene, const SessionState&) {
    const auto& [id, fragments] = input.part;
    const Instance* instance = findInstance(scene.project, id);
    if (instance == nullptr) return "Cannot remove: there is no instance " + std::to_string(id) + ".";
    const PlayAsset& asset = *scene.assets.at(variantOf(*instance));
    for (const FragmentPath& path : fragments) {
        const std::optional<std::uint32_t> fragment = fragmentAt(*asset.bake, path);
        if (fragment && *fragment != kNone && asset.isBonded) continue;
        return "Cannot remove " + quotedName(instance->name + "/" + path) + ": " +
               (asset.isBonded ? "there is no such fragment." : "only fragments of bonded instances can be removed.");
    }
    return std::nullopt;
}

/// Whether more bodies are in the place of a new one than it may start in: each of them gets contacts with all others
/// there, of which a thousand in one place have half a million.
bool isPlaceTaken(const World& world, const std::vector<Polytope>& hulls, const Pose& pose) {
    return std::ranges::any_of(hulls, [&](const Polytope& hull) {
        const Result<std::vector<BodyId>> bodies = world.overlapping(hull, pose);
        return bodies && bodies->size() >= kMaxBodiesInPlace;
    });
}

void applyAction(SessionParts& parts, const std::string& name, const Throw& thrown) {
    const Result<BodyDefinition> definition = projectileBodyOf(thrown, parts.scene(), parts.state());
    if (!definition) {  // its material has changed since the input was added
        return addUnapplied(parts, nullptr, "Saved throw " + quotedName(name) + ": " + definition.error().message);
    }
    PlayBody body{.role = PlayRole::Projectile, .origin = static_cast<std::uint32_t>(parts.state().origins.size())};
    PlayOrigin origin{.name = name};
    if (thrown.kind == ProjectileKind::Asset) {
        origin.asset = thrown.asset;
        body.asset = parts.scene().assets.at({thrown.asset});
    } else {
        body.hull = std::make_shared<const Polytope>(projectileHull(thrown));
        origin.thrown = thrown;
    }
    if (isPlaceTaken(parts.world(), hullsOf(body), definition->pose)) {
        return addUnapplied(parts, nullptr,
                            "Saved throw " + quotedName(name) + ": " + std::to_string(kMaxBodiesInPlace) +
                                " bodies are in its place already; let it start elsewhere or later.");
    }
    const Result<std::uint32_t> added = addBody(parts, *definition, body);
    if (!added) {
        addUnapplied(parts, &body, "Saved throw " + quotedName(name) + ": " + added.error().message);
        return;
    }
    parts.state().origins.push_back(std::move(origin));
    parts.state().events.born.push_back(parts.state().bodies.back());
    const double energy = 0.5 * parts.world().mass(parts.state().bodies.back().body) * thrown.speed * thrown.speed;
    parts.state().events.energy.push_back({.change = EnergyChange::Throw,
                                           .body = *added,
                                           .given = energy,
                                           .after = kineticEnergy(parts.world(), parts.state().bodies.back().body)});
}

void applyAction(SessionParts& parts, const std::string& name, const Hammer& hammer) { applyBlow(parts, name, hammer); }

void applyAction(SessionParts& parts, const std::string& name, const Blast& blast) { applyBlast(parts, name, blast); }

void applyInput(SessionParts& parts, const ShotInput& shot) {
    std::visit([&](const auto& action) { applyAction(parts, shot.name, action); }, shot.action);
}

void applyInput(SessionParts& parts, const ThresholdInput& input) {
    std::map<Id, double>& thresholds =
        input.instance != 0 ? parts.state().instanceThresholds : parts.state().assetThresholds;
    thresholds[input.instance != 0 ? input.instance : input.asset] = input.threshold;
}

void applyInput(SessionParts& parts, const MaterialInput& input) {
    *std::ranges::lower_bound(parts.state().materials, input.material.id, {}, &Material::id) = input.material;
    for (const PlayBody& body : parts.state().bodies) {
        if (body.asset == nullptr) continue;
        if (materialOf(parts.state(), parts.scene(), body.asset->bake->asset).id != input.material.id) continue;
        reportRefused(
            parts, &body,
            "The material of " + quotedName(nameOf(body, parts.state().origins[body.origin])) + " stays as it was",
            parts.world().setMaterial(body.body, bodyMaterial(parts, *body.asset, body.fragment, body.role)));
    }
}

/// Adds the break of an input to those of the inputs directly before it.
void addBreak(SessionParts& parts, const BreakInput& input, std::vector<PendingBreak>& breaks) {
    const PlayBody* body = findBody(parts.state(), input.body);
    const auto isPending = [&](const PendingBreak& pending) { return pending.event.body.number == input.body; };
    if (body == nullptr || body->fracture() == nullptr || std::ranges::any_of(breaks, isPending)) {
        addUnapplied(parts, body, "Nothing was broken: the body is gone, unbreakable or without fragments.");
        return;
    }
    breaks.push_back(pendingBreak(parts, *body));
    breaks.back().event.point = breaks.back().mass.centre;
}

void applyInput(SessionParts& parts, const GravityInput& input) {
    reportRefused(parts, nullptr, "Cannot set gravity", parts.world().setGravity(input.gravity));
}

void applyInput(SessionParts& parts, const DestructionInput& input) { parts.state().hasDestruction = input.isOn; }

void applyInput(SessionParts& parts, const GrabInput& input) {
    const PlayBody* body = findBody(parts.state(), input.body);
    if (body == nullptr || parts.world().kind(body->body) != BodyKind::Dynamic) {
        addUnapplied(parts, body, "Nothing was grabbed: the body is fixed, or it broke.");
        return;
    }
    reportRefused(parts, body, "Cannot grab", parts.world().grab(body->body, input.point, input.force));
}

void applyInput(SessionParts& parts, const DragInput& input) {
    reportRefused(parts, nullptr, "Cannot drag", parts.world().dragTo(input.to));
}

void applyInput(SessionParts& parts, const ReleaseInput&) { parts.world().release(); }

void applyInput(SessionParts& parts, const RemoveInput& input) {
    const auto& [instance, paths] = input.part;
    if (paths.empty()) return removeInstance(parts, instance);
    const Bake& bake = *parts.scene().assets.at(variantOf(*findInstance(parts.scene().project, instance)))->bake;
    std::vector<std::uint32_t> fragments;
    for (const FragmentPath& path : paths) fragments.push_back(*fragmentAt(bake, path));
    removeFragments(parts, instance, std::move(fragments));
}

void applyInput(SessionParts& parts, const PlayInput& input) {
    std::visit(
        [&](const auto& one) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, BreakInput>) applyInput(parts, one);
        },
        input);
}

}  // namespace

std::optional<std::string> faultOf(const PlayInput& input, const PlayScene& scene, const SessionState& state) {
    return std::visit([&](const auto& one) { return faultOfInput(one, scene, state); }, input);
}

void applyInputs(SessionParts& parts) {
    std::vector<TimedInput>& pending = parts.state().pending;
    std::size_t due = 0;
    while (due < pending.size() && pending[due].step <= parts.state().step) ++due;
    const auto end = pending.begin() + static_cast<std::ptrdiff_t>(due);
    std::vector<TimedInput> inputs(std::make_move_iterator(pending.begin()), std::make_move_iterator(end));
    pending.erase(pending.begin(), end);
    std::vector<PendingBreak> breaks;  // of consecutive inputs: these bodies break together
    breaks.reserve(inputs.size());
    for (TimedInput& timed : inputs) {
        if (const auto* input = std::get_if<BreakInput>(&timed.input)) {
            if (PlayBody* body = findBody(parts.state(), input->body); body != nullptr && body->bondedFracture()) {
                breakAllBonds(parts, *body);
            } else {
                addBreak(parts, *input, breaks);
            }
        } else {
            applyBreaks(parts, std::exchange(breaks, {}));
            applyInput(parts, timed.input);
        }
        parts.state().events.inputs.push_back(std::move(timed));
    }
    applyBreaks(parts, std::move(breaks));
    splitUnjoined(parts);
}

}  // namespace rubble
