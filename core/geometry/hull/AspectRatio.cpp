#include "core/geometry/hull/AspectRatio.h"

#include "core/geometry/hull/PrincipalInertia.h"

#include "core/geometry/hull/MassProperties.h"

#include <cmath>

namespace rubble {

double aspectRatio(const Polygon& polygon) {
    const Mat3 inertia = massOfPrism(polygon, 1.0).inertia;
    // The integrals of x², y² and x y over the area.
    const double xx = (inertia[1][1] + inertia[2][2] - inertia[0][0]) / 2.0;
    const double yy = (inertia[0][0] + inertia[2][2] - inertia[1][1]) / 2.0;
    const double xy = -inertia[0][1];
    const double mean = (xx + yy) / 2.0, spread = std::sqrt((xx - yy) * (xx - yy) / 4.0 + xy * xy);
    if (!(mean > spread)) return 1.0;
    return std::sqrt((mean + spread) / (mean - spread));
}

double aspectRatio(const MassProperties& body) {
    const Vec3 inertia = principalInertia(body.inertia).moments;
    const double half = (inertia.x + inertia.y + inertia.z) / 2.0;
    std::array<double, 3> along{half - inertia.x, half - inertia.y, half - inertia.z};
    std::ranges::sort(along);
    return along[1] > 0.0 ? std::sqrt(along[2] / along[1]) : 1.0;
}

}  // namespace rubble
