#pragma once

#include <cstddef>
#include <vector>

namespace rubble {

/// The memory of the elements of vectors, in bytes, without spare capacity and what the elements own.
template <class... Elements>
std::size_t elementBytes(const std::vector<Elements>&... vectors) {
    return (... + (vectors.size() * sizeof(Elements)));
}

}  // namespace rubble
