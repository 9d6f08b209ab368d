#include "core/asset/library/MaterialPreset.h"

#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/Utf8.h"
#include "core/fracture/pattern/PatternKind.h"

#include <array>
#include <cmath>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

/// A figure with its name in messages.
struct NamedFigure {
    ProjectNumber number;
    const PresetFigure* figure;  // null: unknown
};

std::array<NamedFigure, 6> figuresOf(const MaterialPreset& preset) {
    const auto optional = [](const std::optional<PresetFigure>& figure) { return figure ? &*figure : nullptr; };
    return {{{ProjectNumber::Density, &preset.density},
             {ProjectNumber::Friction, &preset.friction},
             {ProjectNumber::Restitution, &preset.restitution},
             {ProjectNumber::TensileStrength, optional(preset.tensileStrength)},
             {ProjectNumber::FractureToughness, optional(preset.fractureToughness)},
             {ProjectNumber::YoungsModulus, optional(preset.youngsModulus)}}};
}

Sentence figureFault(const std::string& owner, const NamedFigure& named) {
    const PresetFigure& figure = *named.figure;
    const std::string name = rangeOf(named.number).name;
    if (Sentence fault = rangeFault(owner, {{named.number, figure.value}})) return fault;
    if (!isUtf8(figure.source)) return owner + ": the source of the " + name + " is not text in UTF-8.";
    if (!figure.range) return std::nullopt;
    const auto [low, high] = *figure.range;
    if (low <= figure.value && figure.value <= high && std::isfinite(low) && std::isfinite(high)) return std::nullopt;
    return owner + ": the " + name + " is " + messageText(figure.value) + ", but its range goes from " +
           messageText(low) + " to " + messageText(high) + ".";
}

Sentence colourFault(const std::string& owner, const char* name, const Colour& colour) {
    const std::string whole = std::string(name) + " colour";
    for (const double value : {colour.red, colour.green, colour.blue}) {
        if (Sentence fault = rangeFault(owner, {{ProjectNumber::ColourChannel, value, whole.c_str()}})) return fault;
    }
    return std::nullopt;
}

void numberLayers(Pattern& pattern) {
    Id next = 1;
    for (PatternLayer& layer : pattern.layers) layer.id = next++;
}

}  // namespace

std::optional<std::string> verifyPreset(const MaterialPreset& preset) {
    if (preset.name.empty()) return "The material has no name.";
    if (!isUtf8(preset.name) || !isUtf8(preset.note))
        return "The material has a name or note that is not text in UTF-8.";
    const std::string owner = "Material " + quotedName(preset.name);
    for (const NamedFigure& named : figuresOf(preset)) {
        if (named.figure == nullptr) continue;
        if (Sentence fault = figureFault(owner, named)) return fault;
    }
    if (Sentence fault = colourFault(owner, "outside", preset.outside)) return fault;
    if (Sentence fault = colourFault(owner, "inside", preset.inside)) return fault;
    if (Sentence fault = rangeFault(owner, {{ProjectNumber::Opacity, preset.opacity}})) return fault;
    for (std::size_t k = 0; k < preset.pattern.layers.size(); ++k) {
        if (preset.pattern.layers[k].id == k + 1) continue;
        return owner + ": layer " + std::to_string(k + 1) + " of the pattern has the id " +
               std::to_string(preset.pattern.layers[k].id) + "; those of a preset are 1, 2, 3 and so on.";
    }
    if (Sentence fault = verifyPattern(preset.pattern)) return owner + ": " + *fault;
    if (Sentence fault = verifyShaping({.roughness = preset.roughness})) return owner + ": " + *fault;
    return preset.cutAtImpact ? cutFault(owner, *preset.cutAtImpact) : std::nullopt;
}

Material materialOf(const MaterialPreset& preset, Id id) {
    const auto valueOf = [](const std::optional<PresetFigure>& figure) {
        return figure ? std::optional(figure->value) : std::nullopt;
    };
    return {.id = id,
            .name = preset.name,
            .density = preset.density.value,
            .friction = preset.friction.value,
            .restitution = preset.restitution.value,
            .tensileStrength = valueOf(preset.tensileStrength),
            .fractureToughness = valueOf(preset.fractureToughness),
            .youngsModulus = valueOf(preset.youngsModulus),
            .outside = preset.outside,
            .inside = preset.inside,
            .opacity = preset.opacity,
            .finish = preset.finish};
}

Pattern patternWithin(const MaterialPreset& preset, const Box2& bounds, double height) {
    Pattern pattern = preset.pattern;
    for (PatternLayer& layer : pattern.layers) {
        const PatternKind& kind = kindOf(layer.parameters);
        const LayerParameters defaults = kind.defaultsFor(bounds);
        for (const LayerParameter& parameter : kind.parameters) {
            if (parameter.type == ParameterType::Point) parameter.write(layer.parameters, parameter.read(defaults));
            if (parameter.isHeight) parameter.write(layer.parameters, height);
        }
    }
    return pattern;
}

MaterialPreset presetOf(const Material& material, const Asset* asset) {
    const auto figureOf = [](const std::optional<double>& value) {
        return value ? std::optional(PresetFigure{.value = *value}) : std::nullopt;
    };
    Pattern pattern = asset != nullptr ? asset->pattern : Pattern();
    numberLayers(pattern);
    return {.name = material.name,
            .density = *figureOf(material.density),
            .friction = *figureOf(material.friction),
            .restitution = *figureOf(material.restitution),
            .tensileStrength = figureOf(material.tensileStrength),
            .fractureToughness = figureOf(material.fractureToughness),
            .youngsModulus = figureOf(material.youngsModulus),
            .outside = material.outside,
            .inside = material.inside,
            .opacity = material.opacity,
            .finish = material.finish,
            .pattern = std::move(pattern),
            .roughness = asset != nullptr ? asset->shaping.roughness : Roughness(),
            .cutAtImpact = asset != nullptr ? asset->cutAtImpact : std::nullopt};
}

}  // namespace rubble
