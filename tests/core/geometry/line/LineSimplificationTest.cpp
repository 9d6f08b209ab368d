#include "core/geometry/line/LineSimplification.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class LineSimplificationTest : public QObject {
    Q_OBJECT
private slots:
    void pointsNearTheLineAreLeftOut() {
        const std::vector<Vec2> line{{0.0, 0.0}, {1.0, 0.09}, {2.0, -0.09}, {3.0, 0.0}};
        QCOMPARE(simplified(line, 0.1), (std::vector<Vec2>{{0.0, 0.0}, {3.0, 0.0}}));
    }
    void cornersStay() {
        const std::vector<Vec2> line{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {2.0, 2.0}};
        QCOMPARE(simplified(line, 0.1), (std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}}));
    }
    void aClosedLineKeepsItsFarthestPoint() {
        const std::vector<Vec2> line{{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}};
        QCOMPARE(simplified(line, 0.1), line);
    }
    void aPointThatDoesNotMoveIsOne() {
        QCOMPARE(simplified({{1.0, 2.0}}, 0.1), (std::vector<Vec2>{{1.0, 2.0}}));
        QCOMPARE(simplified({{1.0, 2.0}, {1.0, 2.0}}, 0.1), (std::vector<Vec2>{{1.0, 2.0}}));
    }
};

RUBBLE_TEST(LineSimplificationTest)
#include "LineSimplificationTest.moc"
