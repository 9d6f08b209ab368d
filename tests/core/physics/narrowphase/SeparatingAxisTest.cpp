// Tests core/physics/narrowphase/SeparatingAxis.cpp and core/physics/narrowphase/TimeOfImpact.cpp.
#include "core/geometry/hull/HullOverlap.h"
#include "core/physics/narrowphase/SeparatingAxis.h"
#include "core/physics/narrowphase/TimeOfImpact.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr float kAny = 1e30f;  // no early end

struct Pair {
    Polytope first, second;
    Pose pose;  // of the second in the first's frame
};

/// A solid that makeHull() does not simplify.
Polytope randomExactSolid(Random& random) {
    while (true) {
        Polytope solid = randomSolid(random);
        const Hull hull = hullOf(solid);
        if (hull.planes.size() == solid.faces.size() && hull.cornerCount == static_cast<int>(solid.vertices.size()))
            return solid;
    }
}

Pair randomPair(Random& random, double farthest) {
    Pair pair{randomExactSolid(random), randomExactSolid(random), {}};
    pair.pose.position = randomIn(random, farthest);
    pair.pose.orientation = randomRotation(random);
    return pair;
}

RelativePose poseOf(const Pose& pose) {
    const Quat& q = pose.orientation;
    const Quatf rotation{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                         static_cast<float>(q.w)};
    return {rotation.matrix(), toFloat(pose.position)};
}

SeparatingAxis axisOf(const Pair& pair) {
    return separatingAxis(hullOf(pair.first), hullOf(pair.second), poseOf(pair.pose), kAny, {});
}

}  // namespace

class SeparatingAxisTest : public QObject {
    Q_OBJECT
private slots:
    void boxOnBoxTouchesWithItsFace() {
        const Pair pair{boxOf({1, 1, 1}), boxOf({1, 1, 1}), {{0.2, 0.99, 0.1}, {1, 0, 0, 0}}};
        const SeparatingAxis axis = axisOf(pair);
        QVERIFY(axis.kind == AxisKind::FirstFace);
        QCOMPARE(axis.separation, -0.01f);
        QVERIFY(axis.normal == Vec3f(0, 1, 0));
    }
    void crossedEdgesTouchAlongTheirCrossProduct() {
        // Both cubes stand on an edge, along x and along y: half a diagonal each.
        const Pair pair{
            boxOf({1, 1, 1}), boxOf({1, 1, 1}), {{0, 0, 1.4}, glm::angleAxis(3.141592653589793 / 4, Vec3(0, 1, 0))}};
        Pair turned = pair;
        turned.first = *convexHull(std::vector<Vec3>{{-0.5, 0, 0.70710678},
                                                     {0.5, 0, 0.70710678},
                                                     {-0.5, 0.70710678, 0},
                                                     {0.5, 0.70710678, 0},
                                                     {-0.5, 0, -0.70710678},
                                                     {0.5, 0, -0.70710678},
                                                     {-0.5, -0.70710678, 0},
                                                     {0.5, -0.70710678, 0}});
        const SeparatingAxis axis = axisOf(turned);
        QVERIFY(axis.kind == AxisKind::Edges);
        QVERIFY(std::abs(axis.separation - (1.4f - 1.41421356f)) < 1e-6f);
        QVERIFY(length(axis.normal - Vec3f(0, 0, 1)) < 1e-6f);
    }
    void depthsMatchHullOverlap() {
        constexpr std::uint64_t kSeed = 41;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        int edges = 0;
        for (int i = 0; i < 2000; ++i) {
            const Pair pair = randomPair(random, 0.4);
            const double exact = -hullOverlap(pair.first, {}, pair.second, pair.pose).depth;
            const SeparatingAxis axis = axisOf(pair);
            if (exact > 0.0) {
                QVERIFY2(axis.separation > -1e-5f, qPrintable(QString("case %1").arg(i)));
                continue;
            }
            // Faces are preferred by half a millimetre, twice; floats add a few micrometres.
            QVERIFY2(axis.separation < exact + 1e-5 && axis.separation > exact - 1.1e-3,
                     qPrintable(QString("case %1: %2, exactly %3").arg(i).arg(axis.separation).arg(exact)));
            edges += axis.kind == AxisKind::Edges ? 1 : 0;
        }
        QVERIFY(edges > 80);  // or they were never tried
    }
    void guessDoesNotChangeTheResult() {
        Random random(42);
        for (int i = 0; i < 2000; ++i) {
            const Pair pair = randomPair(random, 0.5);
            const Hull first = hullOf(pair.first), second = hullOf(pair.second);
            const SeparatingAxis axis = separatingAxis(first, second, poseOf(pair.pose), kAny, {});
            const SeparatingAxis again = separatingAxis(first, second, poseOf(pair.pose), kAny, axis);
            QVERIFY(std::abs(axis.separation - again.separation) < 1e-6f);
        }
    }
    void timeOfImpactMatchesSmallSteps() {
        Random random(43);
        int met = 0;
        for (int i = 0; i < 1000; ++i) {
            Pair pair = randomPair(random, 2.0);
            if (hullOverlap(pair.first, {}, pair.second, pair.pose).depth > -0.01) continue;
            const Vec3 displacement = randomIn(random, 4.0);
            const TimeOfImpact touch =
                timeOfImpact(hullOf(pair.first), hullOf(pair.second), poseOf(pair.pose), toFloat(displacement));
            Pose at = pair.pose;
            if (touch.axis.kind == AxisKind::None) {
                for (int k = 0; k <= 50; ++k) {
                    at.position = pair.pose.position + displacement * (k / 50.0);
                    QVERIFY2(hullOverlap(pair.first, {}, pair.second, at).depth < 1e-4,
                             qPrintable(QString("case %1").arg(i)));
                }
                continue;
            }
            ++met;
            at.position = pair.pose.position + displacement * static_cast<double>(touch.fraction);
            QVERIFY2(std::abs(hullOverlap(pair.first, {}, pair.second, at).depth) < 1e-4,
                     qPrintable(QString("case %1").arg(i)));
            QVERIFY(dot(touch.axis.normal, toFloat(displacement)) < 0.0f);
        }
        QVERIFY(met > 30);
    }
};

RUBBLE_TEST(SeparatingAxisTest)
#include "SeparatingAxisTest.moc"
