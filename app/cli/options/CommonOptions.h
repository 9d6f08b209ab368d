#pragma once

#include "core/base/MessageText.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

class Command;

/// Adds FILE, the project, which is required.
void addProjectArgument(Command& command, std::string& file);

/// Adds --json, for JSON instead of text.
void addJsonOption(Command& command, bool& isJson);

/// Adds --threads; the default is the number of processors.
void addThreadsOption(Command& command, int& threads);

/// Adds --unit, the length of a unit of a mesh file; the default is the file's own.
void addUnitOption(Command& command, std::optional<double>& metresPerUnit);

/// Returns "a, b, c".
std::string joinedText(const std::vector<std::string>& words);

/// Returns the names of elements for an error message: `it has "a", "b"` or `it has none`.
template <class Element>
std::string quotedNamesOf(const std::vector<Element>& elements) {
    std::vector<std::string> names;
    for (const Element& element : elements) names.push_back(element.name);
    return names.empty() ? "it has none" : "it has " + quotedNames(names);
}

}  // namespace rubble
