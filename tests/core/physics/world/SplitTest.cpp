#include "core/physics/world/Split.h"

#include "core/base/Random.h"
#include "core/physics/state/VerifyState.h"
#include "core/physics/world/World.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <cmath>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr double kSplitStep = 1.0 / 60.0;
constexpr double kSide = 0.25;  // m, of a brick

/// A wall of cubes, row by row from below, its frame at the middle of its foot.
struct Wall {
    int columns = 0, rows = 0;
    std::shared_ptr<const Shape> brick;
    std::vector<Vec3> centres;

    std::uint32_t count() const { return static_cast<std::uint32_t>(centres.size()); }
    /// The body of some of its bricks, which keep the hulls of the body with the numbers `from`; kNone: the whole wall.
    SplitPart part(const std::vector<std::uint32_t>& bricks, const std::vector<std::uint32_t>& from = {}) const {
        std::vector<CompoundPart> parts;
        std::vector<MassProperties> masses;
        for (const std::uint32_t k : bricks) {
            parts.push_back({brick.get(), centres[k]});
            masses.push_back(brick->mass);
            masses.back().centre = centres[k];
        }
        return {.shape = *compoundShape(parts, combined(masses), brick), .hulls = from.empty() ? bricks : from};
    }
};

Wall wallOf(int columns, int rows) {
    Wall wall{columns, rows, *makeShape(std::vector{boxOf(Vec3(kSide))}), {}};
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            wall.centres.push_back({kSide * (x - 0.5 * (columns - 1)), kSide * (y + 0.5), 0.0});
        }
    }
    return wall;
}

std::vector<std::uint32_t> numbersUpTo(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    for (std::uint32_t k = 0; k < count; ++k) numbers[k] = k;
    return numbers;
}

BodyId addGround(World& world) {
    const std::shared_ptr<const Shape> shape = *makeShape(std::vector{boxOf({40.0, 1.0, 40.0})});
    return *world.addBody({.shape = shape, .kind = BodyKind::Static, .pose = {.position = {0.0, -0.5, 0.0}}});
}

BodyId addWall(World& world, const Wall& wall, BodyKind kind, const Pose& pose = {}) {
    return *world.addBody({.shape = wall.part(numbersUpTo(wall.count())).shape, .kind = kind, .pose = pose});
}

/// The motion of a part whose centre of mass was at `centre`, m, in the shape's frame, of a rigid body.
SplitPart moving(SplitPart part, const BodyState& whole) {
    const Vec3 centre = whole.pose.position + whole.pose.orientation * part.shape->mass.centre;
    part.velocity = whole.velocity + glm::cross(whole.angularVelocity, centre - whole.centre);
    part.angularVelocity = whole.angularVelocity;
    return part;
}

QString faultOf(const World& world) {
    const auto fault = verifyState(world.snapshot()->state);
    return fault ? QString::fromStdString(*fault) : QString();
}

double height(const World& world, BodyId body) { return world.state(body).centre.y; }

double mechanicalEnergy(const World& world) {
    const Momenta momenta = world.momenta();
    return momenta.kinetic + momenta.potential;
}

/// A wall that falls and splits into random sets of bricks.
struct FallingWall {
    World world;
    BodyId body;
    std::vector<SplitPart> sets;  // at rest
};

FallingWall fallingWall(Random& random) {
    FallingWall falling;
    addGround(falling.world);
    const Wall wall = wallOf(2 + static_cast<int>(random.below(6)), 1 + static_cast<int>(random.below(5)));
    const Quat orientation = glm::angleAxis(random.between(-1.5, 1.5), glm::normalize(Vec3(1.0, 0.3, 0.5)));
    falling.body = addWall(falling.world, wall, BodyKind::Dynamic, {{0.0, random.between(2.0, 8.0), 0.0}, orientation});
    const std::uint64_t most = 2 + random.below(wall.count());
    std::vector<std::vector<std::uint32_t>> sets(most);
    for (std::uint32_t k = 0; k < wall.count(); ++k) sets[random.below(most)].push_back(k);
    for (const std::vector<std::uint32_t>& set : sets) {
        if (!set.empty()) falling.sets.push_back(wall.part(set));
    }
    return falling;
}

/// Simulates until the wall is `gap` metres or less above the ground; negative: until it has collided.
void fall(FallingWall& falling, double gap) {
    World& world = falling.world;
    for (int step = 0; step < 300; ++step) {
        const double lowest = world.box(falling.body).min.y + glm::length(world.state(falling.body).velocity) / 60.0;
        if (gap >= 0.0 ? lowest < gap : !world.events().hits.empty()) return;
        world.step(kSplitStep);
    }
}

/// Splits the wall as its fall goes on. With `inStep`, after the step was collided.
std::vector<BodyId> splitInFall(FallingWall& falling, bool inStep) {
    World& world = falling.world;
    std::vector<SplitPart> parts;
    if (inStep) world.collide(kSplitStep);
    const BodyState whole = world.state(falling.body);
    for (const SplitPart& set : falling.sets) parts.push_back(moving(set, whole));
    std::vector<BodyId> bodies = *world.split(falling.body, parts);
    world.collide(kSplitStep);
    world.solve(kSplitStep);
    return bodies;
}

}  // namespace

class SplitTest : public QObject {
    Q_OBJECT
private slots:
    void compoundMovesAsTheSameHullsInOneShape() {
        const Wall wall = wallOf(4, 3);
        std::vector<Polytope> boxes;
        for (const Vec3& centre : wall.centres) boxes.push_back(translated(boxOf(Vec3(kSide)), centre));
        std::vector<BodyState> flying, ends;
        for (const auto& shape : {*makeShape(boxes), wall.part(numbersUpTo(wall.count())).shape}) {
            World world;
            addGround(world);
            const Quat tilt = glm::angleAxis(0.4, glm::normalize(Vec3(1.0, 0.3, 0.2)));
            const BodyId body =
                *world.addBody({.shape = shape, .pose = {{0.0, 1.0, 0.0}, tilt}, .angularVelocity = {0.0, 2.0, 1.0}});
            for (int k = 0; k < 20; ++k) world.step(kSplitStep);
            flying.push_back(world.state(body));
            for (int k = 0; k < 280; ++k) world.step(kSplitStep);
            ends.push_back(world.state(body));
        }
        QVERIFY(glm::distance(flying[0].centre, flying[1].centre) < 1e-6);
        QVERIFY(std::abs(glm::dot(flying[0].pose.orientation, flying[1].pose.orientation)) > 1.0 - 1e-6);
        QVERIFY(ends[0].asleep && ends[1].asleep);
        // They lie, or stand, on the same face.
        for (const BodyState& end : ends) {
            const auto isHalfOf = [&](double side) { return std::abs(end.centre.y - 0.5 * side) < 1e-4; };
            QVERIFY(isHalfOf(kSide) || isHalfOf(3 * kSide) || isHalfOf(4 * kSide));
        }
    }
    void remainderOfAHeldWallActsAsItsCompound() {
        const Wall wall = wallOf(6, 4);
        const std::vector<std::uint32_t> all = numbersUpTo(wall.count());
        std::vector<std::uint32_t> kept = all;
        std::erase_if(kept, [](std::uint32_t k) { return k == 8 || k == 9; });
        std::vector<ContentHash> hashes;
        for (const bool isCompound : {true, false}) {
            World world;
            addGround(world);
            const BodyId body = addWall(world, wall, BodyKind::Static);
            static_cast<void>(*world.addBody({.shape = boxShape(Vec3(0.3)), .pose = {{0.1, 1.3, 0.0}}}));
            world.step(kSplitStep);
            const Shape& whole = world.shape(body);
            std::vector<CompoundPart> places;
            for (const std::uint32_t k : kept) places.push_back({wall.brick.get(), wall.centres[k]});
            SplitPart held = wall.part(kept);
            held.kind = BodyKind::Static;
            held.shape = isCompound ? *compoundShape(places, whole.mass, wall.brick) : remainingShape(whole, kept);
            QVERIFY(world.split(body, std::vector{held, wall.part({8, 9})}).hasValue());
            for (int k = 0; k < 60; ++k) world.step(kSplitStep);
            QCOMPARE(faultOf(world), QString());
            hashes.push_back(world.hash());
        }
        QVERIFY(hashes[0] == hashes[1]);
    }
    void heldWallWithAHoleStaysWhereItIs() {
        World world;
        addGround(world);
        const Wall wall = wallOf(40, 25);
        const BodyId body = addWall(world, wall, BodyKind::Static);
        world.step(kSplitStep);
        std::vector<std::uint32_t> kept;
        std::vector<SplitPart> parts(1);
        for (std::uint32_t k = 0; k < wall.count(); ++k) {
            const int x = static_cast<int>(k) % wall.columns, y = static_cast<int>(k) / wall.columns;
            const bool isHole = x >= 15 && x < 25 && y >= 10 && y < 15;
            if (!isHole) kept.push_back(k);
            if (isHole) parts.push_back(wall.part({k}));
        }
        QCOMPARE(parts.size(), std::size_t{51});
        parts[0] = wall.part(kept);
        MassProperties all = world.shape(body).mass;
        std::vector<CompoundPart> places;
        for (const std::uint32_t k : kept) places.push_back({wall.brick.get(), wall.centres[k]});
        parts[0].shape = *compoundShape(places, all, wall.brick);
        parts[0].kind = BodyKind::Static;
        const Pose before = world.state(body).pose;
        const auto bodies = world.split(body, parts);
        QVERIFY(bodies.hasValue());
        QCOMPARE(bodies->size(), std::size_t{51});
        QVERIFY((*bodies)[0] == body);
        QCOMPARE(faultOf(world), QString());
        for (int k = 0; k < 200; ++k) {
            world.step(kSplitStep);
            QCOMPARE(faultOf(world), QString());
        }
        QVERIFY(world.state(body).pose.position == before.position);
        QVERIFY(world.kind(body) == BodyKind::Static);
        QVERIFY(world.bodyCount() == 52);
        // The bricks stand on each other in the hole: contacts give way by half a millimetre a course.
        for (std::size_t k = 1; k < bodies->size(); ++k) {
            QVERIFY(std::abs(height(world, (*bodies)[k]) - wall.centres[parts[k].hulls[0]].y) < 3e-3);
            QVERIFY(world.state((*bodies)[k]).asleep);
        }
    }
    void momentaAreKept() {
        Random random(11);
        for (int round = 0; round < 200; ++round) {
            World world({.gravity = Vec3(0.0)});
            const Wall wall = wallOf(6, 4);
            const Vec3 velocity{random.between(-5.0, 5.0), random.between(-5.0, 5.0), random.between(-5.0, 5.0)};
            const Vec3 spin{random.between(-6.0, 6.0), random.between(-6.0, 6.0), random.between(-6.0, 6.0)};
            const BodyId body = *world.addBody(
                {.shape = wall.part(numbersUpTo(wall.count())).shape, .velocity = velocity, .angularVelocity = spin});
            for (int k = 0; k < 7; ++k) world.step(kSplitStep);
            std::array<std::vector<std::uint32_t>, 4> sets;
            for (std::uint32_t k = 0; k < wall.count(); ++k) sets[random.below(4)].push_back(k);
            std::vector<SplitPart> parts;
            const BodyState whole = world.state(body);
            for (const std::vector<std::uint32_t>& set : sets) {
                if (!set.empty()) parts.push_back(moving(wall.part(set), whole));
            }
            const Momenta before = world.momenta();
            const double mass = world.mass(body);
            const auto bodies = world.split(body, parts);
            QVERIFY(bodies.hasValue());
            const Momenta after = world.momenta();
            double sum = 0.0;
            for (const BodyId one : *bodies) sum += world.mass(one);
            QVERIFY(std::abs(sum - mass) < 1e-6 * mass);
            const double reach = glm::length(before.linear) * 3.0 + glm::length(before.angular);
            QVERIFY2(glm::distance(before.linear, after.linear) < 1e-5 * glm::length(before.linear),
                     qPrintable(QString("seed 11, round %1").arg(round)));
            QVERIFY(glm::distance(before.angular, after.angular) < 1e-5 * reach);
            QVERIFY(std::abs(before.kinetic - after.kinetic) < 1e-5 * before.kinetic);
            QCOMPARE(faultOf(world), QString());
        }
    }
    void standingWallThatLosesACornerDoesNotTwitch() {
        World world({.sleeping = false});
        addGround(world);
        const Wall wall = wallOf(12, 8);
        const BodyId body = addWall(world, wall, BodyKind::Dynamic);
        for (int k = 0; k < 120; ++k) world.step(kSplitStep);
        const std::uint32_t corner = wall.count() - 1;
        const BodyState whole = world.state(body);
        std::vector<SplitPart> parts{moving(wall.part(numbersUpTo(corner)), whole), moving(wall.part({corner}), whole)};
        world.collide(kSplitStep);
        double before = 0.0, after = 0.0;
        for (const ContactPoint& point : world.contactPoints()) before += point.impulse;
        const auto bodies = world.split(body, parts);
        QVERIFY(bodies.hasValue());
        for (const ContactPoint& point : world.contactPoints()) after += point.impulse;
        const double remainder = static_cast<double>(corner) / wall.count();  // of the mass
        QVERIFY(std::abs(after - remainder * before) < 1e-6 * before);
        world.collide(kSplitStep);
        world.solve(kSplitStep);
        QCOMPARE(faultOf(world), QString());
        const Vec3 centre = world.state(body).centre;
        for (int k = 0; k < 60; ++k) {
            world.step(kSplitStep);
            QVERIFY(glm::length(world.state(body).velocity) < 2e-3);
        }
        QVERIFY(glm::distance(centre, world.state(body).centre) < 1e-4);
        QVERIFY(std::abs(height(world, (*bodies)[1]) - wall.centres[corner].y) < 2e-3);
    }
    void wallThatLosesItsFootFalls() {
        World world;
        addGround(world);
        const Wall wall = wallOf(4, 4);
        const BodyId body = addWall(world, wall, BodyKind::Static);
        // A ball rests on it.
        const BodyId ball = *world.addBody({.shape = wall.brick, .pose = {.position = {0.0, 4.5 * kSide, 0.0}}});
        for (int k = 0; k < 120; ++k) world.step(kSplitStep);
        QVERIFY(world.state(ball).asleep);
        std::vector<std::uint32_t> upper;
        for (std::uint32_t k = 8; k < 16; ++k) upper.push_back(k);
        QVERIFY(world.split(body, std::vector{wall.part(upper)}).hasValue());  // the foot is gone
        QCOMPARE(faultOf(world), QString());
        QVERIFY(world.kind(body) == BodyKind::Dynamic);
        for (int k = 0; k < 300; ++k) {
            world.step(kSplitStep);
            if (k < 30) QCOMPARE(faultOf(world), QString());
        }
        QVERIFY(std::abs(height(world, body) - kSide) < 2e-3);
        QVERIFY(std::abs(height(world, ball) - 2.5 * kSide) < 4e-3);
    }
    void wholeHullGivesWayToThoseOfItsBricks() {
        World world;
        addGround(world);
        const Wall wall = wallOf(4, 4);
        const MassProperties mass = wall.part(numbersUpTo(16)).shape->mass;
        const std::shared_ptr<const Shape> box =
            *makeShape(std::vector{translated(boxOf({4 * kSide, 4 * kSide, kSide}), {0.0, 2 * kSide, 0.0})}, mass);
        const BodyId body = *world.addBody({.shape = box});
        for (int k = 0; k < 30; ++k) world.step(kSplitStep);
        const BodyState whole = world.state(body);
        const std::vector<std::uint32_t> none(15, kNone);
        std::vector<SplitPart> parts{moving(wall.part(numbersUpTo(15), none), whole),
                                     moving(wall.part({15}, {kNone}), whole)};
        QVERIFY(world.split(body, parts).hasValue());
        QCOMPARE(faultOf(world), QString());
        for (int k = 0; k < 120; ++k) {
            world.step(kSplitStep);
            QCOMPARE(faultOf(world), QString());
        }
        QVERIFY(glm::distance(world.state(body).pose.position, Vec3(0.0)) < 2e-3);
    }
    void randomSplitsHaveTheSameBitsOnAllThreadsAndLanes() {
        std::vector<ContentHash> hashes;
        for (const int threads : {1, 2, 5}) {
            for (const SimdWidth lanes : {SimdWidth::Scalar, widestSimd()}) {
                World world({.threads = threads, .lanes = lanes});
                addGround(world);
                const Wall wall = wallOf(10, 8);
                std::vector<std::pair<BodyId, std::vector<std::uint32_t>>> bodies{
                    {addWall(world, wall, BodyKind::Dynamic, {.position = {0.0, 0.5, 0.0}}), numbersUpTo(80)}};
                Random random(5);
                for (int step = 0; step < 240; ++step) {
                    world.collide(kSplitStep);
                    if (step % 10 == 5) {
                        const std::size_t k = random.below(static_cast<std::uint32_t>(bodies.size()));
                        const auto [body, bricks] = bodies[k];
                        std::vector<std::uint32_t> sets[2], from[2];
                        for (std::uint32_t i = 0; i < bricks.size(); ++i) {
                            const std::uint32_t set = random.below(3) == 0 ? 1 : 0;
                            sets[set].push_back(bricks[i]);
                            from[set].push_back(i);
                        }
                        const BodyState whole = world.state(body);
                        std::vector<SplitPart> parts;
                        std::vector<std::vector<std::uint32_t>> of;
                        for (const int set : {0, 1}) {
                            if (sets[set].empty()) continue;
                            parts.push_back(moving(wall.part(sets[set], from[set]), whole));
                            of.push_back(sets[set]);
                        }
                        const auto made = world.split(body, parts);
                        QVERIFY(made.hasValue());
                        QCOMPARE(faultOf(world), QString());
                        bodies[k].second = of[0];
                        for (std::size_t i = 1; i < of.size(); ++i) bodies.emplace_back((*made)[i], of[i]);
                        world.collide(kSplitStep);
                    }
                    world.solve(kSplitStep);
                }
                QCOMPARE(faultOf(world), QString());
                hashes.push_back(world.hash());
            }
        }
        for (const ContentHash& hash : hashes) QVERIFY(hash == hashes[0]);
    }
    void partsOfABodyThatFellLand() {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            Random random(seed);
            FallingWall falling = fallingWall(random);
            fall(falling, random.between(0.0, 0.6));
            const std::vector<BodyId> bodies = splitInFall(falling, random.below(2) == 0);
            for (int step = 0; step < 120; ++step) falling.world.step(kSplitStep);
            for (const BodyId body : bodies)
                QVERIFY2(height(falling.world, body) > 0.4 * kSide, qPrintable(QString("seed %1").arg(seed)));
        }
    }
    void partsOfALandingBodyGainNoEnergy() {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            Random random(seed);
            FallingWall falling = fallingWall(random);
            const double dropped = mechanicalEnergy(falling.world);
            fall(falling, -1.0);
            double before = mechanicalEnergy(falling.world);
            splitInFall(falling, random.below(2) == 0);
            for (int step = 0; step < 30; ++step) {
                const double now = mechanicalEnergy(falling.world);
                QVERIFY2(now < before + 0.01 * dropped,
                         qPrintable(QString("seed %1, step %2: %3 to %4 J").arg(seed).arg(step).arg(before).arg(now)));
                before = now;
                falling.world.step(kSplitStep);
            }
        }
    }
    void partsThatCannotBeBodiesAreRefused() {
        World world;
        const Wall wall = wallOf(2, 1);
        const BodyId body = addWall(world, wall, BodyKind::Dynamic);
        std::vector<SplitPart> parts{wall.part({0}), wall.part({1})};
        parts[1].velocity.x = 1e6;
        const ContentHash before = world.hash();
        const auto split = world.split(body, parts);
        QVERIFY(!split);
        QCOMPARE(split.error().message, "Part 1: The velocity of a body must be below 10 km/s.");
        QVERIFY(world.hash() == before);
    }
    void grabbedPointStaysWithItsPart() {
        World world({.gravity = Vec3(0.0)});
        const Wall wall = wallOf(4, 1);
        const BodyId body = addWall(world, wall, BodyKind::Dynamic);
        QVERIFY(world.grab(body, wall.centres[3], 100.0).hasValue());
        const auto bodies = world.split(body, std::vector{wall.part({0, 1, 2}), wall.part({3})});
        QVERIFY(bodies.hasValue());
        QVERIFY(world.grabSpring()->body == (*bodies)[1]);
        QVERIFY(glm::distance(world.grabSpring()->point, wall.centres[3]) < 1e-6);
    }
};

RUBBLE_TEST(SplitTest)
#include "SplitTest.moc"
