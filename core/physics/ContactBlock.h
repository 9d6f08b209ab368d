#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rubble {

/// Contacts are kept and solved in blocks of eight, each a lane: number i of every row belongs to contact i. Narrower machines
/// take a block in parts. A lane without a contact has body 0 on both sides, which never moves, and no points.
inline constexpr int kBlockLanes = 8;
using FloatRow = std::array<float, kBlockLanes>;
using IndexRow = std::array<std::uint32_t, kBlockLanes>;
struct Vec3Row {
    FloatRow x, y, z;
};
struct QuatRow {
    FloatRow x, y, z, w;
};
struct SymMat3Row {
    FloatRow xx, xy, xz, yy, yz, zz;
};

/// One point of a manifold, in eight contacts.
struct alignas(64) PointRows {
    // What each pass reads comes first: it is memory that limits the solver.
    Vec3Row place;           // m, from the first body's centre, in world axes at the time the manifold was made
    FloatRow separation;     // m, when the step began
    FloatRow impulse;        // N s, of the last sub-step; kept from step to step
    FloatRow effectiveMass;  // kg
    FloatRow lever;          // m, from the friction centre
    FloatRow stepImpulse;    // N s, of all sub-steps of this step
    FloatRow approach;       // m/s along the normal before the step, negative where they come nearer
    FloatRow unused;
};

/// Eight contacts as the solver sees them: what it reads and writes in every pass.
struct alignas(64) ContactBlock {
    IndexRow first, second;  // bodies
    IndexRow contact;        // whose lane this is
    IndexRow pointCount;
    Vec3Row normal;   // from first to second
    Vec3Row tangent;  // square to it; the other tangent is their cross product
    Vec3Row apart;  // m: first centre less second centre; takes a place seen from the first to one seen from the second
    SymMat3Row firstInverseInertia, secondInverseInertia;
    FloatRow friction, restitution;
    FloatRow againstFixed;  // 1 where one of the bodies is not dynamic, else 0
    // How much the normal speed at point i changes by an impulse at point j, 1/kg.
    std::array<FloatRow, 6> coupling;  // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
    std::array<PointRows, 4> points;
    Vec3Row frictionCentre;                                // m, from the first body's centre
    FloatRow tangentMassXX, tangentMassXY, tangentMassYY;  // kg: inverse of the coupling of both tangents
    FloatRow twistMass;                                    // kg m^2
    FloatRow frictionX, frictionY;                         // N s along both tangents; kept from step to step
    FloatRow twist;                                        // N m s about the normal; kept
};

/// How both bodies stood when the manifold was made: what recycling compares with.
struct alignas(32) ReferenceBlock {
    QuatRow firstTurn, secondTurn;
    Vec3Row apart;                       // m, as in ContactBlock
    std::array<FloatRow, 4> separation;  // m, of each point
    FloatRow slack;                      // m: how far they may move against each other before the manifold is made anew
    FloatRow isSwept;                    // 1 where the manifold is of where they will meet, else 0
};

/// A lane of a block, as it is kept while its bodies sleep, or moved from one block to another.
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
