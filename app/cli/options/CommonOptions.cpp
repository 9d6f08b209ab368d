#include "app/cli/options/CommonOptions.h"

#include "core/base/MessageText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <thread>

namespace rubble {
namespace {

template <class Number>
CLI::Validator validatorOf(Number min, Number max, const std::string& kind) {
    const std::string error = "\" is not a " + kind + " from " + messageText(min) + " to " + messageText(max);
    const auto check = [min, max, error](const std::string& given) {
        Number number{};
        const bool isNumber = CLI::detail::lexical_cast(given, number) && number >= min && number <= max;
        return isNumber ? std::string() : '"' + given + error;
    };
    return CLI::Validator(check, "");
}

const std::map<std::string, std::string> kUnits = {
    {"mm", "0.001"}, {"cm", "0.01"}, {"m", "1"}, {"in", "0.0254"}, {"ft", "0.3048"}};

/// Replaces the name of a unit by its length in metres; returns an error if the text is neither a name nor a number.
std::string convertToMetres(std::string& text) {
    double number = 0.0;
    if (const auto unit = kUnits.find(text); unit != kUnits.end()) {
        text = unit->second;
    } else if (!CLI::detail::lexical_cast(text, number)) {
        return '"' + text + "\" is not mm, cm, m, in, ft or a number of metres";
    }
    return {};
}

}  // namespace

std::string joinedText(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

CLI::Validator oneOf(const std::vector<std::string>& words) {
    const auto check = [words](const std::string& given) {
        if (std::ranges::find(words, given) != words.end()) return std::string();
        return '"' + given + "\" is not one of " + joinedText(words);
    };
    return CLI::Validator(check, "");
}

CLI::Validator numberBetween(int min, int max) { return validatorOf(min, max, "whole number"); }

CLI::Validator numberBetween(double min, double max) { return validatorOf(min, max, "number"); }

void addThreadsOption(CLI::App& command, int& threads) {
    threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    command.add_option("--threads", threads, "The number of threads (default: all processors)")
        ->check(numberBetween(1, 1024))
        ->option_text("N");
}

void addUnitOption(CLI::App& command, std::optional<double>& metresPerUnit) {
    command.add_option("--unit", metresPerUnit, "The unit of the file, by name or in metres (default: its own)")
        ->transform(CLI::Validator(convertToMetres, ""))
        ->option_text("mm|cm|m|in|ft|NUMBER");
}

}  // namespace rubble
