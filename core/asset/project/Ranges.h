#pragma once

#include "core/fracture/pieces/Prism.h"
#include "core/geometry/predicates/Vec.h"

#include <initializer_list>
#include <optional>
#include <string>

namespace rubble {

struct Asset;
struct CutAtImpact;

/// Every number of a project, except for the parameters of pattern layers (see LayerParameter::range); and the numbers
/// with which a project is imported, simulated and drawn.
enum class ProjectNumber {
    Density,
    Friction,  // of materials and the ground
    Restitution,
    TensileStrength,
    FractureToughness,
    YoungsModulus,
    ColourChannel,
    Opacity,
    PrismDepth,
    OutlineSize,        // width and height
    OutlineCoordinate,  // of outlines and surfaces
    TextureCoordinate,
    MinimumVolume,
    SmallPieceSize,      // area or volume
    SmallPieceFraction,  // of the mean or the whole
    Gap,
    HullInset,  // of collision hulls in exports
    RoughnessAmplitude,
    RoughnessFrequency,
    RoughnessOctaves,
    Threshold,  // of assets, instances and the thesis preset
    ContactTime,
    InsideUvScale,
    ImpactFragments,
    ImpactFalloffRadius,
    DropHeight,
    Mass,  // of projectiles and strength requirements
    HitSpeed,
    InstancePosition,
    InstanceVariant,
    GroundHeight,
    Gravity,
    DebrisLifetime,
    DebrisFade,
    DebrisFragments,
    EventEnergy,
    EventRecords,
    ShotPosition,
    ProjectileSize,
    ProjectileSpeed,
    HammerImpulse,  // along an axis
    HammerBlow,     // along the view
    HammerRadius,   // of the patch that a blow strikes
    BlastImpulse,
    BlastRadius,
    ShotTime,
    TestDuration,
    ExpectedTime,  // see numberOf(ExpectationKind)
    ExpectedFragments,
    ExpectedSpeed,
    ExpectedLoss,  // a fraction of the mass
    ExpectedHole,
    ExpectedValue,
    GrabForce,
    StepLength,
    Step,   // of a simulation; 0: its start
    Steps,  // a number of steps
    FrameRate,
    ImageSamples,
    ExplodeFactor,
    Exposure,  // of pictures
    Variants,
    MetresPerUnit,  // of a mesh file
    Threads,
    BondStrength,        // a factor: of levels, instances, brushes, heights and pictures
    BondImpulse,         // per area
    BondLoadRadius,      // of the load of a hit
    BondDamageFrom,      // a fraction of what a bond holds
    BondSpan,            // sideways to an anchor
    BondCollapseDelay,   //
    BondMinimumIsland,   // fragments
    BondBrushRadius,     //
    BondStrengthHeight,  // above the lowest point of the outline
    MortarTolerance,
    MortarLeastArea,
    BondClusterLevel,  // 0: the coarsest
};
inline constexpr int kProjectNumbers = 76;

/// The values that a number of a project can have. Files, command line, inspector and play read them here.
struct NumberRange {
    const char* name;  // in messages: "density"
    const char* unit;  // "kg/m³"; empty: none
    double min;
    double max;  // finite
    bool isMinExcluded;
    double defaultValue;
    const char* reason;           // of the limits
    double leastAboveZero = 0.0;  // smaller numbers are not allowed, except 0

    bool contains(double value) const;
};
const NumberRange& rangeOf(ProjectNumber number);
/// What a value must be: "from 0 to 1", "above 0 and at most 1", "0, or from 0.001 to 1".
std::string rangeText(const NumberRange& range);

enum class PieceMeasure;
/// The number of the minimum size of fragments.
ProjectNumber numberOf(PieceMeasure measure);
enum class ExpectationKind;
/// The number of the value of an expectation.
ProjectNumber numberOf(ExpectationKind kind);

/// A number of a project with its value, and its name if it differs from that in the table.
struct NumberValue {
    ProjectNumber number;
    double value;
    const char* name = nullptr;
};

/// The first of an owner's numbers that is out of its range, as a sentence: `Material 1 "brick": the density is 0, but
/// it must be from 0.001 to 1000000.`
std::optional<std::string> rangeFault(const std::string& owner, std::initializer_list<NumberValue> values);
/// The same for the components of a vector.
std::optional<std::string> rangeFault(const std::string& owner, ProjectNumber number, const Vec3& value,
                                      const char* name = nullptr);

/// The same for a prism: its depth, the coordinates of its outline and holes, and the outline's size.
std::optional<std::string> prismRangeFault(const std::string& owner, const Prism& prism);
/// The same of an asset's shape: a mesh has the ranges of outlines in all directions.
std::optional<std::string> shapeRangeFault(const std::string& owner, const Asset& asset);

/// A fault of the fracture at the impact. `owner`: `Asset 3 "wall"`.
std::optional<std::string> cutFault(const std::string& owner, const CutAtImpact& cut);

}  // namespace rubble
