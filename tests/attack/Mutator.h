#pragma once

#include "core/base/Random.h"
#include "tests/attack/JsonTree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::attack {

/// Makes damaged copies of the valid texts of one JSON format.
class JsonMutator {
public:
    /// `samples`: valid texts. `schema`: the format's JSON Schema, whose limits and words are used as values of the
    /// keys that they belong to; empty if the format has none.
    JsonMutator(const std::vector<std::string>& samples, std::string_view schema);

    /// A sample with one to four changes: values replaced, keys missing, repeated, renamed or added, subtrees moved,
    /// deep nesting; one in eight is changed as bytes instead.
    std::string mutated(Random& random) const;

private:
    void readValues(const JsonTree& tree);
    void readSchema(const JsonTree& schema);
    void change(JsonTree& document, Random& random) const;
    void changeMembers(JsonTree& tree, Random& random) const;
    std::string newText(const std::string& key, const std::string& old, Random& random) const;

    std::vector<JsonTree> m_samples;
    std::map<std::string, std::vector<std::string>> m_values;  // by key; "" for elements of arrays
    std::vector<std::string> m_keys;
};

/// Changes bytes: flips bits, overwrites, inserts, repeats or removes runs, truncates, appends.
std::string mutatedBytes(std::string bytes, Random& random);

/// Changes the words and lines of a text format, such as OBJ: numbers become others, lines are repeated, swapped or
/// removed.
std::string mutatedLines(const std::string& text, Random& random);

/// A text where a number is expected: limits of types, huge, tiny, negative zero, and texts that are none in JSON.
std::string oddNumber(Random& random);

}  // namespace rubble::attack
