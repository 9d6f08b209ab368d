#include "core/io/json/VectorJson.h"

namespace rubble {

void writeVector(JsonWriter& json, std::string_view key, Vec3 vector) {
    json.numbers(key, {vector.x, vector.y, vector.z});
}

Vec3 readVector(const JsonValue& value) {
    const auto [x, y, z] = value.numbers<3>();
    return {x, y, z};
}

}  // namespace rubble
