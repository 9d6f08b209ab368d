#include "app/cli/output/Depfile.h"

#include "core/base/MessageText.h"

namespace rubble {
namespace {

/// Adds a path with a space before it.
///
/// Errors: BadInput.
Status appendPath(std::string& text, const std::string& path) {
    if (path.find_first_of("\n\t") != std::string::npos) {
        return Error{ErrorCode::BadInput,
                     "A dependency file cannot name " + quotedName(path) + ", which has a line feed or a tab."};
    }
    text += text.empty() ? "" : " ";
    std::size_t backslashes = 0;  // right before the letter
    for (const char letter : path) {
        if (letter == ' ' || letter == '#') text.append(backslashes + 1, '\\');  // they would escape each other
        if (letter == ':') text += '\\';
        if (letter == '$') text += '$';
        text += letter;
        backslashes = letter == '\\' ? backslashes + 1 : 0;
    }
    return success();
}

}  // namespace

Result<std::string> depfileText(std::span<const std::string> targets, std::span<const std::string> prerequisites) {
    if (targets.empty()) return std::string();
    std::string text;
    for (const std::string& target : targets) {
        if (const Status appended = appendPath(text, target); !appended) return appended.error();
    }
    text += ':';
    for (const std::string& prerequisite : prerequisites) {
        if (const Status appended = appendPath(text, prerequisite); !appended) return appended.error();
    }
    return text + '\n';
}

}  // namespace rubble
