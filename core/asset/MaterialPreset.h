#pragma once

#include "core/asset/Project.h"

#include <optional>
#include <string>
#include <utility>

namespace rubble {

/// A number of a preset, and where it is from.
struct PresetFigure {
    double value = 0.0;
    std::optional<std::pair<double, double>> range;  // between which others measured or require it; holds the value
    std::string source;                              // author, title, year, place; empty: not told
    bool operator==(const PresetFigure&) const = default;
};

/// A material of a library: what projects take copies of.
struct MaterialPreset {
    std::string name;
    std::string note;      // what exactly it stands for: "Structural concrete C30/37"
    PresetFigure density;  // this and the following: as of Material
    PresetFigure friction;
    PresetFigure restitution;
    std::optional<PresetFigure> tensileStrength;
    std::optional<PresetFigure> fractureToughness;
    Colour outside;
    Colour inside;
    Pattern pattern;  // in which it usually breaks; layers have the ids 1, 2, ...; none: not told
    bool operator==(const MaterialPreset&) const = default;
};

/// What keeps a preset from being used, as a sentence: no name, numbers out of range, a range without its value, a pattern with a
/// fault.
std::optional<std::string> verifyPreset(const MaterialPreset& preset);

/// The material that a project keeps of a preset.
Material materialOf(const MaterialPreset& preset, Id id);

/// The pattern of a preset for an outline with these bounds: what lies at a place (a centre, the origin of bricks) lies where it does in
/// a layer that is new there, all else is as told. Layers keep the preset's ids.
Pattern patternWithin(const MaterialPreset& preset, const Box2& bounds);

/// A preset of a material as a project has it, without sources; `pattern` is of an asset that is made of it, its layers numbered anew.
MaterialPreset presetOf(const Material& material, Pattern pattern);

}  // namespace rubble
