#include "core/io/play/QueryJson.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/json/VectorJson.h"

#include <cmath>
#include <limits>

namespace rubble {
namespace {

/// Adds the name of a body, or those of its fragments.
void addNames(const Session& session, const BodyPart& part, std::vector<std::string>& names) {
    const PlayBody& body = *session.body(part.body);
    if (part.fragments.empty()) names.push_back(session.nameOf(body));
    for (const std::uint32_t fragment : part.fragments)
        names.push_back(fragmentName(body, session.origins()[body.origin], fragment));
}

void writeNames(JsonWriter& json, std::string_view key, std::span<const std::string> names) {
    json.list(key, names, [&](JsonWriter& list, const std::string& name) { list.text({}, name); });
}

std::vector<std::string> namesIn(const Session& session, const FallingIsland& island) {
    std::vector<std::string> names;
    for (const std::uint32_t number : island.bodies) addNames(session, {.body = number}, names);
    for (const BodyPart& part : island.parts) addNames(session, part, names);
    return names;
}

/// A time; null for a body that meets nothing.
void writeTime(JsonWriter& json, std::string_view key, double time) {
    json.number(key, std::isfinite(time) ? std::optional(time) : std::nullopt);
}

}  // namespace

std::string wouldFallJson(const Session& session, std::span<const BodyPart> removed, const Collapse& collapse) {
    JsonWriter json;
    json.openObject();
    json.wholeNumber("step", session.stepsDone());
    std::vector<std::string> names;
    for (const BodyPart& part : removed) addNames(session, part, names);
    writeNames(json, "removed", names);
    json.list("islands", collapse.islands, [&](JsonWriter& list, const FallingIsland& island) {
        list.openObject({}, JsonLayout::Inline);
        list.number("mass", island.mass);
        writeNames(list, "bodies", namesIn(session, island));
        list.close();
    });
    json.number("mass", collapse.mass);
    const bool doesFall = !collapse.islands.empty();  // else nothing meets anything
    writeTime(json, "first", doesFall ? collapse.first : std::numeric_limits<double>::infinity());
    writeTime(json, "last", doesFall ? collapse.last : std::numeric_limits<double>::infinity());
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
