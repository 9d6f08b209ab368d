#include "editor/commands/Resizing.h"

#include "core/fracture/pattern/PatternKind.h"
#include "core/geometry/polygon/PolygonFaults.h"

namespace rubble {

namespace {

/// A scaling along x and y about a fixed point.
struct Scaling {
    Box2 bounds;
    Vec2 centre;
    Vec2 factor;
    Vec2 size;                    // of the scaled bounds
    double middle = 0.0;          // of the box along z: the fixed point there
    double factorOfHeight = 1.0;  // along z

    /// Maps the corners of the bounds exactly, however the factor is rounded.
    double mapped(double value, int axis) const {
        if (value == bounds.min[axis]) return centre[axis] - size[axis] / 2.0;
        if (value == bounds.max[axis]) return centre[axis] + size[axis] / 2.0;
        return centre[axis] + (value - centre[axis]) * factor[axis];
    }
    double atHeight(double z) const { return factorOfHeight == 1.0 ? z : middle + (z - middle) * factorOfHeight; }
    Vec2 operator()(Vec2 point) const {
        return {factor.x == 1.0 ? point.x : mapped(point.x, 0), factor.y == 1.0 ? point.y : mapped(point.y, 1)};
    }
};

void scale(Ring& ring, const Scaling& map) {
    for (Vec2& point : ring) point = map(point);
}

void scale(Polygon& polygon, const Scaling& map) {
    scale(polygon.outer, map);
    for (Ring& hole : polygon.holes) scale(hole, map);
}

void scale(Pattern& pattern, const Scaling& map) {
    for (PatternLayer& layer : pattern.layers) {
        for (SeedOverride& seed : layer.overrides) {
            if (seed.isDeleted) continue;
            seed.position = map(seed.position);
            seed.height = map.atHeight(seed.height);
        }
        for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
            const ParameterValue value = parameter.read(layer.parameters);
            if (parameter.isHeight) parameter.write(layer.parameters, map.atHeight(std::get<double>(value)));
            if (parameter.type == ParameterType::Point) parameter.write(layer.parameters, map(std::get<Vec2>(value)));
        }
        if (layer.scatteredIn) {
            scale(*layer.scatteredIn, map);
            // It may have become as thin as rounding, where the outline, which it was before, is not.
            const Result<Polygon> valid = validated(*layer.scatteredIn);
            if (!valid || *valid != *layer.scatteredIn) layer.scatteredIn.reset();
        }
        if (auto* placed = std::get_if<PlacedSeeds>(&layer.parameters)) {
            for (PlacedSeeds::Seed& seed : placed->seeds) {
                seed.position = map(seed.position);
                seed.height = map.atHeight(seed.height);
            }
        }
        if (auto* drawn = std::get_if<CrackLines>(&layer.parameters)) {
            for (CrackLines::CrackLine& line : drawn->lines) scale(line.points, map);
        }
    }
}

/// The strokes of bond brushes keep their radius, as patterns do.
void scale(Bonding& bonding, const Scaling& map) {
    for (BondStroke& stroke : bonding.strokes) scale(stroke.points, map);
    if (map.factor.y == 1.0) return;
    for (HeightStrength& strength : bonding.heightStrengths) strength.height *= map.factor.y;
}

/// The UV map that gives a scaled point the UV of the original point.
void scale(AffineUv& uv, const Scaling& map) {
    for (const std::size_t row : {std::size_t{0}, std::size_t{3}}) {
        double& a = uv.coefficients[row];
        double& b = uv.coefficients[row + 1];
        double& c = uv.coefficients[row + 2];
        c += a * map.centre.x * (1.0 - 1.0 / map.factor.x) + b * map.centre.y * (1.0 - 1.0 / map.factor.y);
        a /= map.factor.x;
        b /= map.factor.y;
    }
}

void scale(Surface& surface, const Scaling& map, double factorOfDepth) {
    scale(surface.front.map, map);
    scale(surface.back.map, map);
    for (SurfaceTriangle& triangle : surface.triangles) {
        for (Vec3& corner : triangle.corners) corner = {map(Vec2{corner}), corner.z * factorOfDepth};
    }
}

}  // namespace

Asset resized(Asset asset, Vec3 size) {
    const Vec3 before = sizeOf(asset);
    const Box2 bounds = planeBoundsOf(asset);
    const Scaling map{bounds,     (bounds.min + bounds.max) / 2.0, Vec2{size} / bounds.size(),
                      Vec2{size}, boundsOf(asset).centre().z,      size.z / before.z};
    if (asset.surface) {
        auto surface = std::make_shared<Surface>(*asset.surface);
        scale(*surface, map, size.z / before.z);
        asset.surface = std::move(surface);
    }
    if (asset.isPrism()) {
        scale(asset.prism().outline, map);
        asset.prism().depth = size.z;
    } else {
        asset.shape = scaled(*asset.mesh(), size / before);
    }
    scale(asset.pattern, map);
    scale(asset.bonding, map);
    return asset;
}

}  // namespace rubble
