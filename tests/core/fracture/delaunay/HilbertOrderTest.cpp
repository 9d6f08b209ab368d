#include "core/fracture/delaunay/HilbertOrder.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

class HilbertOrderTest : public QObject {
    Q_OBJECT
private slots:
    void consecutiveGridPointsAreAdjacent() {
        std::vector<Vec2> points;
        for (int x = 0; x < 64; ++x)
            for (int y = 0; y < 64; ++y) points.push_back({x, y});
        const auto order = hilbertOrder(points);
        for (std::size_t i = 1; i < order.size(); ++i) {
            const Vec2 step = points[order[i]] - points[order[i - 1]];
            QCOMPARE(std::abs(step.x) + std::abs(step.y), 1.0);
        }
    }
    void isAPermutationWithEqualPointsConsecutive() {
        const std::uint64_t seed = 5;
        Random random(seed);
        for (const double spread : {1.0, 1e-9, 0.0}) {
            std::vector<Vec2> points = {{0, 0}, {1, 1}};
            for (int i = 0; i < 500; ++i) {
                const Vec2 point = {0.5 + spread * random.unit(), 0.5 + 0.001 * spread * random.unit()};
                points.insert(points.end(), i % 5 == 0 ? 2 : 1, point);
            }
            const auto order = hilbertOrder(points);
            UninitializedVector<std::uint32_t> sorted = order;
            std::sort(sorted.begin(), sorted.end());
            for (std::uint32_t i = 0; i < sorted.size(); ++i) QVERIFY2(sorted[i] == i, "seed 5");
            for (std::uint32_t i = 0; i < points.size(); ++i) {
                for (std::uint32_t j = i + 1; j < points.size(); ++j) {
                    if (points[i] != points[j] || (j > i + 1 && points[j - 1] == points[i])) continue;
                    const auto first = std::find(order.begin(), order.end(), i);
                    QVERIFY(first + 1 != order.end());
                    QCOMPARE(*(first + 1), j);
                }
            }
        }
    }
    void emptyInputGivesEmptyOrder() { QVERIFY(hilbertOrder({}).empty()); }
};

RUBBLE_TEST(HilbertOrderTest)
#include "HilbertOrderTest.moc"
