#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/physics/shape/Hull.h"

#include <memory>
#include <span>
#include <vector>

namespace rubble {

/// A hull of a shape. It is shared: the shapes of a compound and of its parts have the same hulls at other offsets.
struct PlacedHull {
    const Hull* hull = nullptr;      // never null in a shape
    Vec3f offset{0.0f, 0.0f, 0.0f};  // m: of the hull's origin from the shape's centre of mass
};

/// The collision shape and mass properties of a body: one or more convex hulls relative to their common centre of mass.
/// Shared by all bodies of this shape.
struct Shape {
    std::vector<PlacedHull> hulls;
    std::shared_ptr<const void> owner;  // of the hulls
    MassProperties mass;                // at density 1 kg/m³, in the frame of the given polytopes
    Mat3 inertia{1.0};                  // kg·m², at that density: that of the mass, raised for what is too thin
    Mat3 inverseInertia{1.0};           // 1/(kg·m²), of this inertia
    float boundingRadius = 0.0f;        // m: distance from the centre of mass to the farthest vertex, at least
    // m: the largest distance of a vertex from the centre of mass along each axis; at least that of a remainingShape().
    Vec3f extents{0.0f};
    // m: the least width of any hull, or less of a remainingShape(); a body moving farther in a step may tunnel.
    float minWidth = 0.0f;
    float minTurn = 1.0f;  // that of its hulls, or less of a remainingShape()
};

/// Whether a shape has a hull of many faces, which stand for a round surface.
inline bool isRounded(const Shape& shape) { return shape.minTurn < kSharpTurn; }

/// The shape of convex polytopes in one frame. Mass properties are those of the polytopes, or those given, such as
/// those of the exact fragment if the polytopes are simplified.
///
/// Errors: those of makeHull(); BadInput for no polytope, or mass properties that are not positive and finite.
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes);
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes, const MassProperties& mass);

/// A shape that is a part of a compound, with parallel axes.
struct CompoundPart {
    const Shape* shape = nullptr;
    Vec3 centre{0.0, 0.0, 0.0};  // m: of its mass, in the compound's frame
};

/// A compound of other shapes: their hulls, in that order, at other offsets. O(hulls); copies no hull. `owner` keeps
/// the parts' hulls alive. The mass properties are those given, in the compound's frame.
///
/// Errors: BadInput for no part, or mass properties that are not positive and finite.
Result<std::shared_ptr<const Shape>> compoundShape(std::span<const CompoundPart> parts, const MassProperties& mass,
                                                   std::shared_ptr<const void> owner);

/// The angular velocity, rad/s in world axes, of a part of a body that rotates at another one: the same, but for a
/// shape whose inertia is raised. That one takes the angular momentum of its mass, or energy would appear.
Vec3 spinOfPart(const Shape& shape, const Quat& orientation, Vec3 angularVelocity);

/// The shape of some hulls of another one, by number, which stay where they are in it; one hull at least. All else
/// remains as it is, the mass properties and bounds as well: this is the shape of what is left of a held body, of which
/// they are never read but as bounds. O(hulls), and many times faster than compoundShape().
std::shared_ptr<const Shape> remainingShape(const Shape& shape, std::span<const std::uint32_t> hulls);

}  // namespace rubble
