#include "core/geometry/hull/PolytopeRay.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;

class PolytopeRayTest : public QObject {
    Q_OBJECT
private slots:
    void rayEntersThroughTheFacingFace() {
        const auto entry = castRay(test::boxOf({2.0, 4.0, 6.0}), {{0.5, 10.0, 1.0}, {0.0, -1.0, 0.0}});
        QVERIFY(entry);
        QCOMPARE(entry->distance, 8.0);
        QVERIFY(entry->normal == Vec3(0.0, 1.0, 0.0));
    }
    void raysThatMissHaveNoHit() {
        const Polytope box = test::boxOf({2.0, 2.0, 2.0});
        QVERIFY(!castRay(box, {{1.5, 10.0, 0.0}, {0.0, -1.0, 0.0}}));
        QVERIFY(!castRay(box, {{0.0, 10.0, 0.0}, {0.0, 1.0, 0.0}}));
        QVERIFY(!castRay(box, {{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}));
    }
    /// The hit point lies on a face and outside none.
    void hitsLieOnTheSurface() {
        Random random(4711);
        for (int k = 0; k < 300; ++k) {
            const Polytope solid = test::randomSolid(random);
            const Ray ray{10.0 * test::randomIn(random, 1.0), glm::normalize(test::randomIn(random, 1.0))};
            const auto entry = castRay(solid, ray);
            if (!entry) continue;
            double farthest = -1.0;
            for (const Plane& plane : solid.planes) {
                farthest = std::max(farthest, glm::dot(plane.normal, ray.at(entry->distance)) - plane.offset);
            }
            QVERIFY(std::abs(farthest) < 1e-12);
        }
    }
};

RUBBLE_TEST(PolytopeRayTest)
#include "PolytopeRayTest.moc"
