#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace rubble {

/// What an option or an argument expects.
enum class ValueKind {
    None,    // it is a flag
    Words,   // one of a few words
    File,    // a path of a file
    Folder,  // a path of a folder
    Other,   // a name, a number or another text
};

/// An option or a positional argument of a verb.
struct CommandTreeOption {
    std::vector<std::string> names;  // "-o", "--out"; of an argument its name
    std::string description;
    ValueKind value = ValueKind::None;
    std::vector<std::string> words;  // that are accepted
    bool isRepeatable = false;
};

struct CommandTreeVerb {
    std::string name;
    std::string description;
    std::vector<CommandTreeOption> options;
    std::vector<CommandTreeOption> arguments;
};

/// The verbs of the program with the options that --help shows, in its order, and "help", which takes a verb.
std::vector<CommandTreeVerb> commandTree(CLI::App& program);

}  // namespace rubble
