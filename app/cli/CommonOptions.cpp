#include "app/cli/CommonOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

namespace rubble {

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

void addThreadsOption(CLI::App& command, int& threads) {
    threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const auto fault = [](const std::string& given) {
        int number = 0;
        const bool isNumber = CLI::detail::lexical_cast(given, number);
        return isNumber && number >= 1 && number <= 1024 ? std::string()
                                                         : '"' + given + "\" is no whole number from 1 to 1024";
    };
    command.add_option("--threads", threads, "How many threads to use: all processors if not given")
        ->check(CLI::Validator(fault, ""))
        ->option_text("N");
}

}  // namespace rubble
