#include "core/geometry/polygon/OutlineCombination.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

constexpr auto kAdd = OutlineOperation::Add;
constexpr auto kCut = OutlineOperation::Cut;

bool refuses(const Polygon& outline, const Ring& shape, OutlineOperation operation, const std::string& part) {
    const Result<Polygon> result = combined(outline, shape, operation);
    if (result) return false;
    const bool isExpected = result.error().message.find(part) != std::string::npos;
    if (!isExpected) qWarning("%s", result.error().message.c_str());
    return isExpected;
}

Ring movedBy(Ring ring, Vec2 by) {
    for (Vec2& point : ring) point += by;
    return ring;
}

}  // namespace

class OutlineCombinationTest : public QObject {
    Q_OBJECT
private slots:
    void doorOnTheGroundIsCutOut() {
        const Result<Polygon> wall = combined(unitSquare(), rectangle({0.4, 0.0}, {0.6, 0.7}), kCut);
        QVERIFY2(wall, wall ? "" : wall.error().message.c_str());
        QCOMPARE(
            wall->outer,
            (Ring{{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.7}, {0.6, 0.7}, {0.6, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}));
        QVERIFY(wall->holes.empty());
        QVERIFY(*combined(unitSquare(), rectangle({0.4, -0.3}, {0.6, 0.7}), kCut) == *wall);  // across the ground
    }
    void shapeInsideBecomesAHole() {
        const Result<Polygon> wall = combined(unitSquare(), rectangle({0.4, 0.4}, {0.6, 0.6}), kCut);
        QVERIFY2(wall, wall ? "" : wall.error().message.c_str());
        QCOMPARE(wall->outer, unitSquare().outer);
        QCOMPARE(wall->holes.size(), std::size_t{1});
        QVERIFY(*validated(*wall) == *wall);
    }
    void shapeAcrossAHoleAndTheBorderOpensTheHole() {
        const Result<Polygon> wall = combined(squareRing(), rectangle({-1.0, 1.5}, {2.0, 1.7}), kCut);
        QVERIFY2(wall, wall ? "" : wall.error().message.c_str());
        QVERIFY(wall->holes.empty());
    }
    void addedShapeLosesTheSharedEdge() {
        const Result<Polygon> both = combined(unitSquare(), rectangle({1.0, 0.0}, {1.5, 1.0}), kAdd);
        QVERIFY(both);
        QCOMPARE(both->outer, rectangle({0.0, 0.0}, {1.5, 1.0}));
    }
    void straightCornersOfTheOutlineStay() {
        const Polygon outline{{{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}};
        const Result<Polygon> both = combined(outline, rectangle({0.4, 0.9}, {0.6, 1.2}), kAdd);
        QVERIFY(both);
        QCOMPARE(both->outer.size(), outline.outer.size() + 4);
        QCOMPARE(both->outer[1], Vec2(0.5, 0.0));
    }
    void holesKeepTheirOrder() {
        Polygon outline{rectangle({0.0, 0.0}, {4.0, 1.0}), {}};
        outline.holes = {reversed(rectangle({3.0, 0.4}, {3.2, 0.6})), reversed(rectangle({1.0, 0.4}, {1.2, 0.6}))};
        const Result<Polygon> wall = combined(outline, rectangle({2.0, 0.4}, {2.2, 0.6}), kCut);
        QVERIFY2(wall, wall ? "" : wall.error().message.c_str());
        QCOMPARE(wall->holes.size(), std::size_t{3});
        QCOMPARE(wall->holes[0], outline.holes[0]);
        QCOMPARE(wall->holes[1], outline.holes[1]);
    }
    void impossibleCombinationsAreRefused() {
        const Polygon square = unitSquare();
        QVERIFY(refuses(square, rectangle({0.2, 0.2}, {0.4, 0.4}), kAdd, "within the outline"));
        QVERIFY(refuses(square, rectangle({2.0, 0.2}, {2.4, 0.4}), kAdd, "does not overlap"));
        QVERIFY(refuses(square, rectangle({1.0, 1.0}, {1.4, 1.4}), kAdd, "does not overlap"));  // a corner is shared
        QVERIFY(refuses(square, rectangle({2.0, 0.2}, {2.4, 0.4}), kCut, "outside the outline"));
        QVERIFY(refuses(square, rectangle({-1.0, -1.0}, {2.0, 2.0}), kCut, "nothing would remain"));
        QVERIFY(refuses(square, rectangle({0.4, -1.0}, {0.6, 2.0}), kCut, "into 2 parts"));
        QVERIFY(refuses(square, {{0.5, 0.0}, {0.6, 0.2}, {0.4, 0.2}}, kCut, "would touch itself at (0.5, 0)"));
        QVERIFY(refuses(square, {{0.2, 0.2}, {0.8, 0.8}, {0.8, 0.2}, {0.2, 0.8}}, kCut, "crosses itself"));
    }
    void shapesOnSlopedEdgesShareThem() {
        for (std::uint64_t number = 1; number <= 2000; ++number) {
            Random random(number);
            const Polygon outline{movedBy(regularPolygonOutline(5, 2.0).outer, {random.between(-9.0, 9.0), 0.3}), {}};
            const std::size_t edge = random.below(5);
            const Vec2 from = outline.outer[edge], to = outline.outer[(edge + 1) % 5];
            const Vec2 inwards = 0.3 * Vec2(from.y - to.y, to.x - from.x);
            const Vec2 a = from + random.between(0.1, 0.4) * (to - from),
                       b = from + random.between(0.5, 1.0) * (to - from);
            const Result<Polygon> notched = combined(outline, {a, b, b + inwards, a + inwards}, kCut);
            QVERIFY2(
                notched,
                qPrintable(QString("seed %1: %2").arg(number).arg(notched ? "" : notched.error().message.c_str())));
            QCOMPARE(notched->outer.size(), std::size_t{9});
            const Result<Polygon> filled = combined(*notched, {a, b, b + inwards, a + inwards}, kAdd);
            QVERIFY2(filled, qPrintable(QString("seed %1").arg(number)));
            QCOMPARE(filled->outer, outline.outer);
        }
    }
    void areasMatchOnALattice() {  // edges along each other, corners on edges
        int combinations = 0;
        for (std::uint64_t number = 1; number <= 4000; ++number) {
            Random random(number);
            Polygon outline{rectangle({1.0, 1.0}, {5.0, 5.0}), {reversed(rectangle({2.0, 2.0}, {3.0, 4.0}))}};
            const Ring shape = randomLatticeRing(random, 6, 7);
            if (!validated(Polygon{shape, {}})) continue;
            const Result<Polygon> both = combined(outline, shape, kAdd), rest = combined(outline, shape, kCut);
            if (both) QVERIFY(validated(*both));
            if (rest) QVERIFY(validated(*rest));
            if (!both || !rest) continue;
            ++combinations;
            const double overlap = area(outline) - area(*rest);
            QVERIFY2(std::abs(area(*both) + overlap - area(outline) - area(Polygon{shape, {}})) < 1e-12,
                     qPrintable(QString("seed %1").arg(number)));
        }
        QVERIFY2(combinations > 100, qPrintable(QString::number(combinations)));
    }
    void areasOfUnionAndDifferenceMatch() {
        int combinations = 0;
        for (std::uint64_t number = 1; number <= 2000; ++number) {
            Random random(number);
            const Ring shape = movedBy(star(5 + static_cast<std::uint32_t>(random.below(8)), 0.3, 0.9),
                                       {random.between(-1.5, 1.5), random.between(-1.5, 1.5)});
            const Polygon outline = number % 2 == 0 ? squareRing() : lShapeWithHole();
            const Result<Polygon> both = combined(outline, shape, kAdd), rest = combined(outline, shape, kCut);
            if (both) QVERIFY(validated(*both));
            if (rest) QVERIFY(validated(*rest));
            if (!both || !rest) continue;
            ++combinations;
            const double overlap = area(outline) - area(*rest);
            QVERIFY(std::abs(area(*both) + overlap - area(outline) - area(Polygon{shape, {}})) < 1e-12);
        }
        QVERIFY2(combinations > 300, qPrintable(QString::number(combinations)));
    }
};

RUBBLE_TEST(OutlineCombinationTest)
#include "OutlineCombinationTest.moc"
