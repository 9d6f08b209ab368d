#include "core/geometry/polygon/MinimumCrossSection.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// The polygon rotated about the origin and translated.
Polygon turned(const Polygon& polygon, double angle, Vec2 by) {
    const auto turn = [&](const Ring& ring) {
        Ring moved;
        for (const Vec2 point : ring) {
            moved.push_back(by + Vec2{std::cos(angle) * point.x - std::sin(angle) * point.y,
                                      std::sin(angle) * point.x + std::cos(angle) * point.y});
        }
        return moved;
    };
    Polygon result{turn(polygon.outer), {}};
    for (const Ring& hole : polygon.holes) result.holes.push_back(turn(hole));
    return result;
}

}  // namespace

class MinimumCrossSectionTest : public QObject {
    Q_OBJECT
private slots:
    void rectangleHasItsShorterSide() {
        QCOMPARE(minimumCrossSection({rectangle({10.0, -3.0}, {13.0, -2.0}), {}}), 1.0);
        QCOMPARE(minimumCrossSection({reversed(rectangle({0.0, 0.0}, {0.25, 8.0})), {}}), 0.25);
    }
    void holesAreSubtracted() {
        const Polygon frame{rectangle({0.0, 0.0}, {4.0, 4.0}), {rectangle({1.0, 1.0}, {3.0, 3.0})}};
        QVERIFY(isNear(minimumCrossSection(frame), 2.0));  // two bars
        QVERIFY(isNear(crossSectionLength(frame, {0.5, 0.5}, {1.0, 0.0}), 4.0));
        QVERIFY(isNear(crossSectionLength(frame, {0.5, 2.0}, {1.0, 0.0}), 2.0));
        QCOMPARE(crossSectionLength(frame, {0.0, 5.0}, {1.0, 0.0}), 0.0);
    }
    void concaveOutlineHasItsNeck() {
        // A dumbbell: two squares of 2, joined by a neck 0.2 high about the origin.
        const Ring dumbbell{{-3.0, -1.0}, {-1.0, -1.0}, {-1.0, -0.1}, {1.0, -0.1}, {1.0, -1.0}, {3.0, -1.0},
                            {3.0, 1.0},   {1.0, 1.0},   {1.0, 0.1},   {-1.0, 0.1}, {-1.0, 1.0}, {-3.0, 1.0}};
        QVERIFY(isNear(minimumCrossSection({dumbbell, {}}), 0.2));
    }
    void lineAlongAnEdgeCountsAsBesideIt() {
        const double along = crossSectionLength(unitSquare(), {0.5, 0.0}, {1.0, 0.0});
        QVERIFY(along == 0.0 || along == 1.0);
    }
    void rotationAndTranslationPreserveIt() {
        Random random(20);
        const double exact = minimumCrossSection({rectangle({0.0, 0.0}, {3.0, 0.5}), {}});
        for (int k = 0; k < 200; ++k) {
            const Vec2 by{random.between(-50.0, 50.0), random.between(-50.0, 50.0)};
            const Polygon moved = turned({rectangle({0.0, 0.0}, {3.0, 0.5}), {}}, random.between(0.0, 6.28), by);
            const double cut = minimumCrossSection(moved);
            QVERIFY2(cut >= exact * (1.0 - 1e-9) && cut <= exact * 1.00004, qPrintable(QString::number(cut, 'g', 17)));
        }
    }
    void cShapeWithoutItsCentroidIsPositive() {
        // A C whose centroid is in its gap; its spine and arms are 1 wide.
        const Ring letter{{0.0, 0.0}, {6.0, 0.0}, {6.0, 1.0}, {1.0, 1.0},
                          {1.0, 5.0}, {6.0, 5.0}, {6.0, 6.0}, {0.0, 6.0}};
        QVERIFY(containment({letter, {}}, centroid({letter, {}})) == Containment::Outside);
        QVERIFY(isNear(minimumCrossSection({letter, {}}), 1.0));
    }
};

RUBBLE_TEST(MinimumCrossSectionTest)
#include "MinimumCrossSectionTest.moc"
