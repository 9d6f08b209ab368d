// Tests core/fracture/fragments/HullSeparation.cpp.
#include "core/fracture/fragments/HullSeparation.h"

#include "core/base/Random.h"
#include "core/fracture/fragments/SolidFracture.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidMerge.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The deepest overlap of hulls of different fragments, m.
double deepestOverlap(const Fragments& fragments) {
    double deepest = 0.0;
    for (std::uint32_t one = 0; one < fragments.count(); ++one) {
        for (std::uint32_t other = one + 1; other < fragments.count(); ++other) {
            const Pose first{.position = fragments[one].offset()}, second{.position = fragments[other].offset()};
            for (const Polytope& a : fragments[one].hulls()) {
                for (const Polytope& b : fragments[other].hulls())
                    deepest = std::max(deepest, hullOverlap(a, first, b, second).depth);
            }
        }
    }
    return deepest;
}

}  // namespace

class HullSeparationTest : public QObject {
    Q_OBJECT
private slots:
    void overlappingBoxesMeetHalfWay() {
        std::vector<std::vector<Polytope>> hulls{{boxOf({1.0, 1.0, 1.0})},
                                                 {translated(boxOf({1.0, 1.0, 1.0}), {0.8, 0.1, 0.0})}};
        separateHulls(hulls, 1e-7);
        QVERIFY(std::abs(massOf(hulls[0][0]).volume - 0.9) < 1e-12);
        QVERIFY(std::abs(massOf(hulls[1][0]).volume - 0.9) < 1e-12);
        QVERIFY(hullOverlap(hulls[0][0], hulls[1][0]).depth < 1e-12);
    }
    void hullsOfOneFragmentAndThoseThatTouchStay() {
        const std::vector<std::vector<Polytope>> hulls{
            {boxOf({1.0, 1.0, 1.0}), translated(boxOf({1.0, 1.0, 1.0}), {0.5, 0.0, 0.0})},
            {translated(boxOf({1.0, 1.0, 1.0}), {-1.0, 0.0, 0.0})}};
        std::vector<std::vector<Polytope>> separated = hulls;
        separateHulls(separated, 1e-7);
        QVERIFY(separated == hulls);
    }
    /// A cut adds corners where it crosses edges; a hull of few corners keeps few.
    void hullsThatAreCutHaveFewCorners() {
        Random random(7);
        std::vector<Vec3> points;
        while (points.size() < kMaxCollisionCorners) {
            const Vec3 point{random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
            if (glm::length(point) > 0.1 && glm::length(point) < 1.0) points.push_back(glm::normalize(point));
        }
        const Polytope ball = convexHull(points).value();
        std::vector<std::vector<Polytope>> hulls{{ball}, {translated(ball, {1.9, 0.0, 0.0})}};
        QVERIFY(separateHulls(hulls, 1e-7)[0] > 0.0);
        for (const std::vector<Polytope>& one : hulls) {
            QVERIFY(one[0].vertices.size() <= kMaxCollisionCorners);
            QVERIFY(!verifyPolytope(one[0]));
            QVERIFY(massOf(one[0]).volume > 0.95 * massOf(ball).volume);
        }
        QVERIFY(hullOverlap(hulls[0][0], hulls[1][0]).depth < 1e-6);
    }
    /// Cells that are merged at random are not convex, and reach around each other.
    void mergedCellsDoNotOverlap() {
        const TriangleMesh mesh = torus(16, 10);
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            SolidPartition partition = *cutSolid(mesh, seedsInBox(mesh, 40, seed));
            Random random(seed);
            std::vector<std::uint32_t> receivers(partition.fragmentCount());
            for (std::uint32_t k = 0; k < receivers.size(); ++k) {
                receivers[k] = k;
                if (k > 0 && random.below(2) == 0) receivers[k] = receivers[random.below(k)];
            }
            const Fragments fragments = *solidFragments(mergedFragments(std::move(partition), receivers));
            const double depth = deepestOverlap(fragments);
            QVERIFY2(depth < 1e-6, qPrintable(QString("seed %1: %2 m").arg(seed).arg(depth)));
        }
    }
};

RUBBLE_TEST(HullSeparationTest)
#include "HullSeparationTest.moc"
