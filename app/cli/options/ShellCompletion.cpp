#include "app/cli/options/ShellCompletion.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace rubble {
namespace {

std::string joinedBy(const std::vector<std::string>& words, std::string_view separator) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : std::string(separator)) + word;
    return text;
}

/// Puts a backslash before each of some letters.
std::string escaped(std::string_view text, std::string_view letters) {
    std::string result;
    for (const char letter : text) {
        if (letters.find(letter) != std::string_view::npos) result += '\\';
        result += letter;
    }
    return result;
}

/// A text in single quotes, as bash and zsh read it: 'it'\''s'.
std::string shellQuoted(std::string_view text) {
    std::string result = "'";
    for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return result + "'";
}

std::string fishQuoted(std::string_view text) { return "'" + escaped(text, "\\'") + "'"; }

std::string headerOf(const char* shell) {
    return std::string("# Completion of rubble-cli for ") + shell + ", printed by rubble-cli completion " + shell +
           ".\n";
}

std::vector<std::string> namesOf(std::span<const CommandTreeVerb> verbs) {
    std::vector<std::string> names;
    for (const CommandTreeVerb& verb : verbs) names.push_back(verb.name);
    return names;
}

/// The statement that completes a value after an option, or for a positional argument.
std::string bashValue(const CommandTreeOption& option) {
    switch (option.value) {
        case ValueKind::None:
        case ValueKind::File: break;
        case ValueKind::Words: return "words=" + shellQuoted(joinedBy(option.words, " "));
        case ValueKind::Folder: return "_rubble_cli_folders \"$current\"; return";
        case ValueKind::Other: return "compopt +o default 2>/dev/null; return";
    }
    return "return";  // which leaves files to readline
}

std::string bashVerb(const CommandTreeVerb& verb) {
    std::string text = "        " + verb.name + ")\n            case $previous in\n";
    std::vector<std::string> names;
    for (const CommandTreeOption& option : verb.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (option.value == ValueKind::None) continue;
        text += "                " + joinedBy(option.names, " | ") + ") " + bashValue(option) + " ;;\n";
    }
    text += "                *)\n                    if [[ $current == -* ]]; then\n                        words=" +
            shellQuoted(joinedBy(names, " ")) + "\n                    else\n";
    const auto words = std::ranges::find(verb.arguments, ValueKind::Words, &CommandTreeOption::value);
    text += "                        " + (words != verb.arguments.end() ? bashValue(*words) : "return") + "\n";
    return text + "                    fi ;;\n            esac ;;\n";
}

/// The part of an argument specification of zsh after the name: ":FILE:_files".
std::string zshValue(const CommandTreeOption& option, const std::string& message) {
    const std::string start = ":" + escaped(message, ":") + ":";
    switch (option.value) {
        case ValueKind::None: return "";
        case ValueKind::Words: return start + "(" + joinedBy(option.words, " ") + ")";
        case ValueKind::File: return start + "_files";
        case ValueKind::Folder: return start + "_files -/";
        case ValueKind::Other: break;
    }
    return start + " ";
}

std::string zshOption(const CommandTreeOption& option) {
    const bool hasValue = option.value != ValueKind::None;
    const std::string description = "[" + escaped(option.description, "[]:\\") + "]";
    const std::string rest = shellQuoted(description + zshValue(option, "value"));
    const auto withEnding = [hasValue](const std::string& name) {
        return name + (!hasValue ? "" : name.starts_with("--") ? "=" : "+");
    };
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(withEnding(name));
    const std::string prefix = option.isRepeatable ? "'*'"
                               : names.size() > 1  ? shellQuoted("(" + joinedBy(option.names, " ") + ")")
                                                   : "";
    return prefix + (names.size() > 1 ? "{" + joinedBy(names, ",") + "}" : names.front()) + rest;
}

std::string zshVerb(const CommandTreeVerb& verb) {
    std::string text = "        " + verb.name + ")\n            _arguments";
    for (const CommandTreeOption& option : verb.options) text += " \\\n                " + zshOption(option);
    for (std::size_t k = 0; k < verb.arguments.size(); ++k) {
        const CommandTreeOption& argument = verb.arguments[k];
        const std::string place = argument.isRepeatable ? "*" : std::to_string(k + 1);
        text += " \\\n                " + shellQuoted(place + zshValue(argument, argument.names.front()));
    }
    return text + " ;;\n";
}

std::string fishOption(const CommandTreeVerb& verb, const CommandTreeOption& option) {
    std::string text = "complete -c rubble-cli -n '__fish_seen_subcommand_from " + verb.name + "'";
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    switch (option.value) {
        case ValueKind::None: break;
        case ValueKind::Words: text += " -x -a " + fishQuoted(joinedBy(option.words, " ")); break;
        case ValueKind::File: text += " -r -F"; break;
        case ValueKind::Folder: text += " -x -a '(__fish_complete_directories)'"; break;
        case ValueKind::Other: text += " -x"; break;
    }
    return text + " -d " + fishQuoted(option.description) + '\n';
}

}  // namespace

std::string bashCompletion(std::span<const CommandTreeVerb> verbs) {
    std::string text = headerOf("bash") + R"(
_rubble_cli_folders() {
    mapfile -t COMPREPLY < <(compgen -d -- "$1")
    compopt -o filenames 2>/dev/null
}

_rubble_cli() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]} words=
    COMPREPLY=()
    # Of --option=value, bash makes three words.
    if [[ $previous == = ]]; then previous=${COMP_WORDS[COMP_CWORD - 2]}; fi
    if [[ $current == = ]]; then current=; fi
    if ((COMP_CWORD == 1)); then verb=; fi
    case $verb in
        '') words=)" + shellQuoted(joinedBy(namesOf(verbs), " ") + " --help --version") +
                       " ;;\n";
    for (const CommandTreeVerb& verb : verbs) text += bashVerb(verb);
    return text + R"(    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}

complete -o default -F _rubble_cli rubble-cli
)";
}

std::string zshCompletion(std::span<const CommandTreeVerb> verbs) {
    std::string text = "#compdef rubble-cli\n" + headerOf("zsh") + R"(
_rubble-cli() {
    local -a verbs
    if ((CURRENT == 2)); then
        verbs=(
)";
    for (const CommandTreeVerb& verb : verbs)
        text += "            " + shellQuoted(verb.name + ":" + escaped(verb.description, ":\\")) + '\n';
    text += R"(        )
        _describe 'verb' verbs
        _arguments '--help[Print the help]' '--version[Print the version]'
        return
    fi
    shift words
    ((CURRENT--))
    case $words[1] in
)";
    for (const CommandTreeVerb& verb : verbs) text += zshVerb(verb);
    return text + R"(    esac
}

_rubble-cli "$@"
)";
}

std::string fishCompletion(std::span<const CommandTreeVerb> verbs) {
    std::string text = headerOf("fish") + "\n";
    const std::string first = "complete -c rubble-cli -n __fish_use_subcommand -f";
    text += first + " -s h -l help -d 'Print the help'\n" + first + " -l version -d 'Print the version'\n";
    for (const CommandTreeVerb& verb : verbs)
        text += first + " -a " + verb.name + " -d " + fishQuoted(verb.description) + '\n';
    for (const CommandTreeVerb& verb : verbs) {
        for (const CommandTreeOption& option : verb.options) text += fishOption(verb, option);
        for (const CommandTreeOption& argument : verb.arguments) {
            if (argument.value != ValueKind::Words) continue;  // files are the default
            text += "complete -c rubble-cli -n '__fish_seen_subcommand_from " + verb.name + "' -a " +
                    fishQuoted(joinedBy(argument.words, " ")) + '\n';
        }
    }
    return text;
}

}  // namespace rubble
