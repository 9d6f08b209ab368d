#pragma once

#include "core/fracture/solid/SolidPartition.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The common faces of two fragments of a solid.
struct SolidContact {
    std::uint32_t first = 0;
    std::uint32_t second = 0;  // > first
    double area = 0.0;         // m²
    Vec3 centroid{0.0};        // m, relative to the partition's origin
    Vec3 normal{0.0};          // of length 1, the area-weighted mean from first to second; 0 where that vanishes
    Mat3 moments{0.0};         // m⁴: the integral of r rᵀ over the faces, r from the centroid
};

/// The contacts of all fragments that share faces, by first, then second. O(triangles).
std::vector<SolidContact> contactsOf(const SolidPartition& partition);

}  // namespace rubble
