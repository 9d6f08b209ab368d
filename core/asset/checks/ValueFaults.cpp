#include "core/asset/checks/ValueFaults.h"

#include "core/asset/checks/PlayFaults.h"
#include "core/asset/project/Names.h"
#include "core/asset/project/Ranges.h"
#include "core/asset/project/Threshold.h"
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

Sentence faultOf(const Material& material) {
    const std::string owner = ownerText("Material", material.id, material.name);
    if (Sentence fault =
            rangeFault(owner, {{ProjectNumber::Density, material.density},
                               {ProjectNumber::Friction, material.friction},
                               {ProjectNumber::Restitution, material.restitution},
                               {ProjectNumber::TensileStrength, material.tensileStrength.value_or(1.0)},
                               {ProjectNumber::FractureToughness, material.fractureToughness.value_or(1.0)}})) {
        return fault;
    }
    if (Sentence fault = colourFault(owner, material.outside)) return fault;
    return colourFault(owner, material.inside);
}

Sentence cornerFault(const std::string& triangle, const SurfaceTriangle& surface) {
    for (const Vec3& corner : surface.corners) {
        if (Sentence fault = rangeFault(triangle, ProjectNumber::OutlineCoordinate, corner, "corner")) return fault;
    }
    for (const Vec2& uv : surface.uvs) {
        if (Sentence fault = rangeFault(triangle, {{ProjectNumber::TextureCoordinate, uv.x, "texture coordinate u"},
                                                   {ProjectNumber::TextureCoordinate, uv.y, "texture coordinate v"}})) {
            return fault;
        }
    }
    return std::nullopt;
}

Sentence surfaceFault(const std::string& owner, const Surface& surface) {
    const auto isNamed = [&](std::uint32_t material) {
        return material < std::max<std::size_t>(surface.materials.size(), 1);
    };
    if (!std::ranges::all_of(surface.materials, isUtf8)) {
        return owner + ": a material of the surface has a name that is not text in UTF-8.";
    }
    for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
        const std::string triangle = owner + ": triangle " + std::to_string(k) + " of the surface";
        if (Sentence fault = cornerFault(triangle, surface.triangles[k])) return fault;
        if (!isNamed(surface.triangles[k].material)) return triangle + " refers to a material that does not exist.";
    }
    for (const CapUv* cap : {&surface.front, &surface.back}) {
        const std::string name = owner + ": the surface's " + (cap == &surface.front ? "front" : "back") + " cap";
        if (!isNamed(cap->material)) return name + " refers to a material that does not exist.";
        for (const double coefficient : cap->map.coefficients) {
            if (Sentence fault = rangeFault(name, {{ProjectNumber::TextureCoordinate, coefficient, "UV map"}})) {
                return fault;
            }
        }
    }
    return std::nullopt;
}

Sentence levelFault(const std::string& owner, const Level& level) {
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::MinimumVolume, level.minimumVolume}})) {
        return fault;
    }
    if (Sentence fault = verifyPattern(level.pattern)) return owner + ": " + *fault;
    return std::nullopt;
}

/// Checks shaping, edits and settings of single fragments.
Sentence shapeFault(const Asset& asset) {
    if (Sentence fault = verifyShaping(asset.shaping)) return fault;
    for (const FragmentEdit& edit : asset.edits) {
        if (Sentence fault = verifyEdit(edit)) return fault;
    }
    const FragmentPath* before = nullptr;
    for (const FragmentLevel& leaf : asset.leaves) {
        if (!isFragmentPath(leaf.fragment)) return "\"" + leaf.fragment + "\" is not a fragment path.";
        if (before && *before >= leaf.fragment) {
            return "the settings of fragment " + leaf.fragment + " come after those of " + *before +
                   "; paths must ascend.";
        }
        before = &leaf.fragment;
    }
    return std::nullopt;
}

Sentence faultOf(const Asset& asset) {
    const std::string owner = ownerText("Asset", asset.id, asset.name);
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::Threshold, asset.threshold},
                                            {ProjectNumber::ContactTime, asset.contactTime.value_or(1.0)},
                                            {ProjectNumber::InsideUvScale, asset.insideUvScale}})) {
        return fault;
    }
    if (Sentence fault = prismRangeFault(owner, asset.prism)) return fault;
    if (const Result<Prism> prism = validated(asset.prism); !prism) return owner + ": " + prism.error().message;
    if (Sentence fault = verifyPattern(asset.pattern)) return owner + ": " + *fault;
    if (asset.surface) {
        if (Sentence fault = surfaceFault(owner, *asset.surface)) return fault;
    }
    for (const Level& level : asset.levels) {
        if (Sentence fault = levelFault(owner, level)) return fault;
    }
    if (Sentence fault = shapeFault(asset)) return owner + ": " + *fault;
    for (const FragmentLevel& leaf : asset.leaves) {
        if (!leaf.level) continue;
        if (Sentence fault = levelFault(owner, *leaf.level)) return fault;
    }
    return playFault(asset);
}

/// Valid numbers can still give a threshold that overflows.
Sentence thresholdFault(const Project& project) {
    for (const Asset& asset : project.assets) {
        if (Sentence fault =
                rangeFault(ownerText("Asset", asset.id, asset.name),
                           {{ProjectNumber::Threshold, thresholdOf(project, asset), "derived threshold"}})) {
            return fault;
        }
    }
    return std::nullopt;
}

Sentence faultOf(const Instance& instance) {
    const std::string owner = ownerText("Instance", instance.id, instance.name);
    if (Sentence fault = rangeFault(owner, ProjectNumber::InstancePosition, instance.pose.position)) return fault;
    const double length = glm::length(instance.pose.orientation);
    if (!(std::abs(length - 1.0) <= kUnitLengthTolerance)) {
        return owner + ": the orientation has the length " + messageText(length) + ", but it must be 1.";
    }
    return rangeFault(owner, {{ProjectNumber::Threshold, instance.threshold.value_or(1.0)}});
}

template <class Element>
Sentence firstFault(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
        if (Sentence fault = faultOf(element)) return fault;
    }
    return std::nullopt;
}

Sentence worldFault(const Project& project) {
    if (Sentence fault = rangeFault("The ground", {{ProjectNumber::GroundHeight, project.ground.height},
                                                   {ProjectNumber::Friction, project.ground.friction},
                                                   {ProjectNumber::Restitution, project.ground.restitution}})) {
        return fault;
    }
    if (Sentence fault = rangeFault("The project", ProjectNumber::Gravity, project.gravity)) return fault;
    return rangeFault("The project", {{ProjectNumber::Threshold, project.damage.thesisThreshold, "thesis threshold"}});
}

}  // namespace

std::optional<std::string> valueFault(const Project& project) {
    if (Sentence fault = firstFault(project.materials)) return fault;
    if (Sentence fault = firstFault(project.assets)) return fault;
    if (Sentence fault = thresholdFault(project)) return fault;
    if (Sentence fault = firstFault(project.instances)) return fault;
    if (Sentence fault = worldFault(project)) return fault;
    if (Sentence fault = faultOf(project.debris)) return fault;
    if (Sentence fault = firstFault(project.shots)) return fault;
    return firstFault(project.playTests);
}

}  // namespace rubble
