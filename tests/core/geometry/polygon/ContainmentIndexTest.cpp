#include "core/geometry/polygon/ContainmentIndex.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

class ContainmentIndexTest : public QObject {
    Q_OBJECT
private slots:
    void positionIsThatOfALinearScan() {
        const Polygon polygon{star(50, 3.0, 4.0), {rectangle({-1.0, -1.0}, {1.0, 0.0}), star(9, 0.2, 0.5)}};
        Polygon apart = polygon;
        for (Vec2& point : apart.holes[1]) point.y += 1.5;
        const ContainmentIndex index(apart);
        Random random(20261123);
        int inside = 0;
        for (int round = 0; round < 20000; ++round) {
            // Every second one on a lattice: at the height of corners, and on edges of the rectangle.
            const auto coordinate = [&] { return random.between(-5.0, 5.0); };
            Vec2 point(coordinate(), coordinate());
            if (round % 2 == 0) point = {std::round(2.0 * point.x) / 2.0, std::round(2.0 * point.y) / 2.0};
            QCOMPARE(index.of(point), containment(apart, point));
            inside += index.of(point) == Containment::Inside;
        }
        QVERIFY(inside > 1000 && inside < 19000);
        for (const Vec2 corner : apart.outer) QCOMPARE(index.of(corner), Containment::OnBoundary);
        QCOMPARE(index.of({0.5, 0.0}), Containment::OnBoundary);  // of a hole
    }
    void fewEdgesAreExamined() {
        constexpr std::uint32_t kCorners = 65536;
        const ContainmentIndex index({star(kCorners, 0.9, 1.0), {}});
        Random random(5);
        std::size_t visited = 0;
        constexpr std::size_t kPoints = 1000;
        for (std::size_t k = 0; k < kPoints; ++k)
            static_cast<void>(index.of({random.between(-1.0, 1.0), random.between(-0.7, 0.7)}, &visited));
        QVERIFY2(visited < kPoints * kCorners / 20, qPrintable(QString::number(visited)));
    }
};

RUBBLE_TEST(ContainmentIndexTest)
#include "ContainmentIndexTest.moc"
