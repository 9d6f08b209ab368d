#include "core/fracture/pattern/Pattern.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

std::size_t seedsIn(const SeedCount& count, const Polygon& outline, ScatterDomain domain = ScatterDomain::Outline) {
    const UniformScatter scatter{.count = count, .domain = domain};
    return seedsOf({{{.id = 1, .randomSeed = 1, .parameters = scatter}}}, outline).value().positions.size();
}

std::string seedCountFault(const SeedCount& count) {
    return verifyPattern({{{.id = 1, .parameters = UniformScatter{.count = count}}}}).value_or("");
}

}  // namespace

class SeedCountTest : public QObject {
    Q_OBJECT
private slots:
    void countsScaleWithTheArea() {
        // The ring has 16 - 4 m², its box 16.
        QCOMPARE(seedsIn(7, squareRing()), std::size_t{7});
        QCOMPARE(seedsIn({CountBy::Density, 2.5}, squareRing()), std::size_t{30});
        QCOMPARE(seedsIn({CountBy::Density, 2.5}, squareRing(), ScatterDomain::BoundingBox), std::size_t{40});
        QCOMPARE(seedsIn({CountBy::FragmentSize, 0.5}, squareRing()), std::size_t{48});
        QCOMPARE(seedsIn({CountBy::FragmentSize, 100.0}, squareRing()), std::size_t{1});
    }
    void tooManySeedsAreRejected() {
        for (const SeedCount& count : {SeedCount(CountBy::Density, 1e7), {CountBy::FragmentSize, 1e-200}}) {
            const auto seeds = seedsOf({{{.id = 1, .parameters = UniformScatter{.count = count}}}}, squareRing());
            QVERIFY(!seeds);
            QCOMPARE(seeds.error().code, ErrorCode::Limit);
        }
    }
    void invalidAmountsAreRejected() {
        QCOMPARE(seedCountFault(0), std::string());
        QCOMPARE(seedCountFault({CountBy::Density, 0.0}),
                 std::string("Layer 1: \"Count\" is 0 per square metre, but must be finite and above zero."));
        QCOMPARE(seedCountFault({CountBy::FragmentSize, -1.0}),
                 std::string("Layer 1: \"Count\" is -1 m per fragment, but must be finite and above zero."));
        QCOMPARE(seedCountFault({CountBy::Number, 2e7}),
                 std::string("Layer 1: \"Count\" is 20000000, but must be from 0 to 10000000."));
    }
};

RUBBLE_TEST(SeedCountTest)
#include "SeedCountTest.moc"
