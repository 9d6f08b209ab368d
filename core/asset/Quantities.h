#pragma once

#include "core/geometry/Vec.h"

#include <initializer_list>
#include <optional>
#include <string>

namespace rubble {

/// Which values a number of a project may have.
enum class Range { Finite, AboveZero, ZeroOrAbove, ZeroToOne };

/// A number of a project by what people call it.
struct NamedNumber {
    const char* name;
    double value;
    Range range;
};

/// The first of an owner's numbers that is out of its range, as a sentence: `Material 1 "brick": the density is 0, but it
/// must be finite and above zero.`
std::optional<std::string> quantityFault(const std::string& owner, std::initializer_list<NamedNumber> quantities);

/// The same for a vector that is not finite.
std::optional<std::string> vectorFault(const std::string& owner, const char* name, const Vec3& value);

}  // namespace rubble
