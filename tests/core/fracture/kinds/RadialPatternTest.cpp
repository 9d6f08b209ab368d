#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/sampling/PairIndex.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace rubble;

namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;

std::map<std::uint32_t, Vec2> radialSeeds(const RadialPattern& radial, const Polygon& outline) {
    return positionsByIndex(layerSeeds(radial, outline, 8).value());
}

std::uint32_t indexOf(std::uint32_t ring, std::uint32_t spoke) { return 1 + pairIndex(ring, spoke); }

const Polygon kWide{rectangle({-10.0, -10.0}, {10.0, 10.0}), {}};

}  // namespace

class RadialPatternTest : public QObject {
    Q_OBJECT
private slots:
    void seedsAreOnRingsAndSpokes() {
        const RadialPattern radial{.centre = {1.0, -2.0},
                                   .radius = 4.0,
                                   .rings = 2,
                                   .spokes = 4,
                                   .exponent = 2.0,
                                   .rotation = kPi / 2.0,
                                   .variation = 0.0};
        const auto seeds = radialSeeds(radial, kWide);
        QCOMPARE(seeds.size(), std::size_t{9});
        QCOMPARE(seeds.at(0), Vec2(1.0, -2.0));
        const auto isAt = [&](std::uint32_t ring, std::uint32_t spoke, Vec2 place) {
            const Vec2 off = seeds.at(indexOf(ring, spoke)) - place;
            return std::abs(off.x) + std::abs(off.y) < 1e-14;
        };
        QVERIFY(isAt(0, 0, {1.0, -1.0}));  // half of the rings, squared: a quarter of the radius; rotated upwards
        QVERIFY(isAt(0, 1, {0.0, -2.0}));
        QVERIFY(isAt(1, 2, {1.0, -6.0}));
        QVERIFY(isAt(1, 3, {5.0, -2.0}));
    }
    void variedSeedsStayWithinHalfway() {
        const RadialPattern radial{.radius = 5.0, .rings = 10, .spokes = 12, .exponent = 1.0, .variation = 1.0};
        for (const auto& [index, seed] : radialSeeds(radial, kWide)) {
            if (index == 0) continue;
            const double distance = std::hypot(seed.x, seed.y), angle = std::atan2(seed.y, seed.x);
            const double ring = std::round(distance / 0.5), spoke = std::round(angle / (kPi / 6.0) + 12.0);
            const auto nearest = indexOf(static_cast<std::uint32_t>(ring) - 1, static_cast<std::uint32_t>(spoke) % 12);
            QCOMPARE(nearest, index);
        }
    }
    void addedRingsAndSpokesKeepIndices() {
        const auto few = radialSeeds({.radius = 1.0, .rings = 3, .spokes = 5, .exponent = 1.0}, kWide);
        const auto many = radialSeeds({.radius = 2.0, .rings = 6, .spokes = 5, .exponent = 1.0}, kWide);
        for (const auto& [index, seed] : few) {
            QVERIFY(std::abs(seed.x - many.at(index).x) + std::abs(seed.y - many.at(index).y) < 1e-12);
        }
        const auto dense = radialSeeds({.radius = 1.0, .rings = 3, .spokes = 9}, kWide);
        for (const auto& [index, seed] : few) QVERIFY(dense.contains(index));
    }
    void seedsOutsideAreOmitted() {
        const auto seeds = radialSeeds({.radius = 2.0, .rings = 4, .spokes = 8, .variation = 0.0}, squareRing());
        QVERIFY(seeds.contains(0));  // the centre is a corner of the outline
        for (const auto& [index, seed] : seeds) QVERIFY(containment(squareRing(), seed) != Containment::Outside);
        QVERIFY(seeds.size() < 33);
    }
};

RUBBLE_TEST(RadialPatternTest)
#include "RadialPatternTest.moc"
