#pragma once

#include "core/base/Index.h"
#include "core/fracture/solid/SolidPartition.h"

#include <glm/geometric.hpp>

#include <cstdint>
#include <vector>

namespace rubble {

/// The plane of inner faces to one neighbour.
struct ContactPlane {
    std::uint32_t neighbour = kNone;
    Vec3 normal{0.0};                  // of length 1, out of the fragment
    double height = 0.0;               // m: of the plane, along its normal
    double slack = 0.0;                // m: how far points of the plane may seem to be from it
    std::vector<std::uint32_t> sides;  // places in facesOf(fragment)
    double heightOf(Vec3 point) const { return glm::dot(point, normal) - height; }
};

/// The planes of the inner faces of a fragment; the largest face in a plane decides where it is. `extent`: the
/// fragment's, m. Faces that are hardly wider than `tolerance`, m, have none.
std::vector<ContactPlane> contactPlanes(const SolidPartition& partition, std::uint32_t fragment, double tolerance,
                                        double extent);

}  // namespace rubble
