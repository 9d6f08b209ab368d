#include "core/io/play/SwapAuditJson.h"

#include "core/io/json/JsonWriter.h"

namespace rubble {
namespace {

void writeSpeed(JsonWriter& json, std::string_view key, const FragmentSpeed& fastest) {
    json.openObject(key, JsonLayout::Inline);
    json.text("piece", fastest.fragment);
    json.number("speed", fastest.speed);
    json.close();
}

/// The messages of a severity.
void writeMessages(JsonWriter& json, std::string_view key, const std::vector<Diagnostic>& diagnostics,
                   Severity severity) {
    json.openArray(key);
    for (const Diagnostic& one : diagnostics) {
        if (one.severity == severity) json.text({}, one.message);
    }
    json.close();
}

void writeMeasurements(JsonWriter& json, const SwapAudit& audit) {
    json.wholeNumber("contacts", static_cast<std::uint64_t>(audit.contacts));
    json.wholeNumber("contactPoints", static_cast<std::uint64_t>(audit.contactPoints));
    json.number("deepestOverlap", audit.deepestOverlap);
    writeSpeed(json, "resting", audit.resting);
    json.number("restingEnergy", audit.restingEnergy);
    if (!audit.lying.fragment.empty()) writeSpeed(json, "lying", audit.lying);
    if (!audit.exported.fragment.empty()) {
        json.openObject("exported", JsonLayout::Inline);
        json.text("piece", audit.exported.fragment);
        json.number("gap", audit.exported.gap);
        json.close();
    }
    json.number("massDrift", audit.massDrift);
    json.number("momentumDrift", audit.momentumDrift);
    json.number("angularDrift", audit.angularDrift);
    json.number("energyGain", audit.energyGain);
    writeMessages(json, "notices", audit.diagnostics, Severity::Note);
    writeMessages(json, "faults", audit.diagnostics, Severity::Warning);
    json.boolean("isClean", audit.isClean());
}

}  // namespace

std::string swapAuditJson(std::span<const NamedAudit> audits) {
    JsonWriter json;
    json.openObject();
    json.openArray("assets");
    for (const NamedAudit& named : audits) {
        json.openObject();
        json.text("name", named.name);
        json.wholeNumber("pieces", std::uint64_t{named.audit ? named.audit->fragments : 0});
        if (named.audit) writeMeasurements(json, *named.audit);
        json.close();
    }
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
