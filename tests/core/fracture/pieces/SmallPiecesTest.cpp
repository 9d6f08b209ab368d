#include "core/fracture/pieces/SmallPieces.h"

#include "core/fracture/verify/VerifyPartition.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

using namespace rubble;

namespace {

/// Strips of the unit square, divided at these x.
Partition stripsAround(const std::vector<double>& middles) {
    std::vector<Vec2> seeds;
    for (const double x : middles) seeds.push_back({x, 0.5});
    return *voronoiPartition(unitSquare(), seeds);
}

std::vector<double> areasBySeed(const Partition& partition) {
    std::vector<double> areas(partition.pieceOfSeed.size());
    for (std::uint32_t k = 0; k < partition.pieceCount(); ++k)
        areas[partition.seedOfPiece[k]] += pieceArea(partition, k);
    return areas;
}

double smallestOf(const Partition& partition) {
    double smallest = 1e300;
    for (std::uint32_t k = 0; k < partition.pieceCount(); ++k) smallest = std::min(smallest, pieceArea(partition, k));
    return smallest;
}

}  // namespace

class SmallPiecesTest : public QObject {
    Q_OBJECT
private slots:
    void smallestPieceMergesAlongTheLongestSharedEdge() {
        // Cells [0, 0.375], [0.375, 0.5625], [0.5625, 1]: the middle one is merged into the first of equal neighbours.
        const Partition merged =
            withoutSmallPieces(stripsAround({0.25, 0.5, 0.625}), {SmallPieceRule::Merge, PieceMeasure::Area, 0.2}, 1.0);
        QCOMPARE(merged.pieceCount(), 2u);
        QCOMPARE(merged.pieceOfSeed[1], kNone);
        QCOMPARE(merged.diagnostics.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(merged.diagnostics[0].message),
                 QString("The cell of seed 1 is too small (0.1875 m²); it is merged into the cell of seed 0."));
        QVERIFY(std::abs(areasBySeed(merged)[0] - 0.5625) < 1e-12);
        QVERIFY(!verifyPartition(merged, unitSquare()));
    }
    void limitIsAreaVolumeOrFraction_data() {
        QTest::addColumn<int>("measure");
        QTest::addColumn<double>("limit");
        QTest::addColumn<double>("area");
        QTest::newRow("area") << int(PieceMeasure::Area) << 0.25 << 0.25;
        QTest::newRow("volume") << int(PieceMeasure::Volume) << 0.25 << 0.125;
        QTest::newRow("part of mean") << int(PieceMeasure::FractionOfMean) << 0.25 << 0.2;
        QTest::newRow("part of whole") << int(PieceMeasure::FractionOfWhole) << 0.25 << 1.0;
    }
    void limitIsAreaVolumeOrFraction() {
        QFETCH(int, measure);
        QFETCH(double, limit);
        QFETCH(double, area);
        const SmallPieces small{SmallPieceRule::Merge, PieceMeasure(measure), limit};
        QCOMPARE(minPieceArea(small, 4.0, 5, 2.0), area);
        QCOMPARE(minPieceArea({SmallPieceRule::Keep, PieceMeasure(measure), limit}, 4.0, 5, 2.0), 0.0);
    }
    void atLeastOnePieceRemains() {
        const Partition merged =
            withoutSmallPieces(stripsAround({0.1, 0.5, 0.7}), {SmallPieceRule::Merge, PieceMeasure::Area, 100.0}, 1.0);
        QCOMPARE(merged.pieceCount(), 1u);
        QCOMPARE(merged.diagnostics.size(), std::size_t{2});
        QVERIFY(!verifyPartition(merged, unitSquare()));
    }
    void partsOfACellKeepTheirNumbers() {
        // Seed 0 has a part on either arm of the L; the remaining part keeps its name.
        const Polygon ell{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
        const Partition apart = *voronoiPartition(ell, std::vector<Vec2>{{3, 2}, {0, 0}});
        QCOMPARE(apart.pieceCount(), 3u);
        const Partition merged = withoutSmallPieces(apart, {SmallPieceRule::Merge, PieceMeasure::Area, 0.2}, 1.0);
        QCOMPARE(merged.pieceCount(), 2u);
        QCOMPARE(partOfCell(merged, merged.pieceOfSeed[0]), 1u);
        QCOMPARE(partOfCell(merged, merged.pieceOfSeed[1]), kNone);
        QVERIFY(!verifyPartition(merged, ell));
    }
    /// No piece below the limit is left, no area is lost, and each merged piece is reported with its receiver.
    void randomPartitionsKeepNoSmallPieces() {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 3));
            const auto measure = static_cast<PieceMeasure>(random.below(4));
            const SmallPieces small{SmallPieceRule::Merge, measure, random.between(0.001, 0.6)};
            const Partition merged = withoutSmallPieces(made.partition, small, 0.5);
            const auto fault = verifyPartition(merged, made.outline);
            QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            const double least = minPieceArea(small, area(made.outline), merged.pieceCount(), 0.5);
            QVERIFY2(merged.pieceCount() == 1 || smallestOf(merged) >= least * (1.0 - 1e-9),
                     qPrintable(faultOfSeed(seed, "small")));

            std::vector<double> areas = areasBySeed(made.partition);
            for (const Diagnostic& report : merged.diagnostics) {
                if (report.code != DiagnosticCode::MergedPiece) continue;
                areas[report.place.seed] -= report.value;
                areas[report.place.otherSeed] += report.value;
            }
            const std::vector<double> now = areasBySeed(merged);
            for (std::size_t k = 0; k < areas.size(); ++k) {
                QVERIFY2(std::abs(areas[k] - now[k]) < 1e-9,
                         qPrintable(faultOfSeed(seed, "area of " + std::to_string(k))));
            }
            if (merged.pieceCount() < made.partition.pieceCount()) ++m_merged;
        }
        QVERIFY(m_merged > 1500);
    }
    void droppingSeedsTerminates() {
        for (std::uint64_t seed = 0; seed < 500; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 3));
            const SmallPieces small{SmallPieceRule::DropSeeds, PieceMeasure::FractionOfMean, random.between(0.1, 1.0)};
            std::vector<Vec2> seeds = made.seeds;
            Partition partition = made.partition;
            for (std::vector<std::uint32_t> dropped = seedsToDrop(partition, small, 1.0); !dropped.empty();
                 dropped = seedsToDrop(partition, small, 1.0)) {
                QVERIFY2(dropped.size() < seeds.size(), qPrintable(faultOfSeed(seed, "no seed is left")));
                for (std::size_t k = dropped.size(); k-- > 0;) seeds.erase(seeds.begin() + dropped[k]);
                partition = *voronoiPartition(made.outline, seeds);
            }
            const auto cells = static_cast<std::uint32_t>(
                std::ranges::count_if(partition.pieceOfSeed, [](std::uint32_t piece) { return piece != kNone; }));
            for (const double cell : areasBySeed(partition)) {
                const bool isEnough = cell == 0.0 || cells == 1 ||
                                      cell >= minPieceArea(small, area(made.outline), cells, 1.0) * (1 - 1e-9);
                QVERIFY2(isEnough, qPrintable(faultOfSeed(seed, "a small cell")));
            }
        }
    }

private:
    int m_merged = 0;
};

RUBBLE_TEST(SmallPiecesTest)
#include "SmallPiecesTest.moc"
