#include "core/asset/bake/BakeEstimate.h"

#include "core/asset/bake/Bake.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

constexpr qint64 kAtOnce = 1000;  // ms, on any machine; such bakes would take minutes

/// A box of 1 x 1 x 0.5 m with a number of seeds in each of a number of levels.
Asset layered(std::uint32_t seeds, std::size_t levels, double minimumVolume = 0.0) {
    Asset asset = boxAsset(2, 3, UniformScatter{.count = seeds});
    for (std::size_t k = 1; k < levels; ++k) {
        const PatternLayer layer{.id = static_cast<Id>(10 + k), .parameters = UniformScatter{.count = seeds}};
        asset.levels.push_back({.pattern = {{layer}}, .minimumVolume = minimumVolume});
    }
    return asset;
}

}  // namespace
Q_DECLARE_METATYPE(LayerParameters)

class BakeEstimateTest : public QObject {
    Q_OBJECT
private slots:
    void estimateIsTheNumberOfFragments_data() {
        QTest::addColumn<std::uint32_t>("seeds");
        QTest::addColumn<int>("levels");
        for (const std::uint32_t seeds : {1u, 2u, 7u, 30u}) {
            for (const int levels : {1, 2, 3}) QTest::addRow("%u seeds, %d levels", seeds, levels) << seeds << levels;
        }
    }
    void estimateIsTheNumberOfFragments() {
        QFETCH(std::uint32_t, seeds);
        QFETCH(int, levels);
        const Asset asset = layered(seeds, static_cast<std::size_t>(levels));
        const Result<Bake> made = bake(asset);
        QVERIFY(made);
        const BakeEstimate estimate = estimateOf(asset);
        QCOMPARE(estimate.fragments, static_cast<double>(made->fragmentCount()));
        QCOMPARE(estimate.fractures, static_cast<double>(made->fractures.size()));
    }
    void kindsOfLayersAreEstimatedWithinAHalf_data() {
        QTest::addColumn<LayerParameters>("layer");
        QTest::newRow("density") << LayerParameters(UniformScatter{.count = {CountBy::Density, 300.0}});
        QTest::newRow("size") << LayerParameters(UniformScatter{.count = {CountBy::PieceSize, 0.1}});
        QTest::newRow("blue noise") << LayerParameters(BlueNoise{.minimumDistance = 0.05});
        QTest::newRow("grid") << LayerParameters(JitteredGrid{.columns = 9, .rows = 7});
        QTest::newRow("grid of a size") << LayerParameters(
            JitteredGrid{.cells = GridCells::Size, .cellWidth = 0.1, .cellHeight = 0.05});
        QTest::newRow("lattice") << LayerParameters(HexagonalLattice{.spacing = 0.07});
        QTest::newRow("bricks") << LayerParameters(BrickBond{.length = 0.1, .width = 0.05, .height = 0.04});
    }
    void kindsOfLayersAreEstimatedWithinAHalf() {
        QFETCH(LayerParameters, layer);
        const Asset asset = boxAsset(2, 3, layer);
        const Result<Bake> made = bake(asset);
        QVERIFY(made);
        const double ratio = estimateOf(asset).fragments / made->fragmentCount();
        QVERIFY2(ratio > 0.5 && ratio < 2.0, QByteArray::number(ratio));
    }
    void thirtyLevelsOfTwoSeedsAreRefusedAtOnce() {
        QElapsedTimer watch;
        watch.start();
        const Result<Bake> made = bake(layered(2, 30));
        QVERIFY(watch.elapsed() < kAtOnce);
        QCOMPARE(made.error().code, ErrorCode::Limit);
        QCOMPARE(made.error().message,
                 std::string("Asset \"box\": about 2147483646 fragments would take 4520 GiB of memory; at most 2 GiB "
                             "are allowed. Use fewer seeds or levels, or a larger minimum volume."));
    }
    void tenMillionSeedsAreRefusedAtOnce() {
        QElapsedTimer watch;
        watch.start();
        const Result<Bake> made = bake(layered(10'000'000, 1));
        QVERIFY(watch.elapsed() < kAtOnce);
        QCOMPARE(made.error().code, ErrorCode::Limit);
        QVERIFY(made.error().message.starts_with("Asset \"box\": about 10000000 fragments would take 2.4 GiB"));
    }
    void minimumVolumeBoundsTheLevels() {
        // 0.5 m³ in fragments of at least 1 dm³: at most 500 of a level are fractured.
        QVERIFY(!sizeFault(estimateOf(layered(2, 30, 1e-3))));
        QVERIFY(bake(layered(2, 30, 1e-3)));
    }
    void settingsOfFragmentsCountFromLevelToLevel() {
        Asset asset = layered(2, 1);
        const PatternLayer layer{.id = 20, .parameters = UniformScatter{.count = 9'000'000}};
        asset.leaves = {{"3.0", Level{.pattern = {{layer}}}}};
        QVERIFY(!sizeFault(estimateOf(asset)));
        QElapsedTimer watch;
        watch.start();
        QCOMPARE(bake(asset).error().code, ErrorCode::Limit);
        QVERIFY(watch.elapsed() < kAtOnce);
    }
};

RUBBLE_TEST(BakeEstimateTest)
#include "BakeEstimateTest.moc"
