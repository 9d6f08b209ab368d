#include "app/cli/options/Command.h"

#include "app/cli/options/CommonOptions.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/Version.h"
#include "core/io/text/LetterCase.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace rubble {
namespace {

/// Returns a check of texts for values of a type.
template <class Value>
std::function<std::string(const std::string&)> rangeCheck(ProjectNumber number, const std::string& kind) {
    return [&range = rangeOf(number), kind](const std::string& given) {
        Value value{};
        if (CLI::detail::lexical_cast(given, value) && range.contains(value)) return std::string();
        return quotedName(given) + " is not a " + kind + " " + rangeText(range);
    };
}

std::string wordsCheckName(const std::vector<std::string>& words) {
    std::string name = kWordsPrefix;
    for (const std::string& word : words) name += (&word == &words.front() ? "" : " ") + word;
    return name;
}

}  // namespace

bool hasExtension(const std::string& path, const std::string& extension) {
    return lowerCase(path).ends_with(extension);
}

CommandOption CommandOption::required() const {
    m_option->required();
    return *this;
}

CommandOption CommandOption::valueName(const std::string& text) const {
    m_option->option_text(text);
    return *this;
}

CommandOption CommandOption::typeName(const std::string& text) const {
    m_option->type_name(text);
    return *this;
}

CommandOption CommandOption::single() const {
    m_option->expected(1);
    return *this;
}

CommandOption CommandOption::repeatable() const {
    m_option->expected(1)->take_all()->allow_extra_args(false);
    return *this;
}

CommandOption CommandOption::separatedBy(char separator) const {
    m_option->delimiter(separator);
    return *this;
}

CommandOption CommandOption::hidden() const {
    m_option->group("");
    return *this;
}

CommandOption CommandOption::oneOf(const std::vector<std::string>& words) const {
    const auto check = [words](const std::string& given) {
        if (std::ranges::find(words, given) != words.end()) return std::string();
        return quotedName(given) + " is not one of " + joinedText(words);
    };
    m_option->check(CLI::Validator(check, "", wordsCheckName(words)));
    return *this;
}

CommandOption CommandOption::oneOfOrFile(const std::vector<std::string>& words, const std::string& extension) const {
    const auto check = [words, extension](const std::string& given) {
        if (std::ranges::find(words, given) != words.end() || hasExtension(given, extension)) return std::string();
        return quotedName(given) + " is not one of " + joinedText(words) + ", and no " + extension + " file";
    };
    m_option->check(CLI::Validator(check, "", wordsCheckName(words)));
    return uses(FileRole::Read, {extension});
}

CommandOption CommandOption::inRange(ProjectNumber number) const { return check(rangeCheck<double>(number, "number")); }

CommandOption CommandOption::wholeInRange(ProjectNumber number) const {
    return check(rangeCheck<int>(number, "whole number"));
}

CommandOption CommandOption::wholeUpTo(std::uint32_t max) const {
    return check([max](const std::string& given) {
        std::uint64_t value = 0;
        if (CLI::detail::lexical_cast(given, value) && value <= max) return std::string();
        return '"' + given + "\" is not a whole number from 0 to " + std::to_string(max);
    });
}

CommandOption CommandOption::check(std::function<std::string(const std::string&)> check) const {
    m_option->check(CLI::Validator(std::move(check), ""));
    return *this;
}

CommandOption CommandOption::convert(std::function<std::string(std::string&)> convert) const {
    m_option->transform(CLI::Validator(std::move(convert), ""));
    return *this;
}

CommandOption CommandOption::formerWords(std::vector<std::pair<std::string, std::string>> words) const {
    return convert([words = std::move(words)](std::string& given) {
        const auto found = std::ranges::find(words, given, &std::pair<std::string, std::string>::first);
        if (found != words.end()) given = found->second;
        return std::string();
    });
}

CommandOption CommandOption::uses(FileRole role, std::vector<std::string> extensions) const {
    m_files->push_back({m_option, role, std::move(extensions)});
    return *this;
}

CommandOption CommandOption::reads() const { return uses(FileRole::Read, {}); }

CommandOption CommandOption::changes() const { return uses(FileRole::Changed, {}); }

CommandOption CommandOption::writes(std::vector<std::string> extensions) const {
    return uses(FileRole::Written, std::move(extensions));
}

CommandOption CommandOption::needs(CommandOption other) const {
    m_option->needs(other.m_option);
    return *this;
}

CommandOption CommandOption::excludes(CommandOption other) const {
    m_option->excludes(other.m_option);
    return *this;
}

Command::Command(CLI::App& program, const std::string& name, const std::string& description, const std::string& footer)
    : m_app(program.add_subcommand(name, description)) {
    m_app->footer(footer);
    m_app->group("Verbs");
}

bool Command::isParsed() const { return m_app->parsed(); }

template <class Value>
CommandOption Command::argument(const std::string& name, Value& value, const std::string& help) {
    return option(name, value, help).typeName("");
}

template <class Value>
CommandOption Command::option(const std::string& name, Value& value, const std::string& help) {
    return {m_app->add_option(name, value, help), m_files};
}

CommandOption Command::callback(const std::string& name, std::function<void(const std::string&)> apply,
                                const std::string& help) {
    return {m_app->add_option_function<std::string>(name, apply, help), m_files};
}

CommandOption Command::flag(const std::string& name, bool& value, const std::string& help) {
    return {m_app->add_flag(name, value, help), m_files};
}

void Command::addCommonFlags() {
    m_app->add_flag("-q,--quiet")->description("Print results and errors only: no progress, warnings or summaries");
    m_app->set_version_flag("--version", versionText())->group("");
}

bool Command::isQuiet() const { return m_app->count("--quiet") > 0; }

void Command::addReportFlag() {
    m_app->add_flag("--json")->description("Print a JSON document of the results instead of text");
    m_hasReport = true;
}

void Command::hide() { m_app->group(""); }

bool Command::isReportWanted() const { return m_hasReport && m_app->count("--json") > 0; }

void Command::addCheck(std::function<void()> check) {
    m_checks->push_back(std::move(check));
    m_app->callback([checks = m_checks] {
        for (const std::function<void()>& one : *checks) one();
    });
}

void Command::requireFit(std::function<std::string()> fault) {
    addCheck([fault = std::move(fault)] {
        if (const std::string sentence = fault(); !sentence.empty()) throw CLI::ValidationError(sentence);
    });
}

void Command::requireOne(CommandOption first, CommandOption second) {
    addCheck([first = first.m_option, second = second.m_option] {
        if (first->empty() && second->empty())
            throw CLI::RequiredError(first->get_name() + " or " + second->get_name());
    });
}

std::vector<FileUse> Command::fileUses() const {
    std::vector<FileUse> uses;
    for (const FileOption& file : *m_files) {
        for (const std::string& path : file.option->results()) {
            if (path.empty() || path == "-") continue;  // a stream
            const bool isFile = file.role != FileRole::Read || file.extensions.empty() ||
                                std::ranges::any_of(file.extensions, [&](const std::string& extension) {
                                    return hasExtension(path, extension);
                                });
            if (!isFile) continue;
            uses.push_back({path, file.role, file.option->get_name(), file.extensions});
        }
    }
    return uses;
}

std::vector<std::string> Command::writtenOptions() const {
    std::vector<std::string> names;
    for (const FileOption& file : *m_files)
        if (file.role == FileRole::Written) names.push_back(file.option->get_name());
    return names;
}

std::string Command::name() const { return m_app->get_name(); }

CommandOption Command::operator[](const std::string& name) const { return {m_app->get_option(name), m_files}; }

std::string versionText() { return std::string("rubble-cli ") + programVersion(); }

bool isNumberInRange(const std::string& text, const NumberRange& range) {
    double number = 0.0;
    return CLI::detail::lexical_cast(text, number) && range.contains(number);
}

using Path = std::filesystem::path;
using Texts = std::vector<std::string>;

template CommandOption Command::argument(const std::string& name, std::string& value, const std::string& help);
template CommandOption Command::argument(const std::string& name, Path& value, const std::string& help);
template CommandOption Command::argument(const std::string& name, Texts& value, const std::string& help);

template CommandOption Command::option(const std::string& name, int& value, const std::string& help);
template CommandOption Command::option(const std::string& name, double& value, const std::string& help);
template CommandOption Command::option(const std::string& name, std::uint32_t& value, const std::string& help);
template CommandOption Command::option(const std::string& name, std::uint64_t& value, const std::string& help);
template CommandOption Command::option(const std::string& name, std::optional<int>& value, const std::string& help);
template CommandOption Command::option(const std::string& name, std::optional<std::uint32_t>& value,
                                       const std::string& help);
template CommandOption Command::option(const std::string& name, std::optional<double>& value, const std::string& help);
template CommandOption Command::option(const std::string& name, std::string& value, const std::string& help);
template CommandOption Command::option(const std::string& name, Path& value, const std::string& help);
template CommandOption Command::option(const std::string& name, Texts& value, const std::string& help);

}  // namespace rubble
