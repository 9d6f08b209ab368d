// Tests core/fracture/kinds/ImpactScatter.cpp and core/fracture/sampling/FalloffArea.cpp.
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/sampling/FalloffArea.h"
#include "tests/support/ChiSquare.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

Seeds seedsOfImpact(const ImpactScatter& scatter, const Polygon& outline, std::uint64_t randomSeed = 4) {
    return layerSeeds(scatter, outline, randomSeed).value();
}

/// The expected distribution of seeds over the cells of a grid: the sum of the density over many small squares with
/// their centres inside the outline.
std::vector<double> expectedOf(const ImpactScatter& scatter, const Polygon& outline, const Box2& box, int side) {
    constexpr int kFine = 24;
    std::vector<double> expected(static_cast<std::size_t>(side * side), 0.0);
    double sum = 0.0;
    for (int y = 0; y < side * kFine; ++y) {
        for (int x = 0; x < side * kFine; ++x) {
            const Vec2 at = box.min + box.size() * Vec2(x + 0.5, y + 0.5) / static_cast<double>(side * kFine);
            if (containment(outline, at) == Containment::Outside) continue;
            const double ratio = std::hypot(at.x - scatter.centre.x, at.y - scatter.centre.y) / scatter.radius;
            const double density = std::pow(1.0 + ratio * ratio, -scatter.falloff / 2.0);
            expected[static_cast<std::size_t>(y / kFine * side + x / kFine)] += density;
            sum += density;
        }
    }
    for (double& each : expected) each *= scatter.count.amount / sum;
    return expected;
}

}  // namespace

class ImpactScatterTest : public QObject {
    Q_OBJECT
private slots:
    void seedDensityMatchesTheFalloff_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("falloff");
        QTest::newRow("even") << 2.0 << 0.5 << 0.0;
        QTest::newRow("in a corner of the hole") << 1.0 << 0.4 << 2.5;
        QTest::newRow("steep") << 0.5 << 0.6 << 6.0;
        QTest::newRow("outside") << -1.5 << 0.5 << 3.0;
    }
    void seedDensityMatchesTheFalloff() {
        QFETCH(double, x);
        QFETCH(double, radius);
        QFETCH(double, falloff);
        const ImpactScatter scatter{.centre = {x, 1.0}, .count = 40'000, .radius = radius, .falloff = falloff};
        constexpr int kSide = 8;
        const Box2 box = boundsOf(squareRing().outer);
        std::vector<double> seen(kSide * kSide, 0.0);
        for (const Vec2 seed : seedsOfImpact(scatter, squareRing()).positions) {
            const Vec2 cell =
                glm::min(glm::floor((seed - box.min) / box.size() * static_cast<double>(kSide)), kSide - 1.0);
            seen[static_cast<std::size_t>(cell.y * kSide + cell.x)] += 1.0;
        }
        const double ratio = chiSquareByLimit(seen, expectedOf(scatter, squareRing(), box, kSide));
        QVERIFY2(ratio < 1.0, qPrintable(QString::number(ratio)));
    }
    void greaterCountKeepsEarlierSeeds() {
        const Seeds few = seedsOfImpact({.count = 50}, lShape());
        Seeds many = seedsOfImpact({.count = 80}, lShape());
        many.positions.resize(50);
        QCOMPARE(many.positions, few.positions);
    }
    void tinyRadiiAndFarCentresTerminate() {
        for (const double radius : {1e-300, 1e-9, 1e300}) {
            for (const double centre : {0.5, 1e6, -1e200}) {
                const ImpactScatter scatter{.centre = {centre, 0.5}, .count = 200, .radius = radius, .falloff = 8.0};
                QCOMPARE(seedsOfImpact(scatter, unitSquare()).positions.size(), std::size_t{200});
            }
        }
        QVERIFY(FalloffArea::of(unitSquare(), {{0.5, 0.5}, 1e-300, 8.0}).value().partCount() < 1'000'000);
    }
    void sliversAreFilledQuickly() {
        const Polygon sliver{{{0.0, 0.0}, {1.0, 1.0}, {0.999999, 1.0}}, {}};
        for (const Vec2 seed : seedsOfImpact({.centre = {0.5, 0.5}, .count = 500}, sliver).positions) {
            QVERIFY(std::abs(seed.y - seed.x) <= 1.1e-6);
        }
    }
};

RUBBLE_TEST(ImpactScatterTest)
#include "ImpactScatterTest.moc"
