#include "app/cli/CommonOptions.h"

#include "core/base/MessageText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
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

}  // namespace rubble
