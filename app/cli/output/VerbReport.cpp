#include "app/cli/output/VerbReport.h"

#include "app/cli/console/InputOutput.h"
#include "core/base/MessageText.h"
#include "core/io/json/JsonWriter.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr const char* kResultFormat = "rubble-result";
constexpr std::uint32_t kResultVersion = 1;

const char* reportWord(ErrorCode code) {
    switch (code) {
        case ErrorCode::BadInput: break;
        case ErrorCode::Degenerate: return "Degenerate";
        case ErrorCode::Crossing: return "Crossing";
        case ErrorCode::Unsupported: return "Unsupported";
        case ErrorCode::NotFound: return "NotFound";
        case ErrorCode::Io: return "Io";
        case ErrorCode::Limit: return "Limit";
        case ErrorCode::Cancelled: return "Cancelled";
        case ErrorCode::Edited: return "Edited";
    }
    return "BadInput";
}

const char* reportWord(Severity severity) {
    switch (severity) {
        case Severity::Note: return "note";
        case Severity::Warning: break;
        case Severity::Error: return "error";
    }
    return "warning";
}

const char* statusWord(const VerbReport& report, const Status& status) {
    if (status) return report.conclusion.empty() ? "ok" : "findings";
    return status.error().code == ErrorCode::Cancelled ? "cancelled" : "error";
}

/// Writes a name or a path, which may hold any bytes, unless it is empty.
void writePlaceName(JsonWriter& json, std::string_view key, const std::string& name) {
    if (!name.empty()) json.text(key, printableText(name));
}

void writePlace(JsonWriter& json, const FindingPlace& place) {
    json.openObject("place", JsonLayout::Inline);
    writePlaceName(json, "file", place.file);
    writePlaceName(json, "asset", place.asset);
    writePlaceName(json, "fragment", place.details.path);
    writePlaceName(json, "test", place.test);
    if (place.details.level != 0) json.wholeNumber("level", std::uint64_t{place.details.level});
    if (place.details.layer != 0) json.wholeNumber("layer", std::uint64_t{place.details.layer});
    if (place.details.index != kNone) json.wholeNumber("index", std::uint64_t{place.details.index});
    if (place.details.point) json.numbers("point", {place.details.point->x, place.details.point->y});
    json.close();
}

void writeFinding(JsonWriter& json, const Finding& finding) {
    json.openObject();
    json.text("severity", reportWord(finding.severity));
    json.text("code", finding.code);
    writePlace(json, finding.place);
    json.text("message", printableText(finding.message));
    json.close();
}

}  // namespace

void conclude(VerbReport& report, const std::string& line) {
    report.conclusion += (report.conclusion.empty() ? "" : "\n") + line;
}

Finding findingOf(const Diagnostic& diagnostic, const std::string& file, const std::string& asset) {
    return {diagnostic.severity,
            nameOf(diagnostic.code),
            {.file = file, .asset = asset, .details = diagnostic.place},
            diagnostic.message};
}

Finding findingOf(const Error& error, FindingPlace place) {
    return {Severity::Error, reportWord(error.code), std::move(place), error.message};
}

Status printResult(std::string_view text, const VerbReport& report, const CliContext& context) {
    return report.isJson ? success() : printText(text, context);
}

Status printSummary(std::string_view text, const VerbReport& report, const CliContext& context) {
    return report.isQuiet ? success() : printResult(text, report, context);
}

std::string reportJson(const VerbReport& report, const std::string& verb, const Status& status) {
    JsonWriter json;
    json.openObject();
    json.text("format", kResultFormat);
    json.wholeNumber("version", std::uint64_t{kResultVersion});
    json.text("verb", verb);
    json.text("status", statusWord(report, status));
    if (report.writeResults) report.writeResults(json);
    json.openArray("findings");
    for (const Finding& finding : report.findings) writeFinding(json, finding);
    if (!status && !report.hasErrorInFindings) writeFinding(json, findingOf(status.error()));
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
