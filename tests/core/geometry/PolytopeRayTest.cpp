#include "core/geometry/PolytopeRay.h"
#include "tests/support/Hulls.h"

#include <QTest>

using namespace rubble;

class PolytopeRayTest : public QObject {
    Q_OBJECT
private slots:
    void aRayEntersByTheFaceTowardsIt() {
        const auto entry = entryOf(test::boxOf({2.0, 4.0, 6.0}), {{0.5, 10.0, 1.0}, {0.0, -1.0, 0.0}});
        QVERIFY(entry);
        QCOMPARE(entry->distance, 8.0);
        QVERIFY(entry->normal == Vec3(0.0, 1.0, 0.0));
    }
    void raysThatMissOrLeaveEnterNowhere() {
        const Polytope box = test::boxOf({2.0, 2.0, 2.0});
        QVERIFY(!entryOf(box, {{1.5, 10.0, 0.0}, {0.0, -1.0, 0.0}}));
        QVERIFY(!entryOf(box, {{0.0, 10.0, 0.0}, {0.0, 1.0, 0.0}}));
        QVERIFY(!entryOf(box, {{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}));
    }
    /// The point where it enters lies on a face and outside of none.
    void entriesLieOnTheSurface() {
        Random random(4711);
        for (int k = 0; k < 300; ++k) {
            const Polytope solid = test::randomSolid(random);
            const Ray ray{10.0 * test::randomIn(random, 1.0), glm::normalize(test::randomIn(random, 1.0))};
            const auto entry = entryOf(solid, ray);
            if (!entry) continue;
            double farthest = -1.0;
            for (const Plane& plane : solid.planes) {
                farthest = std::max(farthest, glm::dot(plane.normal, ray.at(entry->distance)) - plane.offset);
            }
            QVERIFY(std::abs(farthest) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(PolytopeRayTest)
#include "PolytopeRayTest.moc"
