#include "core/structure/capacity/BondPainting.h"

#include "core/fracture/fragments/Extrusion.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

using namespace rubble;

namespace {

BondStroke line(std::vector<Vec2> points, double radius) {
    return {.brush = BondBrush::Anchor, .radius = radius, .points = std::move(points)};
}

Polygon placed(const Fragment& fragment) {
    Polygon outline = fragment.extruded()->outline();
    const Vec2 offset{fragment.offset()};
    for (Vec2& corner : outline.outer) corner += offset;
    for (Ring& hole : outline.holes)
        for (Vec2& corner : hole) corner += offset;
    return outline;
}

}  // namespace

class BondPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void strokesTouchWhatIsWithinTheirRadius() {
        QVERIFY(touches(line({{0.5, 0.5}}, 0.01), unitSquare()));                // inside
        QVERIFY(touches(line({{1.25, 0.5}}, 0.25), unitSquare()));               // beside an edge
        QVERIFY(!touches(line({{1.25, 0.5}}, 0.24), unitSquare()));              //
        QVERIFY(touches(line({{-1.0, 0.5}, {2.0, 0.5}}, 0.01), unitSquare()));   // across, both ends outside
        QVERIFY(touches(line({{-1.0, 0.5}, {0.5, 2.0}}, 0.36), unitSquare()));   // past a corner
        QVERIFY(!touches(line({{-1.0, 0.5}, {0.5, 2.0}}, 0.35), unitSquare()));  //
        QVERIFY(!touches(line({}, 10.0), unitSquare()));
    }
    void aStrokeInAHoleTouchesItsRimOnly() {
        QVERIFY(!touches(line({{2.0, 2.0}}, 0.9), squareRing()));
        QVERIFY(touches(line({{2.0, 2.0}}, 1.0), squareRing()));
    }
    void theLastStrokeOfTheBrushDecides() {
        const Polygon outline{rectangle({0.0, 0.0}, {3.0, 1.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 0.5}, {1.5, 0.5}, {2.5, 0.5}};
        const Fragments fragments = *extrudedFragments({outline, 1.0}, *voronoiPartition(outline, seeds));
        std::vector<bool> expected(3, false);
        for (std::uint32_t k = 0; k < 3; ++k)
            expected[fragments.extruded()->fragmentOfPiece[fragments.extruded()->partition.pieceOfSeed[k]]] = k < 2;
        BondStroke erase = line({{2.5, 0.5}}, 0.1);
        erase.isErasing = true;
        BondStroke other = line({{2.5, 0.5}}, 0.1);
        other.brush = BondBrush::NeverBreaks;
        const std::vector<BondStroke> strokes{line({{0.5, 0.5}, {2.5, 0.5}}, 0.1), erase, other};
        QCOMPARE(paintedFragments(fragments, strokes, BondBrush::Anchor), expected);
        QCOMPARE(paintedFragments(fragments, {}, BondBrush::Anchor), std::vector<bool>(3, false));
    }
    void fragmentsArePaintedIfStrokesTouchThem() {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 3));
            const Fragments fragments = *extrudedFragments({made.outline, 1.0}, made.partition);
            std::vector<BondStroke> strokes;
            for (int k = 0; k < 6; ++k) {
                std::vector<Vec2> points;
                const Vec2 near = made.seeds[random.below(made.seeds.size())];
                for (std::uint64_t count = random.below(3); count < 3; ++count)
                    points.push_back(near + Vec2{random.between(-0.5, 0.5), random.between(-0.5, 0.5)});
                strokes.push_back(line(points, random.between(0.01, 0.2)));
                strokes.back().isErasing = random.below(3) == 0;
            }
            const std::vector<bool> isPainted = paintedFragments(fragments, strokes, BondBrush::Anchor);
            for (std::uint32_t k = 0; k < fragments.count(); ++k) {
                bool expected = false;
                for (const BondStroke& stroke : strokes)
                    if (touches(stroke, placed(fragments[k]))) expected = !stroke.isErasing;
                QVERIFY2(isPainted[k] == expected, qPrintable(faultOfSeed(seed, "a fragment is painted wrongly")));
            }
        }
    }
};

RUBBLE_TEST(BondPaintingTest)
#include "BondPaintingTest.moc"
