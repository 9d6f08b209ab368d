#include "core/asset/checks/PlayFaults.h"

#include "core/asset/project/Names.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

Sentence eventFault(const std::string& owner, const DropRequirement& drop) {
    return rangeFault(owner, {{ProjectNumber::DropHeight, drop.height}});
}

Sentence eventFault(const std::string& owner, const HitRequirement& hit) {
    return rangeFault(owner, {{ProjectNumber::Mass, hit.mass}, {ProjectNumber::HitSpeed, hit.speed}});
}

Sentence eventFault(const std::string& owner, const ImpulseRequirement& impact) {
    return rangeFault(owner, {{ProjectNumber::Threshold, impact.impulse, "impulse"}});
}

Sentence actionFault(const std::string& owner, const Throw& thrown) {
    if (Sentence fault = rangeFault(owner, ProjectNumber::ShotPosition, thrown.from, "start")) return fault;
    if (Sentence fault = rangeFault(owner, ProjectNumber::ShotPosition, thrown.to, "aim")) return fault;
    if (glm::distance(thrown.from, thrown.to) < kMinThrowLength) {
        return owner +
               ": it starts where it aims, so that it has no direction; the start and the aim must be at least " +
               messageText(kMinThrowLength) + " m apart.";
    }
    return rangeFault(owner, {{ProjectNumber::ProjectileSize, thrown.size.x, "size in x"},
                              {ProjectNumber::ProjectileSize, thrown.size.y, "size in y"},
                              {ProjectNumber::ProjectileSize, thrown.size.z, "size in z"},
                              {ProjectNumber::Mass, thrown.mass},
                              {ProjectNumber::ProjectileSpeed, thrown.speed}});
}

Sentence actionFault(const std::string& owner, const Hammer& hammer) {
    if (Sentence fault = rangeFault(owner, ProjectNumber::ShotPosition, hammer.at)) return fault;
    if (Sentence fault = rangeFault(owner, ProjectNumber::HammerImpulse, hammer.impulse)) return fault;
    if (!hammer.radius) return std::nullopt;
    return rangeFault(owner, {{ProjectNumber::HammerRadius, *hammer.radius}});
}

Sentence actionFault(const std::string& owner, const Blast& blast) {
    if (Sentence fault = rangeFault(owner, ProjectNumber::ShotPosition, blast.at)) return fault;
    return rangeFault(owner,
                      {{ProjectNumber::BlastImpulse, blast.impulse}, {ProjectNumber::BlastRadius, blast.radius}});
}

}  // namespace

std::optional<std::string> playFault(const Asset& asset) {
    const std::string owner = ownerText("Asset", asset.id, asset.name);
    if (asset.cutAtImpact) {
        if (Sentence fault = cutFault(owner, *asset.cutAtImpact)) return fault;
    }
    for (std::size_t k = 0; k < asset.requirements.size(); ++k) {
        const std::string requirement = owner + ": requirement " + std::to_string(k);
        const auto fault = [&](const auto& event) { return eventFault(requirement, event); };
        if (Sentence found = std::visit(fault, asset.requirements[k].event)) return found;
        if (Sentence found =
                rangeFault(requirement, {{ProjectNumber::ExpectedHole, asset.requirements[k].hole, "hole"}}))
            return found;
    }
    return std::nullopt;
}

std::optional<std::string> faultOf(const Debris& debris) {
    if (debris.maxFragments && !rangeOf(ProjectNumber::DebrisFragments).contains(*debris.maxFragments))
        return "The debris: the maximum number of fragments is 0, but it must be at least 1.";
    return rangeFault("The debris", {{ProjectNumber::DebrisLifetime, debris.lifetime.value_or(1.0)},
                                     {ProjectNumber::DebrisFade, debris.fade}});
}

std::optional<std::string> faultOf(const EventSettings& events) {
    return rangeFault("The settings of events",
                      {{ProjectNumber::EventEnergy, events.leastEnergy},
                       {ProjectNumber::EventRecords, static_cast<double>(events.maxRecords)}});
}

std::optional<std::string> faultOf(const Shot& shot) {
    const std::string owner = ownerText("Saved throw", shot.id, shot.name);
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::ShotTime, shot.time}})) return fault;
    return std::visit([&](const auto& action) { return actionFault(owner, action); }, shot.action);
}

std::optional<std::string> faultOf(const PlayTest& test) {
    const std::string owner = ownerText("Test", test.id, test.name);
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::TestDuration, test.duration}})) return fault;
    if (test.state.find_first_of("/\\") != std::string::npos || test.state == "..") {
        return owner + ": the state " + quotedName(test.state) + " must be the name of a file beside the project.";
    }
    for (std::size_t k = 0; k < test.removed.size(); ++k) {
        const InstancePart& part = test.removed[k];
        if (k > 0 && test.removed[k - 1].instance >= part.instance)
            return owner + ": what is removed must be in ascending order of instances.";
        if (!std::ranges::is_sorted(part.fragments, std::ranges::less_equal()))
            return owner + ": the removed fragments must be in ascending order, and each there once.";
        for (const FragmentPath& path : part.fragments) {
            if (!isFragmentPath(path)) return owner + ": " + quotedName(path) + " is not the path of a fragment.";
        }
    }
    for (const Expectation& expectation : test.expectations) {
        if (Sentence fault = rangeFault(owner, {{numberOf(expectation.kind), expectation.value}})) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble
