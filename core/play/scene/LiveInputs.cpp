#include "core/play/scene/LiveInputs.h"

#include "core/asset/strength/Threshold.h"

namespace rubble {
namespace {

/// Assigns a value; true if it differed.
template <class Value>
bool assign(Value& value, const Value& from) {
    if (value == from) return false;
    value = from;
    return true;
}

void updateMaterials(Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.materials.size(); ++k) {
        Material& material = played.materials[k];
        const Material& other = now.materials[k];
        const bool hasChanged = assign(material.density, other.density) | assign(material.friction, other.friction) |
                                assign(material.restitution, other.restitution);
        material.name = other.name;
        material.tensileStrength = other.tensileStrength;
        material.fractureToughness = other.fractureToughness;
        material.youngsModulus = other.youngsModulus;
        if (hasChanged) inputs.push_back(MaterialInput{other});
    }
}

/// `played` is `before` with the materials of `now`, which are updated first.
void updateAssets(const Project& before, Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.assets.size(); ++k) {
        Asset& asset = played.assets[k];
        const Asset& other = now.assets[k];
        const double threshold = thresholdOf(now, other);
        if (thresholdOf(before, before.assets[k]) != threshold) {
            inputs.push_back(ThresholdInput{.asset = asset.id, .threshold = threshold});
        }
        asset.threshold = other.threshold;
        asset.contactTime = other.contactTime;
        asset.name = other.name;
        asset.requirements = other.requirements;
    }
}

/// An instance that loses its own threshold cannot be updated: inputs cannot return it to its asset's.
void updateInstances(Project& played, const Project& now, std::vector<PlayInput>& inputs) {
    for (std::size_t k = 0; k < played.instances.size(); ++k) {
        Instance& instance = played.instances[k];
        const Instance& other = now.instances[k];
        if (instance.threshold && !other.threshold) continue;  // restart
        if (assign(instance.threshold, other.threshold)) {
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
    Project updated = played;
    std::vector<PlayInput> inputs;
    updateMaterials(updated, now, inputs);
    updateAssets(played, updated, now, inputs);
    updateInstances(updated, now, inputs);
    if (assign(updated.gravity, now.gravity)) inputs.push_back(GravityInput{now.gravity});
    updated.shots = now.shots;
    updated.playTests = now.playTests;
    updated.nextId = now.nextId;
    if (!(updated == now)) return std::nullopt;
    return inputs;
}

}  // namespace rubble
