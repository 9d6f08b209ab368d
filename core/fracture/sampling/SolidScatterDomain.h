#pragma once

#include "core/fracture/sampling/ScatterDomain.h"
#include "core/fracture/sampling/SolidDomain.h"

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
    /// A uniform random point.
    Vec3 point(Random& random) const {
        if (!isBox()) return solid.point(random);
        const double x = random.unit(), y = random.unit(), z = random.unit();
        return solid.bounds().min + Vec3(x, y, z) * size();
    }
};

}  // namespace rubble
