#include "core/geometry/hull/Diameter.h"

#include "core/base/Random.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

double diameterOfPairs(const std::vector<Vec2>& points) {
    double diameter = 0.0;
    for (const Vec2& a : points) {
        for (const Vec2& b : points) diameter = std::max(diameter, glm::distance(a, b));
    }
    return diameter;
}

}  // namespace

class DiameterTest : public QObject {
    Q_OBJECT
private slots:
    void fewPoints() {
        QCOMPARE(diameterOf({}), 0.0);
        QCOMPARE(diameterOf({{2.0, 3.0}}), 0.0);
        QCOMPARE(diameterOf({{2.0, 3.0}, {2.0, 3.0}}), 0.0);
        QCOMPARE(diameterOf({{0.0, 0.0}, {3.0, 4.0}}), 5.0);
    }
    void pointsOnALine() { QCOMPARE(diameterOf({{0.0, 1.0}, {3.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}}), 3.0); }
    void pointsInsideDoNotCount() {
        QCOMPARE(diameterOf({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}, {0.0, 4.0}, {1.5, 2.0}, {1.0, 1.0}}), 5.0);
    }
    void itIsThatOfAllPairs() {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            std::vector<Vec2> points;
            for (std::uint64_t k = 2 + random.below(60); k > 0; --k) {
                Vec2 point{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
                if (seed % 3 == 0) point = glm::round(4.0 * point);  // many on lines, many the same
                points.push_back(point);
            }
            const double expected = diameterOfPairs(points);
            const bool isEqual = std::abs(diameterOf(points) - expected) <= 1e-12 * expected;
            QVERIFY2(isEqual, qPrintable(faultOfSeed(seed, "it is not the distance of the farthest pair")));
        }
    }
};

RUBBLE_TEST(DiameterTest)
#include "DiameterTest.moc"
