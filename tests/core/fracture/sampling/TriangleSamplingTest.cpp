#include "core/fracture/sampling/TriangleSampling.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace rubble;

class TriangleSamplingTest : public QObject {
    Q_OBJECT
private slots:
    void indicesAreDrawnByWeight() {
        const std::array<double, 3> sums{1.0, 1.0, 4.0};  // weights 1, 0 and 3
        Random random(20261130);
        std::array<int, 3> drawn{};
        for (int k = 0; k < 10000; ++k) ++drawn[drawByWeight(sums, random)];
        QCOMPARE(drawn[1], 0);
        QVERIFY2(drawn[0] > 2325 && drawn[0] < 2675,
                 qPrintable(QString::number(drawn[0])));  // four standard deviations
    }
    void pointsFillTheTriangleUniformly() {
        Random random(1);
        Vec2 sum{0.0};
        for (int k = 0; k < 10000; ++k) {
            const Vec2 point = pointOfTriangle({1.0, 2.0}, {3.0, 0.0}, {0.0, 3.0}, random);
            QVERIFY(point.x >= 1.0 && point.y >= 2.0 && point.x + point.y <= 6.0 + 1e-12);
            sum += point;
        }
        const Vec2 mean = sum / 10000.0;  // the centroid; its standard deviation is 0.007 m
        QVERIFY(std::abs(mean.x - 2.0) < 0.03 && std::abs(mean.y - 3.0) < 0.03);
    }
};

RUBBLE_TEST(TriangleSamplingTest)
#include "TriangleSamplingTest.moc"
