#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace rubble {

/// Returns a validator that accepts these words only.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Return validators that accept numbers in a range only.
CLI::Validator numberBetween(int min, int max);
CLI::Validator numberBetween(double min, double max);

/// Adds --threads; the default is the number of processors.
void addThreadsOption(CLI::App& command, int& threads);

/// Adds --unit, the length of a unit of a mesh file; the default is the file's own.
void addUnitOption(CLI::App& command, std::optional<double>& metresPerUnit);

/// Returns "a, b, c".
std::string joinedText(const std::vector<std::string>& words);

/// Returns the names of elements for an error message: `it has "a", "b"` or `it has none`.
template <class Element>
std::string quotedNamesOf(const std::vector<Element>& elements) {
    std::string names;
    for (const Element& element : elements) names += (names.empty() ? "\"" : ", \"") + element.name + '"';
    return names.empty() ? "it has none" : "it has " + names;
}

}  // namespace rubble
