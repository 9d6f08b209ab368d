#include "app/cli/CommonOptions.h"

#include "core/base/MessageText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <thread>

namespace rubble {
namespace {

template <class Number>
CLI::Validator validatorOf(Number min, Number max, const std::string& kind) {
    const std::string fault = "\" is no " + kind + " from " + messageText(min) + " to " + messageText(max);
    const auto check = [min, max, fault](const std::string& given) {
        Number number{};
        const bool isNumber = CLI::detail::lexical_cast(given, number) && number >= min && number <= max;
        return isNumber ? std::string() : '"' + given + fault;
    };
    return CLI::Validator(check, "");
}

const std::map<std::string, std::string> kUnits = {
    {"mm", "0.001"}, {"cm", "0.01"}, {"m", "1"}, {"in", "0.0254"}, {"ft", "0.3048"}};

/// Turns the name of a unit into metres; a sentence where the text is neither a name nor a number.
std::string inMetres(std::string& text) {
    double number = 0.0;
    if (const auto unit = kUnits.find(text); unit != kUnits.end()) {
        text = unit->second;
    } else if (!CLI::detail::lexical_cast(text, number)) {
        return '"' + text + "\" is neither mm, cm, m, in, ft nor a number of metres";
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
    const auto fault = [words](const std::string& given) {
        if (std::ranges::find(words, given) != words.end()) return std::string();
        return '"' + given + "\" is none of " + joinedText(words);
    };
    return CLI::Validator(fault, "");
}

CLI::Validator numberBetween(int min, int max) { return validatorOf(min, max, "whole number"); }

CLI::Validator numberBetween(double min, double max) { return validatorOf(min, max, "number"); }

void addThreadsOption(CLI::App& command, int& threads) {
    threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    command.add_option("--threads", threads, "How many threads to use: all processors if not given")
        ->check(numberBetween(1, 1024))
        ->option_text("N");
}

void addUnitOption(CLI::App& command, std::optional<double>& metresPerUnit) {
    command.add_option("--unit", metresPerUnit, "What one unit of the file is, by name or in metres")
        ->transform(CLI::Validator(inMetres, ""))
        ->option_text("mm|cm|m|in|ft|NUMBER");
}

}  // namespace rubble
