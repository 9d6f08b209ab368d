#include "core/asset/project/Shaping.h"

#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"

#include <cmath>

namespace rubble {

FragmentPath parentOf(const FragmentEdit& edit) {
    const auto* merge = std::get_if<FragmentMerge>(&edit);
    return parentOf(merge ? merge->into : std::get<FragmentSplit>(edit).fragment);
}

std::optional<std::string> verifyShaping(const Shaping& shaping) {
    const SmallPieces& small = shaping.smallPieces;
    if (const NumberRange& range = rangeOf(numberOf(small.measure)); !range.contains(small.limit)) {
        return std::string("The ") + range.name + " is " + messageText(small.limit) + ", but it must be " +
               rangeText(range) + ".";
    }
    const Roughness& roughness = shaping.roughness;
    if (auto fault = rangeFault("The shape of fragments", {{ProjectNumber::Gap, shaping.gap},
                                                           {ProjectNumber::RoughnessAmplitude, roughness.amplitude},
                                                           {ProjectNumber::RoughnessFrequency, roughness.frequency}})) {
        return fault;
    }
    if (rangeOf(ProjectNumber::RoughnessOctaves).contains(roughness.octaves)) return std::nullopt;
    return "The roughness has " + std::to_string(roughness.octaves) + " octaves, but it must have from 1 to " +
           std::to_string(Roughness::kMaxOctaves) + ".";
}

std::optional<std::string> verifyEdit(const FragmentEdit& edit) {
    const auto pathFault = [](const FragmentPath& path) -> std::optional<std::string> {
        if (isFragmentPath(path)) return std::nullopt;
        return quotedName(path) + " is not a fragment path.";
    };
    if (const auto* split = std::get_if<FragmentSplit>(&edit)) {
        if (auto fault = pathFault(split->fragment)) return fault;
        const Line& line = split->line;
        const double length = std::abs(line.direction.x) + std::abs(line.direction.y);
        const bool isLine =
            std::isfinite(line.point.x) && std::isfinite(line.point.y) && length > 0.0 && length < 1e300;
        if (isLine) return std::nullopt;
        return "The line that splits fragment " + split->fragment + " has no direction, or is not finite.";
    }
    const auto& merge = std::get<FragmentMerge>(edit);
    if (auto fault = pathFault(merge.into)) return fault;
    for (const FragmentPath& path : merge.merged) {
        if (auto fault = pathFault(path)) return fault;
        if (parentOf(path) != parentOf(merge.into) || path == merge.into) {
            return "Fragment " + path + " cannot be merged into " + merge.into + ": they are not siblings.";
        }
    }
    return std::nullopt;
}

}  // namespace rubble
