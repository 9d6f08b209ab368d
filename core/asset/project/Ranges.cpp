#include "core/asset/project/Ranges.h"

#include "core/asset/project/Project.h"
#include "core/base/MessageText.h"

#include <array>

namespace rubble {
namespace {

constexpr const char* kNoNegative = "a negative value has no meaning";
constexpr const char* kPositive = "zero would make the quantity vanish";
constexpr const char* kAny = "either sign is a valid direction or position";
constexpr const char* kFraction = "a fraction of one";
constexpr double kMaxSteps = 1e7;
constexpr const char* kStepLimitText = "two days at 60 steps a second";

// The simulation's limits: single precision resolves 8 mm at 100 km, 170 m are a step at 10 km/s, and squares and
// products of masses in this range do not overflow. The same numbers are in core/physics, which this module does not
// use; RangesTest compares them.
constexpr double kMaxCoordinate = 1e5;              // m
constexpr double kMaxSpeed = 1e4;                   // m/s
constexpr double kMinMass = 1e-9, kMaxMass = 1e15;  // kg
constexpr double kMaxDensity = 1e6, kMaxFriction = 1e3;
constexpr double kMaxBlow = 1e15;                      // N·s; it moves a mountain at 1 m/s
constexpr double kMinExtent = 1e-5, kMaxExtent = 1e4;  // m: a hundredth of a millimetre, a mountain
constexpr double kMinOffset = 1e-6;                    // m, of corners: far above rounding at kMaxCoordinate

constexpr NumberRange between(const char* name, const char* unit, double min, double max, double defaultValue,
                              const char* reason = kPositive) {
    return {name, unit, min, max, false, defaultValue, reason};
}
constexpr NumberRange aboveZero(const char* name, const char* unit, double max, double defaultValue,
                                const char* reason = kPositive) {
    return {name, unit, 0.0, max, true, defaultValue, reason};
}
constexpr NumberRange zeroOrAbove(const char* name, const char* unit, double max, double defaultValue,
                                  const char* reason = kNoNegative) {
    return {name, unit, 0.0, max, false, defaultValue, reason};
}
constexpr NumberRange eitherSign(const char* name, const char* unit, double max, double defaultValue) {
    return {name, unit, -max, max, false, defaultValue, kAny};
}

// In the order of ProjectNumber.
constexpr std::array<NumberRange, kProjectNumbers> kRanges{{
    between("density", "kg/m³", 1e-3, kMaxDensity, 1000.0, "a thousandth of air; fifty times the densest metal"),
    zeroOrAbove("friction", "", kMaxFriction, 0.6, "Coulomb friction only opposes motion; rough materials exceed 1"),
    {"restitution", "", 0.0, 1.0, false, 0.0, "above 1 an impact would add energy"},
    between("tensile strength", "Pa", 1.0, 1e12, 1e6, "the strongest fibre has 1e11"),
    between("fracture toughness", "Pa·√m", 1e-3, 1e12, 1e6, "steel has 1e8"),
    between("Young's modulus", "Pa", 1.0, 1e13, 1e10, "diamond has 1e12"),
    {"colour", "", 0.0, 1.0, false, 0.8, kFraction},
    {"opacity", "", 0.05, 1.0, false, 1.0, "what is fainter cannot be seen"},
    between("depth", "m", kMinExtent, kMaxExtent, 0.5, "a prism needs volume"),
    between("size", "m", kMinExtent, kMaxExtent, 1.0, "an outline needs area"),
    eitherSign("coordinate", "m", kMaxCoordinate, 0.0),
    eitherSign("texture coordinate", "", 1e9, 0.0),
    zeroOrAbove("minimum volume", "m³", 1e12, 0.0),
    aboveZero("minimum size of fragments", "", 1e12, 0.1, "nothing is smaller than zero"),
    {"minimum size of fragments", "", 0.0, 1.0, true, 0.1, kFraction},
    {"gap", "m", 0.0, kMaxExtent, false, 0.0, "smaller gaps are lost in rounding", kMinOffset},
    zeroOrAbove("inset", "m", 1.0, 1e-4, "0 lets hulls touch; a hundredth of the thinnest width is the most"),
    {"roughness", "m", 0.0, kMaxExtent, false, 0.0, "0 leaves cuts straight; smaller bumps are lost in rounding",
     kMinOffset},
    between("frequency", "1/m", 1e-6, 1e6, 10.0),
    {"octaves", "", 1.0, Roughness::kMaxOctaves, false, 3.0, "each octave halves the bumps; more than 8 are invisible"},
    between("threshold", "N·s", 1e-9, 1e24, 100.0, "at zero a body would break at rest"),
    between("contact time", "s", 1e-9, 1e3, 1e-3),
    between("inside UV scale", "1/m", 1e-6, 1e6, 1.0),
    {"pieces", "", CutAtImpact::kMinFragments, CutAtImpact::kMaxFragments, false, 30.0,
     "a fracture has at least two fragments; more than the maximum take longer than a step"},
    between("falloff radius of the fracture at the impact", "m", 1e-9, kMaxCoordinate, 0.3),
    between("height", "m", 1e-6, kMaxCoordinate, 1.0, "a drop needs a height"),
    between("mass", "kg", kMinMass, kMaxMass, 10.0, "a body needs mass"),
    aboveZero("speed", "m/s", kMaxSpeed, 10.0, "a hit needs a speed"),
    eitherSign("position", "m", kMaxCoordinate, 0.0),
    {"variant", "", 0.0, 4294967295.0, false, 0.0, "a 32-bit number; 0 is the asset's own pattern"},
    eitherSign("height", "m", 1000.0, 0.0),
    eitherSign("gravity", "m/s²", 1000.0, -9.81),
    between("lifetime", "s", 1e-9, 1e9, 10.0),
    zeroOrAbove("fade", "s", 1e9, 1.0),
    {"maximum number of fragments", "", 1.0, 4294967295.0, false, 1000.0,
     "a 32-bit count; without debris use a lifetime"},
    zeroOrAbove("least energy", "J", 1e15, 1.0, "0 reports every impact"),
    {"maximum number per step", "", 1.0, 1e6, false, 16.0, "the rest of a step is counted and summed"},
    eitherSign("place", "m", kMaxCoordinate, 0.0),
    between("size", "m", 1e-3, 1e3, 0.5, "a projectile needs volume; larger ones are no projectiles"),
    zeroOrAbove("speed", "m/s", kMaxSpeed, 10.0, "the direction is given by the target"),
    eitherSign("impulse", "N·s", kMaxBlow, 0.0),
    aboveZero("impulse", "N·s", kMaxBlow, 1000.0, "the direction is given by the view"),
    between("radius", "m", 1e-3, 1e3, 0.1, "smaller than a nail; larger than what a tool strikes"),
    zeroOrAbove("impulse", "N·s/m²", kMaxBlow, 1000.0, "a blast pushes outwards"),
    between("radius", "m", 1e-3, kMaxCoordinate, 2.0),
    zeroOrAbove("time", "s", 1e5, 0.0, "a test starts at 0 and lasts a day at most"),
    between("duration", "s", 1e-5, 1e5, 5.0, "from the shortest step to a day"),
    zeroOrAbove("expected value", "s", 1e5, 1.0, "a test starts at 0 and lasts a day at most"),
    {"expected value", "", 0.0, 4294967295.0, false, 1.0, "a 32-bit count"},
    zeroOrAbove("expected value", "m/s", kMaxSpeed, 0.0),
    {"expected value", "", 0.0, 1.0, false, 0.1, "a fraction of the mass: 1 is all of it"},
    zeroOrAbove("expected value", "m", kMaxExtent, 0.5, "no prism is wider"),
    eitherSign("expected value", "", kMaxCoordinate, 0.0),
    aboveZero("force", "N", 1e15, 1000.0),
    {"step length", "s", 1e-5, 0.1, false, 1.0 / 60.0,
     "rounding dominates shorter steps; longer ones do not resolve motion"},
    {"step", "", 0.0, kMaxSteps, false, 0.0, kStepLimitText},
    {"number of steps", "", 1.0, kMaxSteps, false, 60.0, kStepLimitText},
    {"frame rate", "1/s", 1.0, 240.0, false, 60.0, "no screen shows more"},
    {"number of samples", "", 0.0, 4096.0, false, 0.0, "more change no pixel"},
    {"explode factor", "", 0.0, 100.0, false, 0.0, "1 doubles the distances; farther, fragments vanish"},
    {"exposure", "stops", -8.0, 8.0, false, 0.0, "beyond, pictures are black or white"},
    {"number of variants", "", 1.0, 1000.0, false, 12.0, "each is fractured and drawn"},
    between("unit", "m", 1e-6, 1e6, 1.0, "a mesh needs a size"),
    {"number of threads", "", 1.0, 1024.0, false, 1.0, "no processor has more"},
    zeroOrAbove("bond strength", "", 1e6, 1.0, "0 holds nothing; what is a million times as strong holds any hit"),
    between("impulse per area", "N·s/m²", 1e-9, kMaxBlow, 500.0, "at zero a bond would break at rest"),
    between("radius of hits on bonds", "m", 1e-3, kMaxCoordinate, 0.3, "within it a hit must reach a bond"),
    {"load that leaves damage", "", 0.0, 1.0, true, 0.5, "a fraction of what a bond holds; at 0 rest would wear it"},
    zeroOrAbove("span", "m", kMaxCoordinate, 0.0, "0 is any distance"),
    zeroOrAbove("collapse delay", "s", 1e5, 0.2, "nothing is played longer than a day"),
    {"least island", "", 1.0, 4294967295.0, false, 1.0, "a 32-bit count; an island has at least one fragment"},
    between("brush radius", "m", kMinExtent, kMaxExtent, 0.1, "a brush must touch something; no prism is larger"),
    zeroOrAbove("height", "m", kMaxExtent, 0.0, "heights count from the lowest point; no prism is higher"),
    zeroOrAbove("widest joint", "m", 1.0, 0.005, "faces that are farther apart do not lie against each other"),
    zeroOrAbove("least area", "m²", kMaxExtent* kMaxExtent, 1e-4, "0 joins every face; no prism has a larger one"),
    {"level of a cluster", "", 0.0, 9.0, false, 0.0, "the levels break one after the other; 0 is the coarsest"},
}};

std::string nameOf(ProjectNumber number, const char* name) { return name ? name : rangeOf(number).name; }

}  // namespace

bool NumberRange::contains(double value) const {
    if (value > 0.0 && value < leastAboveZero) return false;
    return (isMinExcluded ? value > min : value >= min) && value <= max;  // false for NaN
}

const NumberRange& rangeOf(ProjectNumber number) { return kRanges[static_cast<std::size_t>(number)]; }

std::string rangeText(const NumberRange& range) {
    const std::string max = messageText(range.max);
    if (range.leastAboveZero > 0.0) return "0, or from " + messageText(range.leastAboveZero) + " to " + max;
    const std::string min = messageText(range.min);
    return range.isMinExcluded ? "above " + min + " and at most " + max : "from " + min + " to " + max;
}

ProjectNumber numberOf(PieceMeasure measure) {
    const bool isFraction = measure == PieceMeasure::FractionOfMean || measure == PieceMeasure::FractionOfWhole;
    return isFraction ? ProjectNumber::SmallPieceFraction : ProjectNumber::SmallPieceSize;
}

ProjectNumber numberOf(ExpectationKind kind) {
    switch (kind) {
        case ExpectationKind::StandsUntouched: return ProjectNumber::ExpectedTime;
        case ExpectationKind::BreaksIntoAtLeast: return ProjectNumber::ExpectedFragments;
        case ExpectationKind::NothingFaster: return ProjectNumber::ExpectedSpeed;
        case ExpectationKind::StaysUp: return ProjectNumber::ExpectedLoss;
        case ExpectationKind::HoleAtMost: return ProjectNumber::ExpectedHole;
        default: return ProjectNumber::ExpectedValue;
    }
}

std::optional<std::string> rangeFault(const std::string& owner, std::initializer_list<NumberValue> values) {
    for (const auto& [number, value, name] : values) {
        const NumberRange& range = rangeOf(number);
        if (range.contains(value)) continue;
        return owner + ": the " + nameOf(number, name) + " is " + messageText(value) + ", but it must be " +
               rangeText(range) + ".";
    }
    return std::nullopt;
}

std::optional<std::string> rangeFault(const std::string& owner, ProjectNumber number, const Vec3& value,
                                      const char* name) {
    const NumberRange& range = rangeOf(number);
    if (range.contains(value.x) && range.contains(value.y) && range.contains(value.z)) return std::nullopt;
    return owner + ": the " + nameOf(number, name) + " is (" + messageText(value.x) + ", " + messageText(value.y) +
           ", " + messageText(value.z) + "), but it must be " + rangeText(range) + ".";
}

std::optional<std::string> prismRangeFault(const std::string& owner, const Prism& prism) {
    if (auto fault = rangeFault(owner, {{ProjectNumber::PrismDepth, prism.depth}})) return fault;
    const auto ringFault = [&](const Ring& ring, const std::string& name) -> std::optional<std::string> {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::string point = " of point " + std::to_string(k) + " of " + name;
            const std::string x = "x" + point, y = "y" + point;
            if (auto fault = rangeFault(owner, {{ProjectNumber::OutlineCoordinate, ring[k].x, x.c_str()},
                                                {ProjectNumber::OutlineCoordinate, ring[k].y, y.c_str()}})) {
                return fault;
            }
        }
        return std::nullopt;
    };
    const Polygon& outline = prism.outline;
    if (auto fault = ringFault(outline.outer, "the outline")) return fault;
    for (std::size_t k = 0; k < outline.holes.size(); ++k) {
        if (auto fault = ringFault(outline.holes[k], "hole " + std::to_string(k))) return fault;
    }
    if (outline.outer.size() < 3) return std::nullopt;  // reported by validated()
    const Box2 bounds = boundsOf(outline.outer);
    return rangeFault(owner, {{ProjectNumber::OutlineSize, bounds.max.x - bounds.min.x, "width of the outline"},
                              {ProjectNumber::OutlineSize, bounds.max.y - bounds.min.y, "height of the outline"}});
}

std::optional<std::string> shapeRangeFault(const std::string& owner, const Asset& asset) {
    const ClosedMesh* mesh = asset.mesh();
    if (!mesh) return prismRangeFault(owner, asset.prism());
    constexpr std::array kAxes{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = mesh->bounds.min[axis], high = mesh->bounds.max[axis];
        const std::string along = std::string(" of the mesh along ") + kAxes[static_cast<std::size_t>(axis)];
        const std::string size = "size" + along, place = "coordinate" + along;
        if (auto fault = rangeFault(owner, {{ProjectNumber::OutlineCoordinate, low, place.c_str()},
                                            {ProjectNumber::OutlineCoordinate, high, place.c_str()},
                                            {ProjectNumber::OutlineSize, high - low, size.c_str()}})) {
            return fault;
        }
    }
    return std::nullopt;
}

std::optional<std::string> cutFault(const std::string& owner, const CutAtImpact& cut) {
    if (!rangeOf(ProjectNumber::ImpactFragments).contains(cut.fragments)) {
        return owner + ": the number of fragments of the fracture at the impact is " + std::to_string(cut.fragments) +
               ", but it must be from " + std::to_string(CutAtImpact::kMinFragments) + " to " +
               std::to_string(CutAtImpact::kMaxFragments) + ".";
    }
    return rangeFault(owner, {{ProjectNumber::ImpactFalloffRadius, cut.falloffRadius}});
}

}  // namespace rubble
