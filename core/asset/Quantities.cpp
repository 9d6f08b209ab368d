#include "core/asset/Quantities.h"

#include "core/base/MessageText.h"

#include <cmath>

namespace rubble {
namespace {

bool isInRange(const NamedNumber& quantity) {
    if (!std::isfinite(quantity.value)) return false;
    switch (quantity.range) {
        case Range::Finite: return true;
        case Range::AboveZero: return quantity.value > 0.0;
        case Range::ZeroOrAbove: return quantity.value >= 0.0;
        case Range::ZeroToOne: return quantity.value >= 0.0 && quantity.value <= 1.0;
    }
    return false;
}

const char* textOf(Range range) {
    switch (range) {
        case Range::Finite: return "finite";
        case Range::AboveZero: return "finite and above zero";
        case Range::ZeroOrAbove: return "finite and not below zero";
        case Range::ZeroToOne: return "from 0 to 1";
    }
    return "";
}

}  // namespace

std::optional<std::string> quantityFault(const std::string& owner, std::initializer_list<NamedNumber> quantities) {
    for (const NamedNumber& quantity : quantities) {
        if (isInRange(quantity)) continue;
        return owner + ": the " + quantity.name + " is " + messageText(quantity.value) + ", but it must be " +
               textOf(quantity.range) + ".";
    }
    return std::nullopt;
}

std::optional<std::string> vectorFault(const std::string& owner, const char* name, const Vec3& value) {
    if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return std::nullopt;
    return owner + ": the " + name + " is (" + messageText(value.x) + ", " + messageText(value.y) + ", " +
           messageText(value.z) + "), but it must be finite.";
}

}  // namespace rubble
