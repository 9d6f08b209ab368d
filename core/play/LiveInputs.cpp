#include "core/play/LiveInputs.h"

#include "core/asset/Threshold.h"

namespace rubble {
namespace {

/// Takes a value over from another state of a thing, and says whether it was another one.
template <class Value>
bool take(Value& value, const Value& from) {
    if (value == from) return false;
    value = from;
    return true;
}

void takeMaterials(Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.materials.size(); ++k) {
        Material& material = played.materials[k];
        const Material& other = now.materials[k];
        const bool isOther = take(material.density, other.density) | take(material.friction, other.friction) |
                             take(material.restitution, other.restitution);
        material.name = other.name;
        material.tensileStrength = other.tensileStrength;
        material.fractureToughness = other.fractureToughness;
        if (isOther) inputs.push_back(MaterialInput{other});
    }
}

/// `played` is `before` with the materials of now: those are taken first.
void takeAssets(const Project& before, Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.assets.size(); ++k) {
        Asset& asset = played.assets[k];
        const Asset& other = now.assets[k];
        const double inForce = thresholdOf(now, other);
        if (thresholdOf(before, before.assets[k]) != inForce) {
            inputs.push_back(ThresholdInput{.asset = asset.id, .threshold = inForce});
        }
        asset.threshold = other.threshold;
        asset.contactTime = other.contactTime;
        asset.name = other.name;
        asset.intents = other.intents;
    }
}

/// An instance that has no threshold of its own any more takes its asset's, which must be the one in force then.
void takeInstances(Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.instances.size(); ++k) {
        Instance& instance = played.instances[k];
        const Instance& other = now.instances[k];
        if (instance.threshold && !other.threshold) continue;  // begun anew
        if (take(instance.threshold, other.threshold)) {
            inputs.push_back(ThresholdInput{.instance = instance.id, .threshold = *instance.threshold});
        }
        instance.name = other.name;
        instance.isHidden = other.isHidden;
        instance.isLocked = other.isLocked;
    }
}

}  // namespace

std::optional<std::vector<PlayInput>> liveInputs(const Project& played, const Project& now) {
    if (played.materials.size() != now.materials.size() || played.assets.size() != now.assets.size() ||
        played.instances.size() != now.instances.size()) {
        return std::nullopt;
    }
    Project taken = played;
    std::vector<PlayInput> inputs;
    takeMaterials(taken, now, inputs);
    takeAssets(played, taken, now, inputs);
    takeInstances(taken, now, inputs);
    if (take(taken.gravity, now.gravity)) inputs.push_back(GravityInput{now.gravity});
    taken.shots = now.shots;
    taken.playTests = now.playTests;
    taken.nextId = now.nextId;
    if (!(taken == now)) return std::nullopt;
    return inputs;
}

}  // namespace rubble
