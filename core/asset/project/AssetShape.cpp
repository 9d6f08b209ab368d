#include "core/asset/project/AssetShape.h"

#include <cmath>

namespace rubble {

Box3 boundsOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return mesh->bounds;
    const Box2 plane = boundsOf(asset.prism().outline.outer);
    const double half = asset.prism().depth / 2.0;
    return {{plane.min, -half}, {plane.max, half}};
}

Vec3 sizeOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return mesh->bounds.max - mesh->bounds.min;
    return {boundsOf(asset.prism().outline.outer).size(), asset.prism().depth};
}

Box2 planeBoundsOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return {Vec2{mesh->bounds.min}, Vec2{mesh->bounds.max}};
    return boundsOf(asset.prism().outline.outer);
}

double volumeOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return mesh->mass.volume;
    return std::abs(area(asset.prism().outline)) * asset.prism().depth;
}

}  // namespace rubble
