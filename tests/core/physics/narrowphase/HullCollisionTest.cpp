#include "core/physics/narrowphase/HullCollision.h"

#include "core/geometry/hull/HalfSpaceIntersection.h"
#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/hull/MassProperties.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

HullCollision collideCubes(Vec3f offset, const SeparatingAxis& guess = {}, const Mat3f& rotation = {}) {
    const Hull cube = hullOf(boxOf(Vec3(1.0)));
    return collideHulls(cube, cube, {rotation, offset}, kSpeculativeDistance, guess);
}

/// A random solid, stretched to a splinter or a flake.
Polytope stretchedSolid(Random& random) {
    const Vec3 scale(random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0));
    std::vector<Vec3> corners = randomSolid(random).vertices;
    if (random.below(8) == 0) {  // round, of faces that are merged and not quite flat
        corners.clear();
        while (corners.size() < 60) corners.push_back(0.3 * (randomRotation(random) * Vec3(0.0, 0.0, 1.0)));
    }
    for (Vec3& corner : corners) corner *= scale;
    return *convexHull(corners);
}

/// A random pose of the second solid in which it overlaps the first by a depth, m.
Pose overlappingPose(Random& random, const Polytope& first, const Polytope& second, double depth) {
    Pose pose{{}, randomRotation(random)};
    const Vec3 direction = glm::normalize(randomIn(random, 1.0));
    double inside = 0.0, outside = 1.5;  // m
    for (int k = 0; k < 24; ++k) {
        const double middle = 0.5 * (inside + outside);
        pose.position = middle * direction;
        (hullOverlap(first, {}, second, pose).depth > depth ? inside : outside) = middle;
    }
    return pose;
}

}  // namespace

class HullCollisionTest : public QObject {
    Q_OBJECT
private slots:
    void cubesTouchWithTheirFaces() {
        const HullCollision collision = collideCubes(Vec3f(0.2f, 0.99f, 0.0f));
        QVERIFY(collision.axis.kind == AxisKind::FirstFace);
        QVERIFY(collision.axis.normal == Vec3f(0.0f, 1.0f, 0.0f));
        QVERIFY(std::abs(collision.axis.separation + 0.01f) < 1e-6f);
        QCOMPARE(collision.manifold.count, 4);
        QVERIFY(collision.offset == Vec3f(0.2f, 0.99f, 0.0f));
        QVERIFY(!collision.isSwept);
    }
    void speculativeContactsBeginBeforeTheyTouch() {
        QCOMPARE(collideCubes(Vec3f(0.2f, 1.019f, 0.0f)).manifold.count, 4);
        const HullCollision apart = collideCubes(Vec3f(0.2f, 1.021f, 0.0f));
        QCOMPARE(apart.manifold.count, 0);
        QVERIFY(apart.axis.separation > kSpeculativeDistance);
    }
    /// The axis of the last collision is kept where another separates the hulls as much: no flicker between two faces.
    void axisOfTheLastCollisionIsKept() {
        const HullCollision along = collideCubes(Vec3f(0.0f, 0.999f, 0.0f));
        QVERIFY(along.axis.normal == Vec3f(0.0f, 1.0f, 0.0f));
        // By the edges of the cubes, both x and y separate: y by 0.3 mm less.
        QVERIFY(collideCubes(Vec3f(0.9998f, 0.9995f, 0.0f), along.axis).axis.normal == Vec3f(0.0f, 1.0f, 0.0f));
    }
    void wrongGuessIsReplaced() {
        SeparatingAxis guess = collideCubes(Vec3f(0.0f, 0.999f, 0.0f)).axis;
        const HullCollision collision = collideCubes(Vec3f(0.99f, 0.1f, 0.0f), guess);
        QVERIFY(collision.axis.normal == Vec3f(1.0f, 0.0f, 0.0f));
        QVERIFY(std::abs(collision.axis.separation + 0.01f) < 1e-6f);
    }
    void crossedEdgesTouchAtAPoint() {
        const float s = std::sqrt(0.5f);
        const Hull first = hullOf(*convexHull(std::vector<Vec3>{
            {-1, s, 0}, {-1, -s, 0}, {-1, 0, s}, {-1, 0, -s}, {1, s, 0}, {1, -s, 0}, {1, 0, s}, {1, 0, -s}}));
        const Hull second = hullOf(*convexHull(std::vector<Vec3>{
            {s, 0, -1}, {-s, 0, -1}, {0, s, -1}, {0, -s, -1}, {s, 0, 1}, {-s, 0, 1}, {0, s, 1}, {0, -s, 1}}));
        const auto collide = [&](float gap) {
            return collideHulls(first, second, {{}, Vec3f(0.1f, 2.0f * s + gap, 0.1f)}, kSpeculativeDistance, {});
        };
        QVERIFY(collide(-0.01f).axis.kind == AxisKind::Edges);
        QCOMPARE(collide(-0.01f).manifold.count, 1);
        QCOMPARE(collide(0.015f).manifold.count, 1);
        QCOMPARE(collide(0.03f).manifold.count, 0);
    }
    /// Hulls that overlap have a point as deep as they do, whatever their shapes: the face that is most opposed to
    /// another need not be at the corner that is deepest in it.
    void overlappingHullsHaveADeepPoint() {
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            Random random(seed);
            const Polytope first = stretchedSolid(random), second = stretchedSolid(random);
            const Pose pose = overlappingPose(random, first, second, 0.01);
            const HullCollision collision = collideHulls(
                hullOf(first), hullOf(second), {toFloat(pose.orientation).matrix(), toFloat(pose.position)}, 0.0f, {});
            QVERIFY2(collision.axis.separation < -0.006f, qPrintable(QString("seed %1").arg(seed)));
            float deepest = 1.0f;
            for (int i = 0; i < collision.manifold.count; ++i)
                deepest = std::min(deepest, collision.manifold.points[static_cast<std::size_t>(i)].separation);
            QVERIFY2(deepest < collision.axis.separation + 0.001f, qPrintable(QString("seed %1").arg(seed)));
        }
    }
    /// The parts of a solid on both sides of a plane have no point below their common face.
    void partsOfASolidOnlyTouch() {
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            Random random(seed);
            const Polytope whole = stretchedSolid(random);
            const Vec3 normal = glm::normalize(randomIn(random, 1.0));
            const Vec3 centre = massOf(whole).centre, apart = 1e-3 * normal;
            std::vector<Plane> below = whole.planes, above = whole.planes;
            below.push_back({normal, glm::dot(normal, centre)});
            above.push_back({-normal, -glm::dot(normal, centre)});
            const Hull first = hullOf(*halfSpaceIntersection(below, centre - apart));
            const Hull second = hullOf(*halfSpaceIntersection(above, centre + apart));
            const HullCollision collision = collideHulls(first, second, {}, kSpeculativeDistance, {});
            QVERIFY(collision.manifold.count > 0);
            for (int i = 0; i < collision.manifold.count; ++i) {
                const float separation = collision.manifold.points[static_cast<std::size_t>(i)].separation;
                QVERIFY2(separation > -2e-6f, qPrintable(QString("seed %1: %2 m").arg(seed).arg(separation)));
            }
        }
    }
    /// Guessing any face leads to the same collision.
    void resultDoesNotDependOnTheGuess() {
        Random random(31);
        for (int round = 0; round < 500; ++round) {
            const Hull first = hullOf(randomSolid(random)), second = hullOf(randomSolid(random));
            const RelativePose pose{toFloat(randomRotation(random)).matrix(), toFloat(randomIn(random, 0.4))};
            const HullCollision expected = collideHulls(first, second, pose, kSpeculativeDistance, {});
            const auto face = static_cast<std::uint16_t>(random.below(first.planes.size()));
            const HullCollision guessed =
                collideHulls(first, second, pose, kSpeculativeDistance, {.kind = AxisKind::FirstFace, .first = face});
            if (expected.axis.separation > kSpeculativeDistance) {
                QCOMPARE(guessed.manifold.count, 0);
                continue;
            }
            // Faces are preferred by half a millimetre, twice.
            QVERIFY(std::abs(expected.axis.separation - guessed.axis.separation) < 0.0011f);
        }
    }
};

RUBBLE_TEST(HullCollisionTest)
#include "HullCollisionTest.moc"
