#include "core/io/project/ColourJson.h"

namespace rubble {

void writeColour(JsonWriter& json, std::string_view key, const Colour& colour) {
    json.numbers(key, {colour.red, colour.green, colour.blue});
}

Colour readColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>();
    return {red, green, blue};
}

}  // namespace rubble
