#include "core/play/scene/PlayBodyShape.h"

#include "core/base/Assert.h"

namespace rubble {
namespace {

/// The mass of a solid at density 1, in its asset's frame.
MassProperties massInAsset(const PlaySolid& solid) {
    MassProperties mass = solid.shape->mass;
    mass.centre += solid.offset;
    return mass;
}

}  // namespace

std::shared_ptr<const Shape> shapeOf(const PlayBody& body) {
    const PlaySolid& whole = body.asset->solid(body.fragment);
    if (!isPartial(body)) return whole.shape;
    std::vector<CompoundPart> parts;
    std::vector<MassProperties> masses;
    for (const std::uint32_t fragment : fragmentsOf(body)) {
        const PlaySolid& solid = body.asset->fragments[fragment];
        masses.push_back(massInAsset(solid));
        parts.push_back({solid.shape.get(), masses.back().centre});
    }
    const MassProperties mass = body.isHeld ? massInAsset(whole) : combined(masses);
    Result<std::shared_ptr<const Shape>> shape = compoundShape(parts, mass, body.asset);
    RUBBLE_ASSERT(shape.hasValue());  // each of the fragments can be a body
    return std::move(*shape);
}

}  // namespace rubble
