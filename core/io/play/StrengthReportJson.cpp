#include "core/io/play/StrengthReportJson.h"

#include "core/io/json/JsonWriter.h"
#include "core/io/project/StrengthRequirementJson.h"

#include <cmath>
#include <optional>

namespace rubble {
namespace {

void writeBound(JsonWriter& json, std::string_view key, double impulse, std::uint32_t requirement) {
    const bool isBound = requirement != kNone && std::isfinite(impulse);
    json.number(key, isBound ? std::optional<double>(impulse) : std::nullopt);
}

void writeRequirements(JsonWriter& json, const StrengthReport& report) {
    json.openArray("intents");
    for (std::size_t k = 0; k < report.asset.requirements.size(); ++k) {
        const StrengthRequirement& requirement = report.asset.requirements[k];
        json.openObject({}, JsonLayout::Inline);
        writeRequirementMembers(json, requirement);
        json.text("sentence", requirementText(requirement));
        const double impulse = report.interval.impulses[k];
        json.number(report.interval.isPerArea ? "impulsePerArea" : "impulse",
                    std::isfinite(impulse) ? std::optional(impulse) : std::nullopt);
        json.close();
    }
    json.close();
}

void writeReport(JsonWriter& json, const StrengthReport& report) {
    const ThresholdInterval& interval = report.interval;
    json.openObject();
    json.text("name", report.asset.name);
    json.number(interval.isPerArea ? "impulsePerArea" : "threshold", report.strength);
    writeRequirements(json, report);
    writeBound(json, "above", interval.low, interval.lowRequirement);
    writeBound(json, "atMost", interval.high, interval.highRequirement);
    json.number("suggested", interval.suggested());
    json.boolean("isSatisfied", interval.contains(report.strength));
    if (const std::optional<std::string> conflict = conflictText(report.asset, interval)) {
        json.text("conflict", *conflict);
    } else {
        json.null("conflict");
    }
    json.close();
}

}  // namespace

std::string strengthReportJson(std::span<const StrengthReport> reports) {
    JsonWriter json;
    json.openObject();
    json.openArray("assets");
    for (const StrengthReport& report : reports) writeReport(json, report);
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
