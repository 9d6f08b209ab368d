#include "core/play/scene/GroundHull.h"

#include <vector>

namespace rubble {
namespace {

constexpr double kGroundExtent = 200.0;  // m to each side; farther out single precision cannot resolve 0.1 mm
constexpr double kGroundDepth = 10.0;    // m

Polytope groundBox() {
    const std::vector<Vec2> ring{
        {-kGroundExtent, -kGroundDepth}, {kGroundExtent, -kGroundDepth}, {kGroundExtent, 0.0}, {-kGroundExtent, 0.0}};
    return extruded(ring, -kGroundExtent, kGroundExtent);
}

}  // namespace

std::shared_ptr<const Polytope> groundHull() { return std::make_shared<const Polytope>(groundBox()); }

}  // namespace rubble
