#pragma once

#include "core/fracture/sampling/ScatterDomain.h"
#include "core/fracture/sampling/SolidDomain.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {

/// A closed mesh or its bounding box, in which a layer scatters its seeds.
struct SolidScatterDomain {
    const SolidDomain& solid;
    ScatterDomain domain = ScatterDomain::Outline;

    bool isBox() const { return domain == ScatterDomain::BoundingBox; }
    Vec3 size() const { return solid.bounds().max - solid.bounds().min; }
    double volume() const { return isBox() ? size().x * size().y * size().z : solid.volume(); }  // m³
    /// Whether seeds may be at a point of the bounding box.
    bool contains(Vec3 point) const { return isBox() || solid.contains(point); }
    /// The distance of a point to the boundary, m: negative outside.
    double depth(Vec3 point) const {
        if (!isBox()) return solid.depth(point);
        const Vec3 outside = glm::max(solid.bounds().min - point, point - solid.bounds().max);
        const double most = std::max({outside.x, outside.y, outside.z});
        return most <= 0.0 ? -most : -glm::length(glm::max(outside, Vec3(0.0)));
    }
    /// A uniform random point.
    Vec3 point(Random& random) const {
        if (!isBox()) return solid.point(random);
        const double x = random.unit(), y = random.unit(), z = random.unit();
        return solid.bounds().min + Vec3(x, y, z) * size();
    }
};

}  // namespace rubble
