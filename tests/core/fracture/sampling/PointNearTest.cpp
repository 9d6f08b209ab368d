#include "core/fracture/sampling/PointNear.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

using namespace rubble;

class PointNearTest : public QObject {
    Q_OBJECT
private slots:
    void halfOfThePointsLieWithinHalfTheRadius() {
        Random random(20261126);
        const Vec2 centre(0.5, 0.5);
        int near = 0;
        for (int k = 0; k < 10000; ++k) {
            const std::optional<Vec2> point = pointNear(unitSquare(), centre, 0.4, random);
            QVERIFY(point && glm::distance(*point, centre) <= 0.4);
            near += glm::distance(*point, centre) < 0.2 ? 1 : 0;
        }
        QVERIFY2(near > 4800 && near < 5200, qPrintable(QString::number(near)));  // four standard deviations
    }
    void pointsLieInTheOutline() {
        Random random(2);
        for (int k = 0; k < 1000; ++k) {
            const std::optional<Vec2> point = pointNear(squareRing(), {1.0, 1.0}, 1.0, random);
            QVERIFY(point && containment(squareRing(), *point) != Containment::Outside);
        }
    }
    void nothingIsFoundFarFromTheOutline() {
        Random random(3);
        QVERIFY(!pointNear(unitSquare(), {9.0, 9.0}, 1.0, random));
        QVERIFY(pointNear(unitSquare(), {1.1, 0.5}, 1.0, random));
    }
};

RUBBLE_TEST(PointNearTest)
#include "PointNearTest.moc"
