#include "core/fracture/layer/LayerParameter.h"

#include "core/base/MessageText.h"

#include <cmath>

namespace rubble {
namespace {

std::string unitText(Quantity quantity) {
    switch (quantity) {
        case Quantity::Length: return " m";
        case Quantity::Angle: return " rad";
        case Quantity::Number: break;
    }
    return {};
}

std::string pointText(Vec2 point) { return "(" + messageText(point.x) + ", " + messageText(point.y) + ")"; }

std::string countText(const SeedCount& count, SeedSpace space = SeedSpace::Plane) {
    switch (count.by) {
        case CountBy::Number: break;
        case CountBy::Density:
            return messageText(count.amount) + (space == SeedSpace::Plane ? " per square metre" : " per cubic metre");
        case CountBy::FragmentSize: return messageText(count.amount) + " m per fragment";
    }
    return messageText(count.amount);
}

/// The requirement on a value: "finite and above zero".
std::string requirement(const LayerParameter& parameter) {
    constexpr double kAll = std::numeric_limits<double>::max();
    const auto& [min, max, isMinExcluded] = parameter.range;
    const std::string minText = min == 0.0 ? "zero" : messageText(min);
    if (max < kAll && isMinExcluded) return "above " + minText + " and at most " + messageText(max);
    if (max < kAll) return "from " + messageText(min) + " to " + messageText(max);
    if (isMinExcluded) return "finite and above " + minText;
    return min > -kAll ? "finite and not below " + minText : "finite";
}

std::optional<std::string> countFault(const SeedCount& count, const LayerParameter& parameter) {
    if (count.by == CountBy::Number && parameter.range.contains(count.amount)) return std::nullopt;
    if (count.by != CountBy::Number && kAboveZero.contains(count.amount)) return std::nullopt;
    const std::string wanted = count.by == CountBy::Number ? requirement(parameter) : "finite and above zero";
    return quotedName(parameter.caption) + " is " + countText(count) + ", but must be " + wanted;
}

}  // namespace

std::optional<std::string> parameterFault(const LayerParameter& parameter, const ParameterValue& value) {
    const auto fault = [&](const std::string& found) {
        return quotedName(parameter.caption) + " is " + found + unitText(parameter.quantity) + ", but must be " +
               requirement(parameter);
    };
    if (const auto* point = std::get_if<Vec2>(&value)) {
        if (std::isfinite(point->x) && std::isfinite(point->y)) return std::nullopt;
        return fault(pointText(*point));
    }
    if (const auto* count = std::get_if<SeedCount>(&value)) return countFault(*count, parameter);
    const double number = std::get<double>(value);
    if (parameter.type == ParameterType::Option || parameter.range.contains(number)) return std::nullopt;
    return fault(messageText(number));
}

std::string parameterText(const LayerParameter& parameter, const ParameterValue& value, SeedSpace space) {
    if (const auto* point = std::get_if<Vec2>(&value)) return pointText(*point) + unitText(parameter.quantity);
    if (const auto* count = std::get_if<SeedCount>(&value)) return countText(*count, space);
    const double number = std::get<double>(value);
    if (parameter.type == ParameterType::Option) {
        return std::string(parameter.options[static_cast<std::size_t>(number)].name);
    }
    return messageText(number) + unitText(parameter.quantity);
}

}  // namespace rubble
