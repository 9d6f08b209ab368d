#include "core/fracture/pattern/ParameterText.h"

#include "core/base/MessageText.h"

namespace rubble {

std::string parameterText(const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    if (const auto* point = std::get_if<Vec2>(&value)) return pointText(*point) + unitText(parameter.quantity);
    if (const auto* count = std::get_if<SeedCount>(&value)) return countText(*count);
    const double number = std::get<double>(value);
    if (parameter.type == ParameterType::Option) {
        return std::string(parameter.options[static_cast<std::size_t>(number)].name);
    }
    return messageText(number) + unitText(parameter.quantity);
}

std::string unitText(Quantity quantity) {
    switch (quantity) {
        case Quantity::Length: return " m";
        case Quantity::Angle: return " rad";
        case Quantity::Number: break;
    }
    return {};
}

std::string pointText(Vec2 point) { return "(" + messageText(point.x) + ", " + messageText(point.y) + ")"; }

std::string countText(const SeedCount& count) {
    switch (count.by) {
        case CountBy::Number: break;
        case CountBy::Density: return messageText(count.amount) + " a square metre";
        case CountBy::PieceSize: return messageText(count.amount) + " m a piece";
    }
    return messageText(count.amount);
}

}  // namespace rubble
