#pragma once

#include "core/physics/math/Vec3f.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rubble {

/// Contacts are stored and solved in blocks of eight, each in a lane: element i of every row belongs to contact i.
/// Narrower SIMD widths process a block in parts. A lane without a contact has body 0 on both sides, which never moves,
/// and no points.
inline constexpr int kBlockLanes = 8;
using FloatRow = std::array<float, kBlockLanes>;
using IndexRow = std::array<std::uint32_t, kBlockLanes>;
struct Vec3Row {
    FloatRow x, y, z;
    /// The vector of a lane.
    Vec3f at(std::size_t lane) const { return Vec3f(x[lane], y[lane], z[lane]); }
};
struct QuatRow {
    FloatRow x, y, z, w;
};
struct SymMat3Row {
    FloatRow xx, xy, xz, yy, yz, zz;
};

/// One manifold point of eight contacts.
struct alignas(64) PointRows {
    // What every pass reads comes first: the solver is limited by memory bandwidth.
    Vec3Row position;        // m, from the first body's centre, in world axes when the manifold was computed
    FloatRow separation;     // m, at the beginning of the step
    FloatRow impulse;        // N·s, of the last sub-step; kept between steps
    FloatRow effectiveMass;  // kg
    FloatRow lever;          // m, from the friction centre
    FloatRow stepImpulse;    // N·s, sum over the sub-steps of this step
    FloatRow approach;       // m/s along the normal before the step, negative if approaching
    FloatRow sustained;      // N·s, before an impact in this sub-step; of the first point, -1 without one
};

/// Eight contacts, with the data that the solver reads and writes in every pass.
struct alignas(64) ContactBlock {
    IndexRow first, second;  // bodies
    IndexRow contact;        // the contact of each lane
    IndexRow pointCount;
    Vec3Row normal;   // from first to second
    Vec3Row tangent;  // perpendicular to it; the other tangent is normal x tangent
    // m: first centre minus second; converts a position relative to the first to one relative to the second.
    Vec3Row centreOffset;
    SymMat3Row firstInverseInertia, secondInverseInertia;
    FloatRow friction, restitution;
    FloatRow againstFixed;  // 1 if one of the bodies is not dynamic, else 0
    FloatRow stiffening;    // 1/m: inverse of the overlap beyond which the contact stiffens; rigid from twice as much
    // Softness where several manifolds of the same bodies share their load; 0: that of a manifold alone.
    FloatRow sharedMassScale, sharedImpulseScale;
    // The change of the normal speed at point i by a unit impulse at point j, 1/kg.
    std::array<FloatRow, 6> coupling;  // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
    std::array<PointRows, 4> points;
    Vec3Row frictionCentre;                                // m, from the first body's centre
    FloatRow tangentMassXX, tangentMassXY, tangentMassYY;  // kg: inverse of the 2 x 2 mass matrix of both tangents
    FloatRow torsionalMass;                                // kg·m²: effective inertia of both bodies about the normal
    FloatRow frictionX, frictionY;                         // N·s along both tangents; kept between steps
    FloatRow torsionalImpulse;                             // N·m·s about the normal; kept between steps
    // Sums of the three over the sub-steps of this step.
    FloatRow stepFrictionX, stepFrictionY, stepTorsionalImpulse;
};

/// The index of a pair of points, i < j, in ContactBlock::coupling.
constexpr int couplingIndex(int i, int j) { return i == 0 ? j - 1 : i + j; }

/// The poses of both bodies when the manifold was computed; manifold recycling compares them with the current ones.
struct alignas(32) ReferenceBlock {
    QuatRow firstRotation, secondRotation;
    Vec3Row centreOffset;                // m, as in ContactBlock
    std::array<FloatRow, 4> separation;  // m, of each point
    FloatRow slack;                      // m: relative movement after which the manifold is outdated
    FloatRow isSwept;                    // 1 if the manifold is that of the time of impact, else 0
};

/// The contents of one lane of a block, stored while its bodies sleep or moved to another block.
template <class Block>
using StoredLane = std::array<std::uint32_t, sizeof(Block) / sizeof(IndexRow)>;

template <class Block>
StoredLane<Block> storedLane(const Block& block, int lane) {
    StoredLane<Block> stored;
    const auto* words = reinterpret_cast<const unsigned char*>(&block);
    for (std::size_t row = 0; row < stored.size(); ++row) {
        std::memcpy(&stored[row], words + (row * kBlockLanes + static_cast<std::size_t>(lane)) * 4, 4);
    }
    return stored;
}

template <class Block>
void putLane(Block& block, int lane, const StoredLane<Block>& stored) {
    auto* words = reinterpret_cast<unsigned char*>(&block);
    for (std::size_t row = 0; row < stored.size(); ++row) {
        std::memcpy(words + (row * kBlockLanes + static_cast<std::size_t>(lane)) * 4, &stored[row], 4);
    }
}

}  // namespace rubble
