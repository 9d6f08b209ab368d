#include "core/play/scene/GroundHull.h"

#include "core/physics/state/BodyDefinition.h"

#include <vector>

namespace rubble {
namespace {

constexpr double kGroundExtent = 1.1 * kMaxCoordinate;  // m to each side: it holds wherever a body can be
constexpr double kGroundDepth = 10.0;                   // m

Polytope groundBox() {
    const std::vector<Vec2> ring{
        {-kGroundExtent, -kGroundDepth}, {kGroundExtent, -kGroundDepth}, {kGroundExtent, 0.0}, {-kGroundExtent, 0.0}};
    return extruded(ring, -kGroundExtent, kGroundExtent);
}

}  // namespace

std::shared_ptr<const Polytope> groundHull() { return std::make_shared<const Polytope>(groundBox()); }

}  // namespace rubble
