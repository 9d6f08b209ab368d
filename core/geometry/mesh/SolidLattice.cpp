#include "core/geometry/mesh/SolidLattice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace rubble {

SolidLattice::SolidLattice(const Box3& box) : m_origin(box.min) {
    int exponent = 0;
    std::frexp(glm::length(box.max - box.min), &exponent);  // the diagonal is below 2^exponent
    m_step = std::ldexp(1.0 / kLatticeSteps, exponent);
}

Vec3 SolidLattice::snapped(Vec3 point) const { return glm::round(steps(point)); }

}  // namespace rubble
