#include "core/physics/queries/HullDistance.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <cmath>

using namespace rubble;

class HullDistanceTest : public QObject {
    Q_OBJECT
private slots:
    void distanceFromAUnitCube_data() {
        QTest::addColumn<Vec3>("point");
        QTest::addColumn<double>("distance");
        QTest::newRow("inside") << Vec3(0.1, 0.2, -0.3) << 0.0;
        QTest::newRow("on a face") << Vec3(0.5, 0.2, 0.0) << 0.0;
        QTest::newRow("over a face") << Vec3(0.1, 0.2, 1.5) << 1.0;
        QTest::newRow("beside an edge") << Vec3(0.1, 3.5, 4.5) << 5.0;
        QTest::newRow("off a corner") << Vec3(1.5, 2.5, -2.5) << 3.0;
    }
    void distanceFromAUnitCube() {
        QFETCH(Vec3, point);
        QFETCH(double, distance);
        const double found = distanceTo(test::hullOf(test::boxOf(Vec3(1.0))), point);
        QVERIFY2(std::abs(found - distance) < 1e-6, QByteArray::number(found));
    }
    /// A step of that length towards the hull does not get inside, and no point of the hull is nearer.
    void distanceIsTheLeast() {
        Random random(11);
        for (int round = 0; round < 200; ++round) {
            const Hull hull = test::hullOf(test::randomSolid(random));
            const Vec3 point = test::randomIn(random, 3.0);
            const double found = distanceTo(hull, point);
            for (int corner = 0; corner < hull.cornerCount; ++corner) {
                const Vec3 other = toDouble(hull.corner((corner * 7 + 1) % hull.cornerCount));
                const Vec3 inside = glm::mix(toDouble(hull.corner(corner)), other, random.unit());
                QVERIFY(found <= glm::distance(point, inside) + 1e-6);
            }
        }
    }
};

RUBBLE_TEST(HullDistanceTest)
#include "HullDistanceTest.moc"
