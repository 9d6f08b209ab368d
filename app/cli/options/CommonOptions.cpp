#include "app/cli/options/CommonOptions.h"

#include "app/cli/options/Command.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"

#include <map>

namespace rubble {
namespace {

const std::map<std::string, std::string> kUnits = {
    {"mm", "0.001"}, {"cm", "0.01"}, {"m", "1"}, {"in", "0.0254"}, {"ft", "0.3048"}};

/// Replaces the name of a unit by its length in metres; returns an error if the text is neither a name nor a number in
/// range.
std::string convertToMetres(std::string& text) {
    const NumberRange& range = rangeOf(ProjectNumber::MetresPerUnit);
    if (const auto unit = kUnits.find(text); unit != kUnits.end()) {
        text = unit->second;
    } else if (!isNumberInRange(text, range)) {
        return quotedName(text) + " is not mm, cm, m, in, ft or a number of metres that is " + rangeText(range);
    }
    return {};
}

}  // namespace

std::string joinedText(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

void addProjectArgument(Command& command, std::string& file) {
    command.argument("FILE", file, "The project").required().reads();
}

void addJsonOption(Command& command, bool& isJson) { command.flag("--json", isJson, "Print JSON instead of text"); }

void addThreadsOption(Command& command, int& threads) {
    threads = availableProcessors();
    command.option("-j,--threads", threads, "The number of threads (default: all processors)")
        .wholeInRange(ProjectNumber::Threads)
        .valueName("N");
}

void addUnitOption(Command& command, std::optional<double>& metresPerUnit) {
    command.option("--unit", metresPerUnit, "The unit of the file, by name or in metres (default: its own)")
        .convert(convertToMetres)
        .valueName("mm|cm|m|in|ft|NUMBER");
}

}  // namespace rubble
