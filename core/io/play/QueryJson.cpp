#include "core/io/play/QueryJson.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

#include <cmath>

namespace rubble {
namespace {

void writeNames(JsonWriter& json, std::string_view key, const Session& session,
                std::span<const std::uint32_t> numbers) {
    json.list(key, numbers,
              [&](JsonWriter& list, std::uint32_t number) { list.text({}, session.nameOf(*session.body(number))); });
}

/// A time; null for a body that meets nothing.
void writeTime(JsonWriter& json, std::string_view key, double time) {
    json.number(key, std::isfinite(time) ? std::optional(time) : std::nullopt);
}

}  // namespace

std::string wouldFallJson(const Session& session, std::span<const std::uint32_t> removed, const Collapse& collapse) {
    JsonWriter json;
    json.openObject();
    json.wholeNumber("step", session.stepsDone());
    writeNames(json, "removed", session, removed);
    json.list("islands", collapse.islands, [&](JsonWriter& list, const FallingIsland& island) {
        list.openObject({}, JsonLayout::Inline);
        list.number("mass", island.mass);
        writeNames(list, "bodies", session, island.bodies);
        list.close();
    });
    json.number("mass", collapse.mass);
    writeTime(json, "first", collapse.first);
    writeTime(json, "last", collapse.last);
    json.close();
    return std::move(json).finished();
}

std::string changedBoxesJson(std::uint64_t since, std::uint64_t step, std::span<const Box3> boxes) {
    JsonWriter json;
    json.openObject();
    json.wholeNumber("since", since);
    json.wholeNumber("step", step);
    json.list("boxes", boxes, [](JsonWriter& list, const Box3& box) {
        list.openObject({}, JsonLayout::Inline);
        writeVector(list, "min", box.min);
        writeVector(list, "max", box.max);
        list.close();
    });
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
