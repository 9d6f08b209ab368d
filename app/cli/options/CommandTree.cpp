#include "app/cli/options/CommandTree.h"

#include "app/cli/options/Command.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

namespace rubble {
namespace {

/// The words that CommandOption::oneOf() accepts.
std::vector<std::string> wordsOf(CLI::Option& option) {
    for (int index = 0;; ++index) {
        try {
            const std::string& name = option.get_validator(index)->get_name();
            if (name.starts_with(kWordsPrefix))
                return CLI::detail::split(name.substr(std::string_view(kWordsPrefix).size()), ' ');
        } catch (const CLI::OptionNotFound&) {
            return {};
        }
    }
}

/// What the name of a value says about it: "FILE.csv", "FOLDER", "N".
ValueKind kindNamed(const std::string& name) {
    const auto has = [&name](const char* word) { return name.find(word) != std::string::npos; };
    constexpr std::array kFiles{"FILE", "PROJECT", "PICTURE", "PATH", "REPLAY", "BEFORE", "AFTER"};
    if (std::ranges::any_of(kFiles, has)) return ValueKind::File;
    return has("FOLDER") ? ValueKind::Folder : ValueKind::Other;
}

CommandTreeOption optionOf(CLI::Option& option) {
    CommandTreeOption result{.names = {}, .description = option.get_description(), .words = wordsOf(option)};
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
    result.isRepeatable =
        option.get_items_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (option.get_positional()) result.names = {option.get_name()};
    if (option.get_items_expected_max() == 0) return result;
    const std::string& text = option.get_option_text();
    const bool isNamed = text.find_first_not_of(' ') != std::string::npos;
    result.value = kindNamed(isNamed ? text : option.get_positional() ? option.get_name() : option.get_type_name());
    if (!result.words.empty()) result.value = ValueKind::Words;
    return result;
}

}  // namespace

std::vector<CommandTreeVerb> commandTree(CLI::App& program) {
    std::vector<CommandTreeVerb> verbs;
    CommandTreeVerb help{.name = "help", .description = "Print the help of a verb", .options = {}, .arguments = {}};
    CommandTreeOption verbArgument{
        .names = {"VERB"}, .description = "The verb", .value = ValueKind::Words, .words = {}};
    const auto isAny = [](CLI::App*) { return true; };
    for (CLI::App* verb : program.get_subcommands(isAny)) {
        if (verb->get_group().empty()) continue;
        CommandTreeVerb described{
            .name = verb->get_name(), .description = verb->get_description(), .options = {}, .arguments = {}};
        for (CLI::Option* option : verb->get_options()) {
            if (option->get_group().empty()) continue;
            (option->get_positional() ? described.arguments : described.options).push_back(optionOf(*option));
        }
        verbArgument.words.push_back(described.name);
        verbs.push_back(std::move(described));
    }
    help.arguments = {std::move(verbArgument)};
    verbs.push_back(std::move(help));
    return verbs;
}

}  // namespace rubble
