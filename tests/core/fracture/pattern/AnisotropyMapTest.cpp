// Tests core/fracture/pattern/AnisotropyMap.cpp and core/fracture/kinds/Grain.cpp.
#include "core/fracture/pattern/AnisotropyMap.h"

#include "core/base/Random.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>

using namespace rubble;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

Pattern grains(const std::vector<Grain>& layers) {
    Pattern pattern;
    for (const Grain& grain : layers)
        pattern.layers.push_back({.id = static_cast<std::uint32_t>(pattern.layers.size()) + 1, .parameters = grain});
    return pattern;
}

AnisotropyMap mapOf(const std::vector<Grain>& layers, const Polygon& outline = unitSquare()) {
    return *AnisotropyMap::of(grains(layers), outline);
}

bool areNear(Vec2 a, Vec2 b) { return glm::distance(a, b) < 1e-12; }

}  // namespace

class AnisotropyMapTest : public QObject {
    Q_OBJECT
private slots:
    void patternWithoutGrainHasNoMap() {
        QVERIFY(!AnisotropyMap::of({{{.id = 1, .parameters = UniformScatter{}}}}, unitSquare()));
        QVERIFY(!AnisotropyMap::of(grains({{.ratio = 1.0}}), unitSquare()));
        QVERIFY(!AnisotropyMap::of({{{.id = 1, .isOn = false, .parameters = Grain{}}}}, unitSquare()));
    }
    void distancesAlongTheGrainAreDivided() {
        const AnisotropyMap level = mapOf({{.angle = 0.0, .ratio = 4.0}});
        QVERIFY(areNear(level(Vec2(4.0, 1.0)), {1.0, 1.0}));
        QVERIFY(areNear(level.inverse({1.0, 1.0}), {4.0, 1.0}));
        const AnisotropyMap upright = mapOf({{.angle = kHalfTurn / 2.0, .ratio = 4.0}});
        QVERIFY(areNear(upright(Vec2(1.0, 4.0)), {1.0, 1.0}));
    }
    void grainsAtRightAnglesScaleAlike() {
        const AnisotropyMap both =
            mapOf({{.angle = 0.3, .ratio = 2.0}, {.angle = 0.3 + kHalfTurn / 2.0, .ratio = 2.0}});
        QVERIFY(areNear(both(Vec2(3.0, -5.0)), {1.5, -2.5}));
    }
    void inverseLeadsBack() {
        for (std::uint64_t number = 1; number <= 500; ++number) {
            Random random(number);
            const AnisotropyMap map = mapOf({{.angle = random.between(-3.0, 3.0), .ratio = random.between(1.1, 20.0)},
                                             {.angle = random.between(-3.0, 3.0), .ratio = random.between(1.1, 20.0)}});
            const Vec2 point(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            QVERIFY2(areNear(map.inverse(map(point)), point), qPrintable(faultOfSeed(number, "inverse")));
        }
    }
    void partitionGetsTheOutlineBackBitForBit() {
        for (std::uint64_t number = 1; number <= 100; ++number) {
            Random random(number);
            Polygon outline = squareRing();
            const Vec2 by(random.between(-100.0, 100.0), random.between(-100.0, 100.0));
            for (Ring* ring : {&outline.outer, &outline.holes[0]})
                for (Vec2& corner : *ring) corner += by;
            const AnisotropyMap map = mapOf({{.angle = random.between(-3.0, 3.0), .ratio = 3.0}}, outline);
            std::vector<Vec2> seeds;
            for (int k = 0; k < 12; ++k) seeds.push_back(by + Vec2(random.between(0.0, 4.0), random.between(0.0, 4.0)));
            const Result<Partition> mapped = voronoiPartition(map(outline), map(std::span<const Vec2>(seeds)));
            QVERIFY(mapped);
            const Partition partition = map.inverse(*mapped, outline);
            const std::string fault = verifyPartition(partition, outline).value_or("");
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(number, fault)));
            for (const Vec2 corner : cornersOf(outline)) {
                const bool isKept = std::ranges::any_of(partition.points,
                                                        [&](Vec2 point) { return point == corner - partition.origin; });
                QVERIFY2(isKept, qPrintable(faultOfSeed(number, "corner")));
            }
        }
    }
    void ratioHasARange() {
        const auto faultOf = [](double ratio) { return verifyPattern(grains({{.ratio = ratio}})).value_or(""); };
        QCOMPARE(faultOf(20.0), "");
        QVERIFY(!faultOf(20.1).empty());
        QVERIFY(!faultOf(0.9).empty());
    }
};

RUBBLE_TEST(AnisotropyMapTest)
#include "AnisotropyMapTest.moc"
