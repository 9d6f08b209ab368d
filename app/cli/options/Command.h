#pragma once

#include "core/io/output/FileUse.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rubble {

enum class ProjectNumber;
struct NumberRange;

/// The name of the check of CommandOption::oneOf() is this, and then the words, separated by spaces.
inline constexpr const char* kWordsPrefix = "words ";

/// An option whose values are files that the verb uses.
struct FileOption {
    CLI::Option* option = nullptr;
    FileRole role = FileRole::Read;
    std::vector<std::string> extensions;  // see FileUse; of what is read: other values are no files
};

/// Whether a path has an extension, in letters of any case.
bool hasExtension(const std::string& path, const std::string& extension);

using FileOptions = std::vector<FileOption>;

/// An option, a flag or a positional argument of a command, which owns it. Each function returns the option itself.
class CommandOption {
public:
    CommandOption(CLI::Option* option, std::shared_ptr<FileOptions> files)
        : m_option(option), m_files(std::move(files)) {}

    CommandOption required() const;
    /// Sets the name of the value in --help, which then mentions no other property of the option.
    CommandOption valueName(const std::string& text) const;
    /// Sets the name of the value in --help, which also mentions the options that this one needs or excludes.
    CommandOption typeName(const std::string& text) const;
    /// Takes a single value wherever it is given.
    CommandOption single() const;
    /// Takes a single value wherever it is given, and may be given repeatedly.
    CommandOption repeatable() const;
    /// Splits a value at each `separator`.
    CommandOption separatedBy(char separator) const;

    /// Keeps it out of --help and of completions.
    CommandOption hidden() const;

    /// Accepts these words only.
    CommandOption oneOf(const std::vector<std::string>& words) const;
    /// Accepts these words, and files with an extension, such as ".hdr", which the verb reads.
    CommandOption oneOfOrFile(const std::vector<std::string>& words, const std::string& extension) const;
    /// Accept numbers, or whole numbers, in the range of a number only.
    CommandOption inRange(ProjectNumber number) const;
    CommandOption wholeInRange(ProjectNumber number) const;
    /// Accepts whole numbers from 0 to `max` only.
    CommandOption wholeUpTo(std::uint32_t max) const;
    /// Accepts texts for which `check` returns no error.
    CommandOption check(std::function<std::string(const std::string& text)> check) const;
    /// Reads words that a value had in earlier versions: pairs of the former word and the present one.
    CommandOption formerWords(std::vector<std::pair<std::string, std::string>> words) const;
    /// Replaces the text by means of `convert`, which returns an error for an invalid one.
    CommandOption convert(std::function<std::string(std::string& text)> convert) const;

    /// Its values are files that the verb reads, changes or writes: see checkFileUses(). `extensions`: lower case, of
    /// what is written; none: any.
    CommandOption reads() const;
    CommandOption changes() const;
    CommandOption writes(std::vector<std::string> extensions) const;

    CommandOption needs(CommandOption other) const;
    CommandOption excludes(CommandOption other) const;

private:
    friend class Command;
    CommandOption uses(FileRole role, std::vector<std::string> extensions) const;

    CLI::Option* m_option;
    std::shared_ptr<FileOptions> m_files;  // of the command
};

/// The command line of a verb: its options, arguments and help. CLI11, which takes seconds to compile, is included by
/// Command.cpp, CommandTree.cpp and Cli.cpp only.
class Command {
public:
    /// Adds a subcommand to the program, which owns it.
    Command(CLI::App& program, const std::string& name, const std::string& description, const std::string& footer);

    bool isParsed() const;

    /// Adds a positional argument or an option. `value` holds the default and must outlive the command. A Value is a
    /// std::string, a number, an optional number, a path, or a vector of std::string.
    template <class Value>
    CommandOption argument(const std::string& name, Value& value, const std::string& help);
    template <class Value>
    CommandOption option(const std::string& name, Value& value, const std::string& help);
    /// Adds an option whose text is given to `apply`.
    CommandOption callback(const std::string& name, std::function<void(const std::string& text)> apply,
                           const std::string& help);
    CommandOption flag(const std::string& name, bool& value, const std::string& help);

    /// Adds the options that all verbs have, after their own: --quiet, and --version, which --help leaves out.
    void addCommonFlags();
    bool isQuiet() const;
    /// Adds --json, for a document of results instead of text: see VerbReport.
    void addReportFlag();
    /// Keeps the verb out of --help and of completions.
    void hide();
    /// Whether --json of addReportFlag() was given.
    bool isReportWanted() const;
    /// Requires at least one of two options.
    void requireOne(CommandOption first, CommandOption second);
    /// Refuses options that do not fit together, as an error of usage: `fault` returns a sentence on what is wrong with
    /// those that were given, or nothing.
    void requireFit(std::function<std::string()> fault);

    /// The files that were given.
    std::vector<FileUse> fileUses() const;
    /// The names of the options whose values are written: "--out", "FOLDER".
    std::vector<std::string> writtenOptions() const;
    std::string name() const;

    /// Returns the option that was added with a name.
    CommandOption operator[](const std::string& name) const;

private:
    void addCheck(std::function<void()> check);

    CLI::App* m_app;
    std::shared_ptr<FileOptions> m_files = std::make_shared<FileOptions>();
    std::shared_ptr<std::vector<std::function<void()>>> m_checks =
        std::make_shared<std::vector<std::function<void()>>>();  // of what was parsed
    bool m_hasReport = false;
};

/// Returns the name and the version of the program, for --version.
std::string versionText();

/// Returns whether `text` is a number in the range.
bool isNumberInRange(const std::string& text, const NumberRange& range);

}  // namespace rubble
