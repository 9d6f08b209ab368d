#include "core/fracture/layer/LayerContext.h"

#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

const Polygon kSquare = unitSquare();
const TaskContext kTask;

LayerContext layer(std::uint32_t id) {
    return {{.layerId = id, .randomSeed = 3, .overrides = {}, .task = kTask}, kSquare};
}

}  // namespace

class LayerContextTest : public QObject {
    Q_OBJECT
private slots:
    void removalKeepsTheOrderOfTheOthers() {
        SeedSet seeds;
        for (std::uint32_t k = 0; k < 5; ++k) seeds.add({1, k}, {static_cast<double>(k), 0.0}, k == 4);
        seeds.remove(1, {true, false, true, false});
        QCOMPARE(seeds.positions, (std::vector<Vec2>{{0, 0}, {2, 0}, {4, 0}}));
        QCOMPARE(seeds.ids[1].index, 2u);
        QCOMPARE(seeds.isLocked, (std::vector<bool>{false, false, true}));
    }
    void layersAndElementsHaveTheirOwnRandomNumbers() {
        QCOMPARE(layer(4).name(), "Layer 4");
        QCOMPARE(layer(4).random().unit(), layer(4).random().unit());
        QVERIFY(layer(4).random().unit() != layer(5).random().unit());
        QVERIFY(layer(4).randomOf(0).unit() != layer(4).randomOf(1).unit());
        QVERIFY(layer(4).randomOf(0).unit() != layer(4).random().unit());
    }
    void countIsTakenOfTheDomain() {
        SeedSet seeds;
        QCOMPARE(*seedsToAdd({CountBy::Density, 8.0}, {rectangle({0, 0}, {2, 2}), {}}, layer(4), seeds), 32u);
    }
    void seedsOfEarlierLayersCountForTheLimit() {
        SeedSet seeds;
        for (std::uint32_t k = 0; k < 3; ++k) seeds.add({1, k}, {0.0, 0.0}, false);
        const Polygon domain = unitSquare();
        QCOMPARE(*seedsToAdd(SeedCount{kMaxSeeds - 3}, domain, layer(4), seeds), kMaxSeeds - 3);
        QCOMPARE(errorText(seedsToAdd(SeedCount{kMaxSeeds - 2}, domain, layer(4), seeds)),
                 "Layer 4 brings the pattern above 10000000 seeds.");
    }
    void scatterAddsPointsUntilCancelled() {
        struct Corner {
            Vec2 point(Random&) const { return {1.0, 2.0}; }
        };
        SeedSet seeds;
        QVERIFY(scatter(4, Corner{}, layer(4), seeds));
        QCOMPARE(seeds.ids[3].text(), "4.3");
        QCOMPARE(seeds.positions[3], Vec2(1.0, 2.0));
        TaskContext cancelled;
        cancelled.cancel.cancel();
        const LayerContext context{{.layerId = 4, .randomSeed = 3, .overrides = {}, .task = cancelled}, kSquare};
        QCOMPARE(scatter(4, Corner{}, context, seeds).error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(LayerContextTest)
#include "LayerContextTest.moc"
