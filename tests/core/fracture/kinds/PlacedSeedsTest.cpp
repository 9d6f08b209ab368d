#include "core/fracture/kinds/PlacedSeeds.h"

#include "core/fracture/layer/LayerContext.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

class PlacedSeedsTest : public QObject {
    Q_OBJECT
private slots:
    void seedsAreLockedAndKeepTheirIndices() {
        const Polygon outline = unitSquare();
        const TaskContext task;
        SeedSet seeds;
        seeds.add({1, 0}, {0.5, 0.5}, false);
        const PlacedSeeds placed{{{0, {0.1, 0.2}}, {3, {0.4, 0.3}}}};
        QVERIFY(placed.apply({{.layerId = 7, .randomSeed = 0, .overrides = {}, .task = task}, outline}, seeds));
        QCOMPARE(seeds.size(), std::size_t{3});
        QCOMPARE(seeds.positions[2], Vec2(0.4, 0.3));
        QCOMPARE(seeds.ids[2].text(), "7.3");
        QVERIFY(!seeds.isLocked[0] && seeds.isLocked[1] && seeds.isLocked[2]);
    }
    void faultsNameTheSeed() {
        const auto faultOf = [](const PlacedSeeds& placed) { return placed.fault().value_or(""); };
        QCOMPARE(faultOf({{{0, {0.1, 0.2}}, {3, {0.4, 0.3}}}}), "");
        QCOMPARE(faultOf({{{3, {0.1, 0.2}}, {3, {0.4, 0.3}}}}), "seed 3 does not come after seed 3");
        QCOMPARE(faultOf({{{2, {1.0, HUGE_VAL}}}}), "seed 2 is at (1, inf), which is not finite");
    }
};

RUBBLE_TEST(PlacedSeedsTest)
#include "PlacedSeedsTest.moc"
