#pragma once

#include "core/fracture/Pattern.h"

#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

namespace rubble {

/// What a parameter's numbers measure; how they are shown and typed follows from it.
enum class Quantity { Number, Length, Angle };  // -; m; rad

/// Which numbers a parameter takes.
struct ParameterRange {
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    bool isMinOut = false;  // min itself is not allowed
    bool contains(double value) const { return (isMinOut ? value > min : value >= min) && value <= max; }
};

/// Between which numbers a slider chooses; no slider where both are the same.
struct UsualRange {
    double from = 0.0;
    double to = 0.0;
    bool isLogarithmic = false;
};

/// One of the values of a parameter that is chosen among words.
struct ParameterChoice {
    std::string_view name;  // in files
    const char* caption;    // to users
};

/// How a parameter is held and written.
enum class ParameterType { Whole, Real, Choice, Point, Count };

/// The value of any parameter: whole numbers and choices (by their place in the list) as doubles, which hold them exactly.
using ParameterValue = std::variant<double, Vec2, SeedCount>;

/// A parameter of one kind of layer, told once: project files, hashes, verifyPattern() and the editor read here how it is
/// called, what it takes and how it is got at. Texts for users are English, and the keys of their translations.
struct LayerParameter {
    std::string_view name;  // its key in files
    const char* caption;
    const char* hint;  // what it does, in a sentence without an end
    Quantity quantity = Quantity::Number;
    ParameterRange range = {};
    UsualRange usual = {};
    std::span<const ParameterChoice> choices = {};             // in the order of the enumerators
    bool (*isUsed)(const LayerParameters&) = nullptr;          // null: always; else what other parameters decide
    ParameterType type = ParameterType::Real;                  // this and the rest: by parameter<>()
    ParameterValue (*read)(const LayerParameters&) = nullptr;  // of a layer of that kind
    void (*write)(LayerParameters&, const ParameterValue&) = nullptr;
};

/// Reads and writes a member of a kind's struct.
template <class Member>
struct ParameterMember;
template <class Kind, class Value>
struct ParameterMember<Value Kind::*> {
    /// Points and counts are held as they are.
    static constexpr bool isAsItIs = std::is_same_v<Value, Vec2> || std::is_same_v<Value, SeedCount>;
    static constexpr ParameterType kType = std::is_same_v<Value, Vec2>        ? ParameterType::Point
                                           : std::is_same_v<Value, SeedCount> ? ParameterType::Count
                                           : std::is_enum_v<Value>            ? ParameterType::Choice
                                           : std::is_integral_v<Value>        ? ParameterType::Whole
                                                                              : ParameterType::Real;
    template <Value Kind::*member>
    static ParameterValue read(const LayerParameters& parameters) {
        const Value& value = std::get<Kind>(parameters).*member;
        if constexpr (isAsItIs) {
            return value;
        } else {
            return static_cast<double>(value);
        }
    }
    template <Value Kind::*member>
    static void write(LayerParameters& parameters, const ParameterValue& value) {
        if constexpr (isAsItIs) {
            std::get<Kind>(parameters).*member = std::get<Value>(value);
        } else {
            std::get<Kind>(parameters).*member = static_cast<Value>(std::get<double>(value));
        }
    }
};

/// What is told of a parameter, and how its member is got at:
///     parameter<&BlueNoise::minimumDistance>({.name = "minimumDistance", .caption = "Distance", ...})
template <auto member>
constexpr LayerParameter parameter(LayerParameter told) {
    using Access = ParameterMember<decltype(member)>;
    told.type = Access::kType;
    told.read = &Access::template read<member>;
    told.write = &Access::template write<member>;
    return told;
}

inline constexpr ParameterRange kAboveZero{.min = 0.0, .isMinOut = true};

inline constexpr LayerParameter kCountParameter{
    .name = "count",
    .caption = "Count",
    .hint = "How many seeds are thrown; more leave the earlier ones where they are",
    .range = {0.0, kMostSeeds},
    .usual = {1.0, 2000.0, true}};

inline constexpr std::array<ParameterChoice, 2> kDomainChoices{
    {{"outline", "Outline"}, {"boundingBox", "Bounding box"}}};
inline constexpr LayerParameter kDomainParameter{
    .name = "domain",
    .caption = "Domain",
    .hint = "Inside the outline, or in its bounding box as the thesis does",
    .choices = kDomainChoices};

/// Says what is wrong with a parameter's value, as the end of a sentence that begins with the layer's name.
std::optional<std::string> parameterFault(const LayerParameter& parameter, const LayerParameters& of);

}  // namespace rubble
