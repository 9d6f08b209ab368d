#include "core/io/IntentReportJson.h"

#include "core/io/IntentJson.h"
#include "core/io/JsonLayout.h"

namespace rubble {
namespace {

void writeBound(JsonLayout& json, std::string_view key, double impulse, std::uint32_t intent) {
    json.number(key, intent != kNone ? std::optional<double>(impulse) : std::nullopt);
}

void writeIntents(JsonLayout& json, const IntentReport& report) {
    json.openArray("intents");
    for (std::size_t k = 0; k < report.asset.intents.size(); ++k) {
        const Intent& intent = report.asset.intents[k];
        json.openObject({}, JsonLines::One);
        writeIntentMembers(json, intent);
        json.text("sentence", intentText(intent));
        json.number("impulse", report.interval.impulses[k]);
        json.close();
    }
    json.close();
}

void writeReport(JsonLayout& json, const IntentReport& report) {
    const ThresholdInterval& interval = report.interval;
    json.openObject();
    json.text("name", report.asset.name);
    json.number("threshold", report.threshold);
    writeIntents(json, report);
    writeBound(json, "above", interval.low, interval.lowIntent);
    writeBound(json, "atMost", interval.high, interval.highIntent);
    json.number("suggested", interval.suggested());
    json.boolean("isSatisfied", interval.contains(report.threshold));
    const std::optional<std::string> conflict = conflictText(report.asset, interval);
    if (conflict) {
        json.text("conflict", *conflict);
    } else {
        json.null("conflict");
    }
    json.close();
}

}  // namespace

std::string intentReportJson(std::span<const IntentReport> reports) {
    JsonLayout json;
    json.openObject();
    json.openArray("assets");
    for (const IntentReport& report : reports) writeReport(json, report);
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
