#pragma once

#include "core/physics/world/Split.h"
#include "core/physics/world/World.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rubble::bench {

/// Cubes, each with a shape of its own as fragments have, and the bodies that consist of them.
class Bricks {
public:
    /// `centres`: m, in the frame of the bodies. `side`: m.
    Bricks(std::vector<Vec3> centres, double side);

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_centres.size()); }
    std::span<const Vec3> centres() const { return m_centres; }
    /// The mass properties of some bricks together.
    MassProperties mass(std::span<const std::uint32_t> bricks) const;
    std::shared_ptr<const Shape> compound(std::span<const std::uint32_t> bricks, const MassProperties& mass) const;
    /// A dynamic part of several bricks, with the hulls that they were in the body that splits; kNone: new ones.
    SplitPart part(std::span<const std::uint32_t> bricks, std::span<const std::uint32_t> hullOf) const;

private:
    std::vector<Vec3> m_centres;
    std::vector<CompoundPart> m_parts;  // of all, and their masses in the frame of the bodies
    std::vector<MassProperties> m_masses;
    std::shared_ptr<const std::vector<std::shared_ptr<const Shape>>> m_shapes;
};

/// A wall of 40 x 25 bricks of 0.25 m, row by row from the foot, and the 10 x 5 in its middle that a hit takes out.
struct BrickWall {
    static constexpr std::uint32_t kColumns = 40, kRows = 25;
    static constexpr double kSide = 0.25;

    Bricks bricks;
    std::vector<std::uint32_t> kept, lost;  // ascending
    std::shared_ptr<const Shape> whole;     // of one hull

    BrickWall();
};

/// What is around a wall: the ground, and boxes that lean on both sides.
inline constexpr double kWallStep = 1.0 / 60.0;      // s
inline constexpr int kLeaning = 20;                  // boxes
inline constexpr Vec3 kLeaningSides{0.4, 1.0, 0.1};  // m
void addGround(World& world);
void addLeaningBoxes(World& world);

/// What is split: the wall of one hull, or of a thousand, held or free.
enum class WallHulls { One, Thousand };

/// Times of a round, ms.
struct SplitTimes {
    double split = 0.0;  // mass properties, shapes, World::split()
    double step = 0.0;   // the step after it
};

/// A wall on the ground that loses its 50 bricks, again and again.
class WallSplit {
public:
    WallSplit(const BrickWall& wall, WallHulls hulls, BodyKind kind);
    SplitTimes round();

private:
    std::vector<SplitPart> parts() const;

    const BrickWall& m_wall;
    BodyKind m_kind;
    World m_world;
    BodyId m_body;
    std::vector<std::uint32_t> m_hullOf;  // of each brick
    std::shared_ptr<const Snapshot> m_standing;
};

}  // namespace rubble::bench
