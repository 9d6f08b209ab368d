#include "core/asset/project/Ranges.h"

#include "core/asset/project/Project.h"
#include "core/base/MessageText.h"

#include <array>
#include <limits>

namespace rubble {
namespace {

// Any finite number: the range has no tighter bound yet.
constexpr double kLargest = std::numeric_limits<double>::max();

constexpr const char* kNoNegative = "a negative value has no meaning";
constexpr const char* kPositive = "zero would make the quantity vanish";
constexpr const char* kAny = "either sign is a valid direction or position";
constexpr const char* kFraction = "a fraction of one";
constexpr double kMaxSteps = 1e7;
constexpr const char* kMostSteps = "two days at 60 steps a second";

/// The range of a number that is above zero.
constexpr NumberRange aboveZero(const char* name, const char* unit, double defaultValue,
                                const char* reason = kPositive) {
    return {name, unit, 0.0, kLargest, true, defaultValue, reason};
}
constexpr NumberRange zeroOrAbove(const char* name, const char* unit, double defaultValue,
                                  const char* reason = kNoNegative) {
    return {name, unit, 0.0, kLargest, false, defaultValue, reason};
}
constexpr NumberRange finite(const char* name, const char* unit, double defaultValue) {
    return {name, unit, -kLargest, kLargest, false, defaultValue, kAny};
}

// In the order of ProjectNumber.
constexpr std::array<NumberRange, kProjectNumbers> kRanges{{
    aboveZero("density", "kg/m³", 1000.0, "a body needs mass"),
    zeroOrAbove("friction", "", 0.6, "Coulomb friction only opposes motion; rough materials exceed 1"),
    {"restitution", "", 0.0, 1.0, false, 0.0, "above 1 an impact would add energy"},
    aboveZero("tensile strength", "Pa", 1e6),
    aboveZero("fracture toughness", "Pa·√m", 1e6),
    {"colour", "", 0.0, 1.0, false, 0.8, kFraction},
    aboveZero("depth", "m", 0.5, "a prism needs volume"),
    aboveZero("size", "m", 1.0, "an outline needs area"),
    zeroOrAbove("minimum volume", "m³", 0.0),
    aboveZero("minimum size of fragments", "", 0.1, "nothing is smaller than zero"),
    {"minimum size of fragments", "", 0.0, 1.0, true, 0.1, kFraction},
    zeroOrAbove("gap", "m", 0.0),
    zeroOrAbove("roughness", "m", 0.0, "0 leaves cuts straight"),
    aboveZero("frequency", "1/m", 10.0),
    {"octaves", "", 1.0, Roughness::kMaxOctaves, false, 3.0, "each octave halves the bumps; more than 8 are invisible"},
    aboveZero("threshold", "N·s", 100.0, "at zero a body would break at rest"),
    aboveZero("contact time", "s", 1e-3),
    aboveZero("inside UV scale", "1/m", 1.0),
    {"pieces", "", CutAtImpact::kMinPieces, CutAtImpact::kMaxPieces, false, 30.0,
     "a fracture has at least two fragments; more than the maximum take longer than a step"},
    aboveZero("falloff radius of the fracture at the impact", "m", 0.3),
    aboveZero("height", "m", 1.0, "a drop needs a height"),
    aboveZero("mass", "kg", 10.0, "a body needs mass"),
    aboveZero("speed", "m/s", 10.0, "a hit needs a speed"),
    finite("position", "m", 0.0),
    {"variant", "", 0.0, 4294967295.0, false, 0.0, "a 32-bit number; 0 is the asset's own pattern"},
    finite("height", "m", 0.0),
    finite("gravity", "m/s²", -9.81),
    aboveZero("lifetime", "s", 10.0),
    zeroOrAbove("fade", "s", 1.0),
    {"maximum number of fragments", "", 1.0, 4294967295.0, false, 1000.0,
     "a 32-bit count; without debris use a lifetime"},
    finite("place", "m", 0.0),
    aboveZero("size", "m", 0.5, "a projectile needs volume"),
    zeroOrAbove("speed", "m/s", 10.0, "the direction is given by the target"),
    finite("impulse", "N·s", 0.0),
    aboveZero("impulse", "N·s", 1000.0, "the direction is given by the view"),
    zeroOrAbove("impulse", "N·s", 1000.0, "an explosion pushes outwards"),
    aboveZero("radius", "m", 2.0),
    zeroOrAbove("time", "s", 0.0, "a play-test starts at 0"),
    aboveZero("duration", "s", 5.0),
    zeroOrAbove("expected value", "s", 1.0, "a play-test starts at 0"),
    {"expected value", "", 0.0, 4294967295.0, false, 1.0, "a 32-bit count"},
    zeroOrAbove("expected value", "m/s", 0.0),
    finite("expected value", "", 0.0),
    aboveZero("force", "N", 1000.0),
    {"step length", "s", 1e-5, 0.1, false, 1.0 / 60.0,
     "rounding dominates shorter steps; longer ones do not resolve motion"},
    {"step", "", 0.0, kMaxSteps, false, 0.0, kMostSteps},
    {"number of steps", "", 1.0, kMaxSteps, false, 60.0, kMostSteps},
    {"frame rate", "1/s", 1.0, 240.0, false, 60.0, "no screen shows more"},
    {"number of samples", "", 0.0, 4096.0, false, 0.0, "more change no pixel"},
    {"explode factor", "", 0.0, 100.0, false, 0.0, "1 doubles the distances; farther, fragments vanish"},
    {"number of variants", "", 1.0, 1000.0, false, 12.0, "each is fractured and drawn"},
    aboveZero("unit", "m", 1.0, "a mesh needs a size"),
    {"number of threads", "", 1.0, 1024.0, false, 1.0, "no processor has more"},
}};

std::string nameOf(ProjectNumber number, const char* name) { return name ? name : rangeOf(number).name; }

}  // namespace

bool NumberRange::contains(double value) const {
    return (isMinExcluded ? value > min : value >= min) && value <= max;  // false for NaN
}

const NumberRange& rangeOf(ProjectNumber number) { return kRanges[static_cast<std::size_t>(number)]; }

std::string rangeText(const NumberRange& range) {
    if (range.max < kLargest) {
        const std::string min = messageText(range.min), max = messageText(range.max);
        return range.isMinExcluded ? "above " + min + " and at most " + max : "from " + min + " to " + max;
    }
    if (range.min < 0.0) return "finite";
    return range.isMinExcluded ? "finite and above zero" : "finite and not below zero";
}

ProjectNumber numberOf(PieceMeasure measure) {
    const bool isFraction = measure == PieceMeasure::FractionOfMean || measure == PieceMeasure::FractionOfWhole;
    return isFraction ? ProjectNumber::SmallPieceFraction : ProjectNumber::SmallPieceSize;
}

ProjectNumber numberOf(ExpectationKind kind) {
    switch (kind) {
        case ExpectationKind::StandsUntouched: return ProjectNumber::ExpectedTime;
        case ExpectationKind::BreaksIntoAtLeast: return ProjectNumber::ExpectedPieces;
        case ExpectationKind::NothingFaster: return ProjectNumber::ExpectedSpeed;
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

}  // namespace rubble
