#include "bench/Bricks.h"

#include "bench/Timing.h"
#include "tests/support/geometry/Hulls.h"

#include <glm/gtc/quaternion.hpp>

#include <numeric>

namespace rubble::bench {
namespace {

constexpr int kSettling = 60;  // steps

std::vector<Vec3> wallCentres() {
    std::vector<Vec3> centres;
    for (std::uint32_t row = 0; row < BrickWall::kRows; ++row) {
        for (std::uint32_t column = 0; column < BrickWall::kColumns; ++column) {
            const double x = column - 0.5 * (BrickWall::kColumns - 1);
            centres.push_back(BrickWall::kSide * Vec3(x, row + 0.5, 0.0));
        }
    }
    return centres;
}

std::vector<std::uint32_t> numbersTo(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

}  // namespace

Bricks::Bricks(std::vector<Vec3> centres, double side) : m_centres(std::move(centres)) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (const Vec3& centre : m_centres) {
        shapes.push_back(test::boxShape(Vec3(side)));
        m_parts.push_back({shapes.back().get(), centre});
        m_masses.push_back(shapes.back()->mass);
        m_masses.back().centre = centre;
    }
    m_shapes = std::make_shared<const std::vector<std::shared_ptr<const Shape>>>(std::move(shapes));
}

MassProperties Bricks::mass(std::span<const std::uint32_t> bricks) const { return combined(m_masses, bricks); }

std::shared_ptr<const Shape> Bricks::compound(std::span<const std::uint32_t> bricks, const MassProperties& mass) const {
    std::vector<CompoundPart> places(bricks.size());
    for (std::size_t k = 0; k < bricks.size(); ++k) places[k] = m_parts[bricks[k]];
    return *compoundShape(places, mass, m_shapes);
}

SplitPart Bricks::part(std::span<const std::uint32_t> bricks, std::span<const std::uint32_t> hullOf) const {
    SplitPart part;
    part.hulls.resize(bricks.size());
    for (std::size_t k = 0; k < bricks.size(); ++k) part.hulls[k] = hullOf[bricks[k]];
    if (bricks.size() > 1) {
        part.shape = compound(bricks, mass(bricks));
    } else {
        part.shape = (*m_shapes)[bricks[0]];
        part.offset = m_centres[bricks[0]];
    }
    return part;
}

BrickWall::BrickWall() : bricks(wallCentres(), kSide) {
    for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) {
        const std::uint32_t column = brick % kColumns, row = brick / kColumns;
        const bool isLost = column >= 15 && column < 25 && row >= 10 && row < 15;
        (isLost ? lost : kept).push_back(brick);
    }
    const Vec3 sides = kSide * Vec3(kColumns, kRows, 1.0);
    Polytope box = test::boxOf(sides);
    for (Vec3& vertex : box.vertices) vertex.y += 0.5 * sides.y;
    whole = *makeShape(std::vector{box});
}

void addGround(World& world) {
    const auto shape = test::boxShape({40.0, 1.0, 40.0});
    static_cast<void>(world.addBody({.shape = shape, .kind = BodyKind::Static, .pose = {{0.0, -0.5, 0.0}}}));
}

void addLeaningBoxes(World& world) {
    const auto shape = test::boxShape(kLeaningSides);
    for (int k = 0; k < kLeaning; ++k) {
        const double side = k % 2 == 0 ? 1.0 : -1.0;
        const double lean = 0.25;  // radians from upright
        const double away =
            0.5 * (BrickWall::kSide + kLeaningSides.y * std::sin(lean) + kLeaningSides.z * std::cos(lean));
        const double up = 0.5 * (kLeaningSides.y * std::cos(lean) + kLeaningSides.z * std::sin(lean));
        const Pose pose{{0.45 * (k / 2 - 4.5), up, side * away}, glm::angleAxis(-side * lean, Vec3(1.0, 0.0, 0.0))};
        static_cast<void>(world.addBody({.shape = shape, .pose = pose}));
    }
}

WallSplit::WallSplit(const BrickWall& wall, WallHulls hulls, BodyKind kind)
    : m_wall(wall), m_kind(kind), m_world({.sleeping = false}) {
    addGround(m_world);
    const std::vector<std::uint32_t> all = numbersTo(wall.bricks.count());
    const bool isOne = hulls == WallHulls::One;
    m_hullOf = isOne ? std::vector<std::uint32_t>(all.size(), kNone) : all;
    const auto shape = isOne ? wall.whole : wall.bricks.compound(all, wall.whole->mass);
    m_body = *m_world.addBody({.shape = shape, .kind = kind});
    for (int step = 0; step < kSettling; ++step) m_world.step(kWallStep);
    m_standing = m_world.snapshot();
}

std::vector<SplitPart> WallSplit::parts() const {
    std::vector<SplitPart> parts;
    parts.reserve(1 + m_wall.lost.size());
    if (m_kind == BodyKind::Static) {
        // What is held keeps the mass properties that it had: nothing reads them, and it must not move.
        SplitPart held{.kind = BodyKind::Static};
        held.hulls.resize(m_wall.kept.size());
        for (std::size_t k = 0; k < held.hulls.size(); ++k) held.hulls[k] = m_hullOf[m_wall.kept[k]];
        const Shape& before = m_world.shape(m_body);
        const bool isOne = before.hulls.size() == 1;
        held.shape = isOne ? m_wall.bricks.compound(m_wall.kept, before.mass) : remainingShape(before, held.hulls);
        parts.push_back(std::move(held));
    } else {
        parts.push_back(m_wall.bricks.part(m_wall.kept, m_hullOf));
    }
    for (const std::uint32_t& brick : m_wall.lost) parts.push_back(m_wall.bricks.part({&brick, 1}, m_hullOf));
    return parts;
}

SplitTimes WallSplit::round() {
    m_world.restore(*m_standing);
    std::vector<SplitPart> made;
    SplitTimes times;
    times.split = millisecondsOf([&] {
        made = parts();
        static_cast<void>(*m_world.split(m_body, made));
    });
    times.step = millisecondsOf([&] { m_world.step(kWallStep); });
    return times;
}

}  // namespace rubble::bench
