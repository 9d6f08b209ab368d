#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

const Polygon kSquare{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}};
/// A square without its upper right quarter, with a hole of a sixteenth at the lower left.
const Polygon kHoledL{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}},
                      {{{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}}}};

Seeds scattered(const UniformScatter& scatter, const Polygon& outline, std::uint64_t randomSeed = 1) {
    const Pattern pattern{{{.id = 1, .randomSeed = randomSeed, .parameters = scatter}}};
    return seedsOf(pattern, outline).value();
}

}  // namespace

class UniformScatterTest : public QObject {
    Q_OBJECT
private slots:
    void greaterCountKeepsEarlierSeeds() {
        const Seeds few = scattered({.count = 50}, kHoledL);
        Seeds many = scattered({.count = 80}, kHoledL);
        many.positions.resize(50);
        QCOMPARE(many.positions, few.positions);
    }
    void otherRandomSeedGivesOtherPositions() {
        QVERIFY(scattered({.count = 3}, kSquare, 1).positions != scattered({.count = 3}, kSquare, 2).positions);
    }
    void seedsLieInsideTheOutline() {
        for (const Vec2 seed : scattered({.count = 2000}, kHoledL).positions) {
            QVERIFY(containment(kHoledL, seed) != Containment::Outside);
        }
    }
    void seedsAreUniformInTheOutline() {
        const Seeds seeds = scattered({.count = 11000}, kHoledL);  // 11 quarters of area: 1000 a quarter
        int upper = 0;
        for (const Vec2 seed : seeds.positions) upper += seed.y > 1.0 ? 1 : 0;
        QVERIFY(std::abs(upper - 4000) < 250);  // five standard deviations, sqrt(11000 * 4/11 * 7/11) = 50
    }
    void boundingBoxIsFilled() {
        const Seeds seeds = scattered({.count = 4000, .domain = ScatterDomain::BoundingBox}, kHoledL);
        int missingQuarter = 0;
        for (const Vec2 seed : seeds.positions) missingQuarter += seed.x > 1.0 && seed.y > 1.0 ? 1 : 0;
        QVERIFY(std::abs(missingQuarter - 1000) < 140);  // five standard deviations
    }
    void diagonalSliversAreFilledQuickly() {
        // A diagonal sliver that covers a millionth of its box: rejection sampling would need a million points per
        // seed.
        const Polygon sliver{{{0.0, 0.0}, {1.0, 1.0}, {0.999999, 1.0}}, {}};
        for (const Vec2 seed : scattered({.count = 1000}, sliver).positions) {
            QVERIFY(seed.x >= 0.0 && seed.x <= 1.0);
            QVERIFY(std::abs(seed.y - seed.x) <= 1.1e-6);
        }
    }
    void seedsStayInsideOutlinesFarFromTheOrigin() {
        Polygon far = kSquare;
        for (Vec2& corner : far.outer) corner = corner * 1e-3 + Vec2{1e6, -1e6};
        for (const Vec2 seed : scattered({.count = 500}, far).positions) {
            QVERIFY(containment(far, seed) != Containment::Outside);
        }
    }
};

RUBBLE_TEST(UniformScatterTest)
#include "UniformScatterTest.moc"
