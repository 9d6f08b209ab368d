#include "core/fracture/pattern/LayerParameter.h"

#include "core/base/MessageText.h"
#include "core/fracture/pattern/ParameterText.h"

#include <cmath>

namespace rubble {
namespace {

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
    return '"' + std::string(parameter.caption) + "\" is " + countText(count) + ", but must be " + wanted;
}

}  // namespace

std::optional<std::string> parameterFault(const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const auto fault = [&](const std::string& found) {
        return '"' + std::string(parameter.caption) + "\" is " + found + unitText(parameter.quantity) +
               ", but must be " + requirement(parameter);
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

}  // namespace rubble
