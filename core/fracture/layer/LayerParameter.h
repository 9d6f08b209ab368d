#pragma once

#include "core/fracture/layer/SeedId.h"
#include "core/fracture/sampling/SeedCount.h"

#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace rubble {

/// The physical quantity of a parameter, which determines its unit.
enum class Quantity { Number, Length, Angle };  // -; m; rad

/// The valid numbers of a parameter.
struct ParameterRange {
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    bool isMinExcluded = false;  // min itself is not allowed
    bool contains(double value) const { return (isMinExcluded ? value > min : value >= min) && value <= max; }
};

/// The range of a parameter's slider; no slider if both ends are equal.
struct SliderRange {
    double from = 0.0;
    double to = 0.0;
    bool isLogarithmic = false;
};

/// One of the values of an enumerated parameter.
struct ParameterOption {
    std::string_view name;               // in files
    const char* caption;                 // for users
    const char* solidCaption = nullptr;  // of a layer in a closed mesh; null: the same
};

/// The type of a parameter's value.
enum class ParameterType { Whole, Real, Option, Point, Count };

/// The value of a parameter of any type. Whole numbers and options (as indices) are doubles, which hold them exactly.
using ParameterValue = std::variant<double, Vec2, SeedCount>;

/// The description of a parameter of a kind of layer, from which project files, hashes, verifyPattern() and the editor
/// get its name, range and access. Texts for users are English; translations use them as keys.
struct LayerParameter {
    std::string_view name;  // its key in files
    const char* caption;
    const char* hint;  // a tooltip: one short sentence without a full stop
    Quantity quantity = Quantity::Number;
    ParameterRange range = {};
    SliderRange sliderRange = {};
    std::span<const ParameterOption> options = {};  // in the order of the enumerators
    bool (*usedIf)(const void* kind) = nullptr;     // null: always; else depends on other parameters, see usedIf<>()
    bool isSpatial = false;                         // has an effect on closed meshes only: see isShown()
    bool isHeight = false;                          // the z of a point in space
    const char* solidHint = nullptr;                // of a layer in a closed mesh; null: the same
    ParameterType type = ParameterType::Real;       // set by parameter<>(), as are the next two
    ParameterValue (*readFrom)(const void* kind) = nullptr;  // of a struct of that kind
    void (*writeTo)(void* kind, const ParameterValue&) = nullptr;

    /// The value in the parameters of a layer of that kind, as a variant of all kinds.
    template <class... Kinds>
    ParameterValue read(const std::variant<Kinds...>& layer) const {
        return readFrom(addressOf(layer));
    }
    template <class... Kinds>
    void write(std::variant<Kinds...>& layer, const ParameterValue& value) const {
        writeTo(const_cast<void*>(addressOf(layer)), value);
    }
    /// Whether the parameter has an effect, given the others.
    template <class... Kinds>
    bool isUsed(const std::variant<Kinds...>& layer) const {
        return !usedIf || usedIf(addressOf(layer));
    }

    template <class... Kinds>
    static const void* addressOf(const std::variant<Kinds...>& layer) {
        return std::visit([](const auto& kind) -> const void* { return &kind; }, layer);
    }
};

/// Reads and writes a member of a kind's struct.
template <class Member>
struct ParameterMember;
template <class Kind, class Value>
struct ParameterMember<Value Kind::*> {
    /// Whether ParameterValue holds the type itself.
    static constexpr bool isStoredDirectly = std::is_same_v<Value, Vec2> || std::is_same_v<Value, SeedCount>;
    static constexpr ParameterType kType = std::is_same_v<Value, Vec2>        ? ParameterType::Point
                                           : std::is_same_v<Value, SeedCount> ? ParameterType::Count
                                           : std::is_enum_v<Value>            ? ParameterType::Option
                                           : std::is_integral_v<Value>        ? ParameterType::Whole
                                                                              : ParameterType::Real;
    template <Value Kind::*member>
    static ParameterValue read(const void* kind) {
        const Value& value = static_cast<const Kind*>(kind)->*member;
        if constexpr (isStoredDirectly) {
            return value;
        } else {
            return static_cast<double>(value);
        }
    }
    template <Value Kind::*member>
    static void write(void* kind, const ParameterValue& value) {
        if constexpr (isStoredDirectly) {
            static_cast<Kind*>(kind)->*member = std::get<Value>(value);
        } else {
            static_cast<Kind*>(kind)->*member = static_cast<Value>(std::get<double>(value));
        }
    }
};

/// Completes the description of a parameter with the access to its member:
///     parameter<&BlueNoise::minimumDistance>({.name = "minimumDistance", .caption = "Distance", ...})
template <auto member>
constexpr LayerParameter parameter(LayerParameter description) {
    using Access = ParameterMember<decltype(member)>;
    description.type = Access::kType;
    description.readFrom = &Access::template read<member>;
    description.writeTo = &Access::template write<member>;
    return description;
}

/// For LayerParameter::usedIf: a predicate of a kind.
template <class Kind, bool (*predicate)(const Kind&)>
bool usedIf(const void* kind) {
    return predicate(*static_cast<const Kind*>(kind));
}

inline constexpr ParameterRange kAboveZero{.min = 0.0, .isMinExcluded = true};

inline constexpr LayerParameter kCountParameter{.name = "count",
                                                .caption = "Count",
                                                .hint = "Number of seeds; adding more keeps existing ones in place",
                                                .range = {0.0, kMaxSeeds},
                                                .sliderRange = {1.0, 2000.0, true}};

inline constexpr std::array<ParameterOption, 2> kDomainOptions{
    {{"outline", "Outline", "Mesh"}, {"boundingBox", "Bounding box"}}};
inline constexpr LayerParameter kDomainParameter{.name = "domain",
                                                 .caption = "Domain",
                                                 .hint = "Scatter seeds in the outline or in its bounding box",
                                                 .options = kDomainOptions,
                                                 .solidHint = "Scatter seeds in the mesh or in its bounding box"};

inline constexpr LayerParameter kRingSpacingParameter{
    .name = "exponent",
    .caption = "Ring spacing",
    .hint = "1: equidistant rings; above: closer towards the centre; below: closer towards the rim",
    .range = {0.1, 10.0},
    .sliderRange = {0.25, 4.0, true}};

inline constexpr LayerParameter kCentreHeightParameter{.name = "centreHeight",
                                                       .caption = "Centre height",
                                                       .hint = "Height of the centre, along z",
                                                       .quantity = Quantity::Length,
                                                       .isSpatial = true,
                                                       .isHeight = true};

/// An axis of the coordinates.
enum class CoordinateAxis { X, Y, Z };
inline constexpr std::array<ParameterOption, 3> kAxisOptions{{{"x", "X"}, {"y", "Y"}, {"z", "Z"}}};

/// The tilt of a direction out of the xy plane, in space.
constexpr LayerParameter tiltParameter(const char* hint) {
    return {.name = "tilt",
            .caption = "Tilt",
            .hint = hint,
            .quantity = Quantity::Angle,
            .range = {-std::numbers::pi / 2.0, std::numbers::pi / 2.0},
            .sliderRange = {-std::numbers::pi / 2.0, std::numbers::pi / 2.0},
            .isSpatial = true};
}

/// Whether a parameter is shown for seeds in a plane or in a solid.
inline bool isShown(const LayerParameter& parameter, SeedSpace space) {
    return !parameter.isSpatial || space == SeedSpace::Solid;
}

/// The fault of a parameter's value, as the end of a sentence that starts with the layer's name; nothing if it is
/// valid.
std::optional<std::string> parameterFault(const LayerParameter& parameter, const ParameterValue& value);

/// A parameter's value as text: "20", "0.3 m", "8 per square metre" or "8 per cubic metre", "(0.5, 1) m", "outline".
std::string parameterText(const LayerParameter& parameter, const ParameterValue& value,
                          SeedSpace space = SeedSpace::Plane);

}  // namespace rubble
