#include "core/io/json/VectorJson.h"

namespace rubble {

void writeVector(JsonWriter& json, std::string_view key, Vec3 vector) {
    json.numbers(key, {vector.x, vector.y, vector.z});
}

Vec3 readVector(const JsonValue& value) {
    const auto [x, y, z] = value.numbers<3>();
    return {x, y, z};
}

void writeColour(JsonWriter& json, std::string_view key, const Colour& colour) {
    json.numbers(key, {colour.red, colour.green, colour.blue});
}

Colour readColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>();
    return {red, green, blue};
}

}  // namespace rubble
