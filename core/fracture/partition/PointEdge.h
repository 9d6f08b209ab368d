#pragma once

#include <cstdint>

namespace rubble {

/// An edge from one point to another, by index.
struct PointEdge {
    std::uint32_t from, to;
    bool operator==(const PointEdge&) const = default;
};

}  // namespace rubble
