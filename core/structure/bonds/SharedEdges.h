#pragma once

#include "core/fracture/fragments/Fragment.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// An edge between two fragments, first < second, counter-clockwise around the first.
struct SharedEdge {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t from = 0;  // points of the partition
    std::uint32_t to = 0;
};

/// The edges between two fragments, each once, piece by piece. Those of a thin piece are its receiver's.
std::vector<SharedEdge> sharedEdges(const Fragments& fragments);

}  // namespace rubble
