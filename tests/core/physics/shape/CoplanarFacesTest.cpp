#include "core/physics/shape/CoplanarFaces.h"

#include "core/geometry/hull/ConvexHull.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;

namespace {

/// The points rotated and rounded to decimals.
std::vector<Vec3> roundedPoints(std::vector<Vec3> points, const Quat& turn, int digits) {
    const double scale = std::pow(10.0, digits);
    for (Vec3& point : points) point = glm::round(turn * point * scale) / scale;
    return points;
}

/// The corners of a 0.4 m cube and the midpoints of its edges and faces.
std::vector<Vec3> gridPoints() {
    std::vector<Vec3> points;
    for (int k = 0; k < 27; ++k) points.push_back(0.2 * Vec3(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1));
    return points;
}

}  // namespace

class CoplanarFacesTest : public QObject {
    Q_OBJECT
private slots:
    void exactFacesAreUnchanged() {
        const Polytope box = test::boxOf({1.0, 2.0, 3.0});
        QVERIFY(mergeCoplanarFaces(box, 1e-3) == box);
    }
    void roundedCubeHasSixFaces() {
        Random random(5);
        for (int turn = 0; turn < 200; ++turn) {
            const Result<Polytope> hull = convexHull(roundedPoints(gridPoints(), test::randomRotation(random), 4));
            QVERIFY(hull);
            const Polytope merged = mergeCoplanarFaces(*hull, 1e-3);
            QCOMPARE(merged.vertices.size(), std::size_t{8});
            QCOMPARE(merged.edges.size(), std::size_t{12});
            QCOMPARE(merged.faces.size(), std::size_t{6});
        }
    }
    void allVerticesAreBehindEveryPlane() {
        Random random(6);
        for (int turn = 0; turn < 200; ++turn) {
            const Polytope merged =
                mergeCoplanarFaces(*convexHull(roundedPoints(gridPoints(), test::randomRotation(random), 2)), 2e-3);
            QCOMPARE(merged.vertices.size() + merged.faces.size(), merged.edges.size() + 2);
            for (const Plane& plane : merged.planes) {
                for (const Vec3& vertex : merged.vertices)
                    QVERIFY(glm::dot(plane.normal, vertex) <= plane.offset + 1e-12);
            }
        }
    }
    void hullsOfRoundedPointsAreValid() {
        Random random(7);
        for (const int digits : {2, 3, 4, 6, 9, 12, 15}) {
            for (int turn = 0; turn < 50; ++turn) {
                const auto fault =
                    verifyPolytope(*convexHull(roundedPoints(gridPoints(), test::randomRotation(random), digits)));
                QVERIFY2(!fault, fault ? fault->c_str() : "");
            }
        }
    }
    /// Like bodies of points that were not rounded.
    void bodiesOfRoundedPointsComeToRest() {
        Random random(8);
        BodyScene scene;
        test::addGround(scene, 40.0);
        for (int k = 0; k < 60; ++k) {
            const int digits = 3 + k % 10;
            const Polytope hull = *convexHull(roundedPoints(gridPoints(), test::randomRotation(random), digits));
            const Vec3 place{k % 8 - 4.0, 0.5, k / 8 - 4.0};
            test::addFreeBody(scene, std::to_string(k), test::addShape(scene, {hull}), {.position = place});
        }
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 10.0);
        const Penetration penetration = penetrationOf(scene, test::posesOf(moved));
        qInfo("%.2f mm", 1e3 * penetration.largest);
        QVERIFY(test::areAllAsleep(moved));
        QVERIFY(penetration.largest < 2e-3);  // of it a millimetre by the rounding to three digits
    }
};

RUBBLE_TEST(CoplanarFacesTest)
#include "CoplanarFacesTest.moc"
