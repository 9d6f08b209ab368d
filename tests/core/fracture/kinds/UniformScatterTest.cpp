// Tests core/fracture/kinds/UniformScatter.cpp and core/fracture/sampling/ScatterArea.cpp.
#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

Seeds uniformSeeds(const UniformScatter& scatter, const Polygon& outline, std::uint64_t randomSeed = 1) {
    return layerSeeds(scatter, outline, randomSeed).value();
}

}  // namespace

class UniformScatterTest : public QObject {
    Q_OBJECT
private slots:
    void greaterCountKeepsEarlierSeeds() {
        const Seeds few = uniformSeeds({.count = 50}, lShapeWithHole());
        Seeds many = uniformSeeds({.count = 80}, lShapeWithHole());
        many.positions.resize(50);
        QCOMPARE(many.positions, few.positions);
    }
    void otherRandomSeedGivesOtherPositions() {
        QVERIFY(uniformSeeds({.count = 3}, unitSquare(), 1).positions !=
                uniformSeeds({.count = 3}, unitSquare(), 2).positions);
    }
    void seedsLieInsideTheOutline() {
        for (const Vec2 seed : uniformSeeds({.count = 2000}, lShapeWithHole()).positions) {
            QVERIFY(containment(lShapeWithHole(), seed) != Containment::Outside);
        }
    }
    void seedsAreUniformInTheOutline() {
        const Seeds seeds = uniformSeeds({.count = 11000}, lShapeWithHole());  // 11 quarters of area: 1000 a quarter
        int upper = 0;
        for (const Vec2 seed : seeds.positions) upper += seed.y > 1.0 ? 1 : 0;
        QVERIFY(std::abs(upper - 4000) < 250);  // five standard deviations, sqrt(11000 * 4/11 * 7/11) = 50
    }
    void boundingBoxIsFilled() {
        const Seeds seeds = uniformSeeds({.count = 4000, .domain = ScatterDomain::BoundingBox}, lShapeWithHole());
        int missingQuarter = 0;
        for (const Vec2 seed : seeds.positions) missingQuarter += seed.x > 1.0 && seed.y > 1.0 ? 1 : 0;
        QVERIFY(std::abs(missingQuarter - 1000) < 140);  // five standard deviations
    }
    void diagonalSliversAreFilledQuickly() {
        // A diagonal sliver that covers a millionth of its box: rejection sampling would need a million points per
        // seed.
        const Polygon sliver{{{0.0, 0.0}, {1.0, 1.0}, {0.999999, 1.0}}, {}};
        for (const Vec2 seed : uniformSeeds({.count = 1000}, sliver).positions) {
            QVERIFY(seed.x >= 0.0 && seed.x <= 1.0);
            QVERIFY(std::abs(seed.y - seed.x) <= 1.1e-6);
        }
    }
    void seedsStayInsideOutlinesFarFromTheOrigin() {
        Polygon far = unitSquare();
        for (Vec2& corner : far.outer) corner = corner * 1e-3 + Vec2{1e6, -1e6};
        for (const Vec2 seed : uniformSeeds({.count = 500}, far).positions) {
            QVERIFY(containment(far, seed) != Containment::Outside);
        }
    }
};

RUBBLE_TEST(UniformScatterTest)
#include "UniformScatterTest.moc"
