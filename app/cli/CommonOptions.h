#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace rubble {

/// Lets an option take these words only; what else is given is refused with all of them.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Lets an option take numbers of a range only; anything else is refused with the range.
CLI::Validator numberBetween(int min, int max);
CLI::Validator numberBetween(double min, double max);

/// Adds --threads, which is all processors unless it is given.
void addThreadsOption(CLI::App& command, int& threads);

/// Adds --unit, which says what one unit of a mesh file is; as the file says where it is not given.
void addUnitOption(CLI::App& command, std::optional<double>& metresPerUnit);

/// `words` as "a, b, c".
std::string joinedText(const std::vector<std::string>& words);

/// What elements are called, for a sentence: `it has "a", "b"`, or `it has none`.
template <class Element>
std::string quotedNamesOf(const std::vector<Element>& elements) {
    std::string names;
    for (const Element& element : elements) names += (names.empty() ? "\"" : ", \"") + element.name + '"';
    return names.empty() ? "it has none" : "it has " + names;
}

}  // namespace rubble
