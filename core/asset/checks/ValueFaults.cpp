#include "core/asset/checks/ValueFaults.h"

#include "core/asset/checks/BondFaults.h"
#include "core/asset/checks/PlayFaults.h"
#include "core/asset/project/Names.h"
#include "core/asset/project/Ranges.h"
#include "core/asset/project/SurfaceFault.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/Utf8.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

/// The deviation of a rotation quaternion's length from 1: the rounding of its text in a file.
constexpr double kUnitLengthTolerance = 1e-9;

Sentence colourFault(const std::string& owner, const Colour& colour) {
    return rangeFault(owner, {{ProjectNumber::ColourChannel, colour.red, "colour's red"},
                              {ProjectNumber::ColourChannel, colour.green, "colour's green"},
                              {ProjectNumber::ColourChannel, colour.blue, "colour's blue"}});
}

Sentence levelFault(const std::string& owner, const Level& level) {
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::MinimumVolume, level.minimumVolume},
                                            {ProjectNumber::Threshold, level.threshold.value_or(1.0)},
                                            {ProjectNumber::BondStrength, level.bondStrength}})) {
        return fault;
    }
    if (Sentence fault = verifyPattern(level.pattern)) return owner + ": " + *fault;
    return std::nullopt;
}

/// Checks the paths of settings of single fragments, which must ascend.
template <class Setting>
Sentence pathFault(const std::vector<Setting>& settings, const std::string& what) {
    const FragmentPath* before = nullptr;
    for (const Setting& setting : settings) {
        if (!isFragmentPath(setting.fragment)) return quotedName(setting.fragment) + " is not a fragment path.";
        if (before && *before >= setting.fragment) {
            return "the " + what + " of fragment " + setting.fragment + " come" + (what.back() == 's' ? "" : "s") +
                   " after " + (what.back() == 's' ? "those" : "that") + " of " + *before + "; paths must ascend.";
        }
        before = &setting.fragment;
    }
    return std::nullopt;
}

/// Checks shaping, edits and settings of single fragments.
Sentence shapeFault(const Asset& asset) {
    if (Sentence fault = verifyShaping(asset.shaping)) return fault;
    for (const FragmentEdit& edit : asset.edits) {
        if (Sentence fault = verifyEdit(edit)) return fault;
    }
    if (Sentence fault = pathFault(asset.fragmentLevels, "settings")) return fault;
    return pathFault(asset.fragmentThresholds, "threshold");
}

/// Calls report(sentence) with each fault until it returns false.
template <class Report>
void reportFaults(const Project& project, const Report& report) {
    const auto goesOn = [&](const Sentence& fault) { return !fault || report(*fault); };
    const auto areDone = [&](const auto& elements) {
        return std::ranges::all_of(elements, [&](const auto& element) { return goesOn(faultOf(element)); });
    };
    const auto isAssetDone = [&](const Asset& asset) {
        const Material* material = findMaterial(project, asset.material);
        Sentence fault = faultOf(asset);
        if (!fault && asset.surface) fault = surfaceFault(ownerText("Asset", asset.id, asset.name), *asset.surface);
        if (!fault && material) fault = thresholdFault(asset, *material);
        return goesOn(fault);
    };
    areDone(project.materials) && std::ranges::all_of(project.assets, isAssetDone) && areDone(project.instances) &&
        goesOn(sceneFault(project)) && areDone(project.shots) && areDone(project.playTests) && areDone(project.mortars);
}

}  // namespace

std::optional<std::string> faultOf(const Material& material) {
    const std::string owner = ownerText("Material", material.id, material.name);
    if (Sentence fault =
            rangeFault(owner, {{ProjectNumber::Density, material.density},
                               {ProjectNumber::Friction, material.friction},
                               {ProjectNumber::Restitution, material.restitution},
                               {ProjectNumber::TensileStrength, material.tensileStrength.value_or(1.0)},
                               {ProjectNumber::FractureToughness, material.fractureToughness.value_or(1.0)},
                               {ProjectNumber::YoungsModulus, material.youngsModulus.value_or(1.0)},
                               {ProjectNumber::Opacity, material.opacity}})) {
        return fault;
    }
    if (Sentence fault = colourFault(owner, material.outside)) return fault;
    return colourFault(owner, material.inside);
}

std::optional<std::string> faultOf(const Asset& asset) {
    const std::string owner = ownerText("Asset", asset.id, asset.name);
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::Threshold, asset.threshold},
                                            {ProjectNumber::ContactTime, asset.contactTime.value_or(1.0)},
                                            {ProjectNumber::InsideUvScale, asset.insideUvScale}})) {
        return fault;
    }
    if (Sentence fault = shapeRangeFault(owner, asset)) return fault;
    if (asset.isPrism()) {
        if (const Result<Prism> prism = validated(asset.prism()); !prism) return owner + ": " + prism.error().message;
    }
    if (Sentence fault = verifyPattern(asset.pattern)) return owner + ": " + *fault;
    for (const Level& level : asset.levels) {
        if (Sentence fault = levelFault(owner, level)) return fault;
    }
    if (Sentence fault = shapeFault(asset)) return owner + ": " + *fault;
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (!leaf.level) continue;
        if (Sentence fault = levelFault(owner, *leaf.level)) return fault;
    }
    for (const FragmentThreshold& own : asset.fragmentThresholds) {
        if (Sentence fault = rangeFault(owner, {{ProjectNumber::Threshold, own.threshold}})) return fault;
    }
    if (Sentence fault = bondFault(asset)) return fault;
    if (asset.texture)
        if (Sentence fault = textureFault(owner, *asset.texture, asset.surface.get())) return fault;
    return playFault(asset);
}

std::optional<std::string> thresholdFault(const Asset& asset, const Material& material) {
    return rangeFault(ownerText("Asset", asset.id, asset.name),
                      {{ProjectNumber::Threshold, thresholdOf(asset, material), "derived threshold"}});
}

std::optional<std::string> faultOf(const Instance& instance) {
    const std::string owner = ownerText("Instance", instance.id, instance.name);
    if (Sentence fault = rangeFault(owner, ProjectNumber::InstancePosition, instance.pose.position)) return fault;
    const double length = glm::length(instance.pose.orientation);
    if (!(std::abs(length - 1.0) <= kUnitLengthTolerance)) {
        if (!std::isfinite(length)) return owner + ": the orientation is too long; its length must be 1.";
        return owner + ": the orientation has the length " + messageText(length) + ", but it must be 1.";
    }
    return rangeFault(owner, {{ProjectNumber::Threshold, instance.threshold.value_or(1.0)},
                              {ProjectNumber::BondStrength, instance.bondStrength}});
}

std::optional<std::string> sceneFault(const Project& project) {
    if (Sentence fault = rangeFault("The ground", {{ProjectNumber::GroundHeight, project.ground.height},
                                                   {ProjectNumber::Friction, project.ground.friction},
                                                   {ProjectNumber::Restitution, project.ground.restitution}})) {
        return fault;
    }
    if (Sentence fault = rangeFault("The project", ProjectNumber::Gravity, project.gravity)) return fault;
    if (Sentence fault = rangeFault("The project",
                                    {{ProjectNumber::Threshold, project.damage.thesisThreshold, "thesis threshold"}})) {
        return fault;
    }
    if (Sentence fault = faultOf(project.debris)) return fault;
    return faultOf(project.events);
}

std::optional<std::string> valueFault(const Project& project) {
    Sentence first;
    reportFaults(project, [&](const std::string& fault) {
        first = fault;
        return false;
    });
    return first;
}

std::vector<std::string> valueFaults(const Project& project) {
    std::vector<std::string> faults;
    reportFaults(project, [&](const std::string& fault) {
        faults.push_back(fault);
        return true;
    });
    return faults;
}

}  // namespace rubble
