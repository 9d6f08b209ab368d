#include "core/fracture/planes/SectionPlane.h"

#include <cmath>

namespace rubble {

SectionPlane axisPlane(int axis, double coordinate) {
    SectionPlane plane{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    plane.origin[axis] = coordinate;
    plane.x[(axis + 1) % 3] = 1.0;
    plane.y[(axis + 2) % 3] = 1.0;
    return plane;
}

SectionPlane sectionPlane(int axis, double coordinate) {
    switch (axis) {
        case 0: return {{coordinate, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
        case 1: return {{0.0, coordinate, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
        default: return {{0.0, 0.0, coordinate}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    }
}

SectionPlane planeThrough(Vec3 point, Vec3 normal) {
    const Vec3 up = glm::normalize(normal), size(std::abs(up.x), std::abs(up.y), std::abs(up.z));
    const int farthest = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    Vec3 axis(0.0);
    axis[farthest] = 1.0;
    const Vec3 x = glm::normalize(glm::cross(axis, up));
    return {point, x, glm::cross(up, x)};
}

}  // namespace rubble
