#pragma once

#include "core/geometry/predicates/Vec.h"

#include <initializer_list>
#include <optional>
#include <string>

namespace rubble {

/// Every number of a project, except for the parameters of pattern layers: see LayerParameter::range.
enum class ProjectNumber {
    Density,
    Friction,  // of materials and the ground
    Restitution,
    TensileStrength,
    FractureToughness,
    ColourChannel,
    PrismDepth,
    OutlineSize,
    MinimumVolume,
    Gap,
    RoughnessAmplitude,
    RoughnessFrequency,
    RoughnessOctaves,
    Threshold,  // of assets, instances and the thesis preset
    ContactTime,
    InsideUvScale,
    ImpactPieces,
    ImpactFalloffRadius,
    DropHeight,
    Mass,  // of projectiles and strength requirements
    HitSpeed,
    InstancePosition,
    GroundHeight,
    Gravity,
    DebrisLifetime,
    DebrisFade,
    DebrisPieces,
    ShotPosition,
    ProjectileSize,
    ProjectileSpeed,
    HammerImpulse,
    ExplosionImpulse,
    ExplosionRadius,
    ShotTime,
    TestDuration,
    ExpectedValue,
    GrabForce,
};
inline constexpr int kProjectNumbers = 37;

/// The values that a number of a project can have. Files, command line, inspector and play read them here.
struct NumberRange {
    const char* name;  // in messages: "density"
    const char* unit;  // "kg/m³"; empty: none
    double min;
    double max;  // finite
    bool isMinExcluded;
    double defaultValue;
    const char* reason;  // of the limits

    bool contains(double value) const;
};
const NumberRange& rangeOf(ProjectNumber number);

/// A number of a project with its value, and its name where it is not that of the table.
struct NumberValue {
    ProjectNumber number;
    double value;
    const char* name = nullptr;
};

/// The first of an owner's numbers that is out of its range, as a sentence: `Material 1 "brick": the density is 0, but
/// it must be finite and above zero.`
std::optional<std::string> rangeFault(const std::string& owner, std::initializer_list<NumberValue> values);
/// The same for the components of a vector.
std::optional<std::string> rangeFault(const std::string& owner, ProjectNumber number, const Vec3& value,
                                      const char* name = nullptr);

}  // namespace rubble
