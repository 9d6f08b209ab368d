#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>
#include <utility>

namespace rubble {

/// A number of a preset and its source.
struct PresetFigure {
    double value = 0.0;
    std::optional<std::pair<double, double>> range;  // of published values; contains `value`
    std::string source;                              // author, title, year, page; empty: unknown
    bool operator==(const PresetFigure&) const = default;
};

/// A material of a library. Projects keep copies of it.
struct MaterialPreset {
    std::string name;
    std::string note;      // what exactly it describes: "Structural concrete C30/37"
    PresetFigure density;  // this and the following: as in Material
    PresetFigure friction;
    PresetFigure restitution;
    std::optional<PresetFigure> tensileStrength;
    std::optional<PresetFigure> fractureToughness;
    std::optional<PresetFigure> youngsModulus;
    Colour outside;
    Colour inside;
    double opacity = 1.0;
    Finish finish = Finish::Plain;
    Pattern pattern;                         // its typical fracture, with layer ids 1, 2, ...; may be empty
    Roughness roughness;                     // of cuts along that pattern
    std::optional<CutAtImpact> cutAtImpact;  // brittle ones crack where they are hit
    bool operator==(const MaterialPreset&) const = default;
};

/// The first fault that keeps a preset from being used, as a sentence, or nothing: a missing name, numbers out of
/// range, a range without its value, a pattern with a fault.
std::optional<std::string> verifyPreset(const MaterialPreset& preset);

/// The material of a project for a preset.
Material materialOf(const MaterialPreset& preset, Id id);

/// The pattern of a preset for an outline with these bounds: points (a centre, the origin of bricks) take the values of
/// a new layer there, other parameters and layer ids those of the preset. `height`: the z of such points in a closed
/// mesh, m.
Pattern patternWithin(const MaterialPreset& preset, const Box2& bounds, double height = 0.0);

/// A preset of a project's material, without sources. `asset` of this material gives the pattern, whose layers are
/// renumbered, the roughness and the cut; null: none.
MaterialPreset presetOf(const Material& material, const Asset* asset);

}  // namespace rubble
