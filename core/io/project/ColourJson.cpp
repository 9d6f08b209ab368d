#include "core/io/project/ColourJson.h"

namespace rubble {

void writeColour(JsonWriter& json, std::string_view key, const Colour& colour) {
    json.numbers(key, {colour.red, colour.green, colour.blue});
}

Colour readColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>();
    return {red, green, blue};
}

void writeOpacity(JsonWriter& json, double opacity) {
    if (opacity != 1.0) json.number("opacity", opacity);
}

double readOpacity(const JsonValue& material) {
    return material["opacity"].isPresent() ? material["opacity"].number() : 1.0;
}

void writeFinish(JsonWriter& json, Finish finish) {
    if (finish != Finish::Plain) json.text("finish", kFinishNames[static_cast<std::size_t>(finish)]);
}

Finish readFinish(const JsonValue& material) {
    return material["finish"].isPresent() ? static_cast<Finish>(material["finish"].oneOf(kFinishNames)) : Finish::Plain;
}

}  // namespace rubble
