#include "core/play/scene/PlayBodyShape.h"

#include "core/base/Assert.h"

namespace rubble {
namespace {

/// What is left of a held body, at its place among all fragments.
std::shared_ptr<const Shape> heldShape(const PlayBody& body) {
    const PlayFracture& fracture = *body.asset->fractureOf(body.fragment);
    std::vector<std::uint32_t> hulls;
    hulls.reserve(body.nodes.size());
    for (const std::uint32_t node : body.nodes) {
        for (std::uint32_t hull = fracture.firstHull[node]; hull < fracture.firstHull[node + 1]; ++hull)
            hulls.push_back(hull);
    }
    return remainingShape(*fracture.bonded, hulls);
}

}  // namespace

std::shared_ptr<const Shape> shapeOf(const PlayBody& body) {
    if (!isPartial(body)) return body.asset->solid(body.fragment).shape;
    if (body.isHeld) return heldShape(body);
    std::vector<CompoundPart> parts;
    std::vector<MassProperties> masses;
    for (const std::uint32_t fragment : fragmentsOf(body)) {
        const PlaySolid& solid = body.asset->fragments[fragment];
        masses.push_back(solid.shape->mass);
        masses.back().centre = centreInAsset(solid);
        parts.push_back({solid.shape.get(), masses.back().centre});
    }
    Result<std::shared_ptr<const Shape>> shape = compoundShape(parts, combined(masses), body.asset);
    RUBBLE_ASSERT(shape.hasValue());  // each of the fragments can be a body
    return std::move(*shape);
}

}  // namespace rubble
