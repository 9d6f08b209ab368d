#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rubble::attack {

/// A JSON value as text that need not be valid: an object may repeat keys, a scalar is any text.
struct JsonTree {
    enum class Kind { Scalar, Array, Object };

    Kind kind = Kind::Scalar;
    std::string text;                                        // of a scalar, as written: "\"a\"", "1e5"
    std::vector<std::pair<std::string, JsonTree>> children;  // the keys as written: "\"a\""; empty in arrays
};

/// Reads valid JSON.
JsonTree treeOf(std::string_view json);
std::string textOf(const JsonTree& tree);

}  // namespace rubble::attack
