#include "core/physics/shape/Shape.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

bool isPositive(const MassProperties& mass) {
    const Vec3 moments(mass.inertia[0][0], mass.inertia[1][1], mass.inertia[2][2]);
    const bool isFinite =
        std::isfinite(mass.volume + mass.centre.x + mass.centre.y + mass.centre.z + moments.x + moments.y + moments.z);
    return isFinite && mass.volume > 0.0 && moments.x > 0.0 && moments.y > 0.0 && moments.z > 0.0 &&
           glm::determinant(mass.inertia) > 0.0;
}

/// The least moment of inertia that a shape may have, relative to the sum of its moments: that of a needle a hundred
/// times as long as wide. Contacts would spin thinner ones faster than single precision can follow.
constexpr double kMinMoment = 1e-4;

/// Raises the moments of inertia of what is too thin for its length; leaves all others as they are.
Mat3 withMinMoment(const Mat3& inertia) {
    const auto trace = [](const Mat3& m) { return m[0][0] + m[1][1] + m[2][2]; };
    const double least = 1.0 / trace(glm::inverse(inertia));  // at most the least moment
    return inertia + Mat3(std::max(0.0, kMinMoment * trace(inertia) - least));
}

/// A shape without hulls.
///
/// Errors: BadInput for mass properties that are not positive and finite.
Result<std::shared_ptr<Shape>> emptyShape(const MassProperties& mass) {
    if (!isPositive(mass)) {
        return Error{ErrorCode::BadInput, "The volume and inertia of a body must be positive and finite."};
    }
    auto shape = std::make_shared<Shape>();
    shape->mass = mass;
    shape->inertia = withMinMoment(mass.inertia);
    shape->inverseInertia = glm::inverse(shape->inertia);
    return shape;
}

/// Sets what a shape says of its hulls.
void setBounds(Shape& shape) {
    float boundingRadius = 0.0f, minWidth = std::numeric_limits<float>::infinity(), minTurn = 1.0f;
    Vec3f extents(0.0f);
    for (const PlacedHull& placed : shape.hulls) {
        const Hull& hull = *placed.hull;
        boundingRadius = std::max(boundingRadius, length(placed.offset) + hull.boundingRadius);
        extents = componentMax(extents, componentAbs(placed.offset + hull.middle) + hull.extents);
        minWidth = std::min(minWidth, hull.minWidth);
        minTurn = std::min(minTurn, hull.minTurn);
    }
    shape.boundingRadius = boundingRadius;
    shape.extents = extents;
    shape.minWidth = minWidth;
    shape.minTurn = minTurn;
}

Error noHulls() { return {ErrorCode::BadInput, "A body needs at least one hull."}; }

}  // namespace

Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes) {
    std::vector<MassProperties> parts;
    for (const Polytope& polytope : polytopes) parts.push_back(massOf(polytope));
    return makeShape(polytopes, combined(parts));
}

Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes, const MassProperties& mass) {
    if (polytopes.empty()) return noHulls();
    Result<std::shared_ptr<Shape>> shape = emptyShape(mass);
    if (!shape) return shape.error();
    auto hulls = std::make_shared<std::vector<Hull>>();
    hulls->reserve(polytopes.size());
    for (const Polytope& polytope : polytopes) {
        Result<Hull> hull = makeHull(polytope, mass.centre);
        if (!hull) return hull.error();
        hulls->push_back(std::move(*hull));
    }
    for (const Hull& hull : *hulls) (*shape)->hulls.push_back({&hull});
    setBounds(**shape);
    (*shape)->owner = std::move(hulls);
    return std::shared_ptr<const Shape>(std::move(*shape));
}

Result<std::shared_ptr<const Shape>> compoundShape(std::span<const CompoundPart> parts, const MassProperties& mass,
                                                   std::shared_ptr<const void> owner) {
    if (parts.empty()) return noHulls();
    Result<std::shared_ptr<Shape>> shape = emptyShape(mass);
    if (!shape) return shape.error();
    std::size_t count = 0;
    for (const CompoundPart& part : parts) count += part.shape->hulls.size();
    (*shape)->hulls.resize(count);
    auto to = (*shape)->hulls.begin();
    const Vec3 centre = mass.centre;
    for (const CompoundPart& part : parts) {
        const Vec3f offset = toFloat(part.centre - centre);
        for (const PlacedHull& hull : part.shape->hulls) *to++ = {hull.hull, hull.offset + offset};
    }
    setBounds(**shape);
    (*shape)->owner = std::move(owner);
    return std::shared_ptr<const Shape>(std::move(*shape));
}

Vec3 spinOfPart(const Shape& shape, const Quat& orientation, Vec3 angularVelocity) {
    if (shape.inertia == shape.mass.inertia) return angularVelocity;
    const Vec3 own = glm::conjugate(orientation) * angularVelocity;
    return orientation * (shape.inverseInertia * (shape.mass.inertia * own));
}

std::shared_ptr<const Shape> remainingShape(const Shape& shape, std::span<const std::uint32_t> hulls) {
    RUBBLE_ASSERT(!hulls.empty());
    auto remaining = std::make_shared<Shape>();
    remaining->hulls.resize(hulls.size());
    for (std::size_t k = 0; k < hulls.size(); ++k) remaining->hulls[k] = shape.hulls[hulls[k]];
    remaining->owner = shape.owner;
    remaining->mass = shape.mass;
    remaining->inertia = shape.inertia;
    remaining->inverseInertia = shape.inverseInertia;
    remaining->boundingRadius = shape.boundingRadius;
    remaining->extents = shape.extents;
    remaining->minWidth = shape.minWidth;
    remaining->minTurn = shape.minTurn;
    return remaining;
}

}  // namespace rubble
