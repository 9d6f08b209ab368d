// Tests core/fracture/pieces/PieceDraft.cpp, core/fracture/pieces/PieceMerge.cpp and
// core/fracture/pieces/PieceSplit.cpp.
#include "core/fracture/pieces/PieceDraft.h"

#include "core/fracture/verify/VerifyPartition.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

#include <numeric>

using namespace rubble;

class PieceDraftTest : public QObject {
    Q_OBJECT
private slots:
    void unchangedDraftGivesTheSamePieces() {
        const Partition before = *voronoiPartition(lShape(), std::vector<Vec2>{{2, 2}, {0, 0}});
        const Partition same = PieceDraft(before).finished();
        QCOMPARE(same.corners, before.corners);
        QCOMPARE(same.neighbours, before.neighbours);
        QCOMPARE(same.pieceOfSeed, before.pieceOfSeed);
        for (std::uint32_t piece = 0; piece < 3; ++piece) QCOMPARE(partOfCell(same, piece), partOfCell(before, piece));
    }
    void squareIsSplitInTwo() {
        PieceDraft draft(*voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}}));
        QCOMPARE(draft.split(0, {{0.0, 0.5}, {1.0, 0.0}}), 2u);
        QCOMPARE(draft.count(), 3u);
        const Partition split = std::move(draft).finished();
        QVERIFY(!verifyPartition(split, unitSquare()));
        QCOMPARE(split.seedOfPiece, (UninitializedVector<std::uint32_t>{0, 0, 1}));
        QCOMPARE(split.partOfCell, (UninitializedVector<std::uint32_t>{0, 1, kNone}));
        QCOMPARE(pieceArea(split, 0), 0.25);
        QCOMPARE(pieceArea(split, 1), 0.25);
    }
    void lineOutsideSplitsNothing() {
        PieceDraft draft(*voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}}));
        QCOMPARE(draft.split(0, {{0.9, 0.0}, {0.0, 1.0}}), 1u);
        QCOMPARE(std::move(draft).finished().pieceCount(), 2u);
    }
    void lineThroughCornersIsMovedAside() {
        PieceDraft draft(*voronoiPartition(unitSquare(), std::vector<Vec2>{{0.5, 0.5}}));
        QCOMPARE(draft.split(0, {{0.0, 0.0}, {1.0, 1.0}}), 2u);
        const Partition split = std::move(draft).finished();
        QVERIFY(!verifyPartition(split, unitSquare()));
        QVERIFY(std::abs(pieceArea(split, 0) - 0.5) < 1e-11);
    }
    void ringIsSplitIntoHalves() {
        PieceDraft draft(*voronoiPartition(squareRing(), std::vector<Vec2>{{2.0, 2.0}}));
        QCOMPARE(draft.split(0, {{2.0, 2.0}, {0.0, 3.0}}), 2u);
        const Partition split = std::move(draft).finished();
        QVERIFY(!verifyPartition(split, squareRing()));
        QCOMPARE(pieceArea(split, 0), 6.0);
    }
    void mergedCellsAroundACellMakeARing() {
        std::vector<Vec2> seeds;
        for (int k = 0; k < 9; ++k) seeds.push_back({0.5 + k % 3, 0.5 + k / 3});
        const Polygon outline{rectangle({0, 0}, {3, 3}), {}};
        const Partition cells = *voronoiPartition(outline, seeds);
        std::vector<std::uint32_t> receivers(9, cells.pieceOfSeed[0]);
        receivers[cells.pieceOfSeed[4]] = cells.pieceOfSeed[4];
        PieceDraft draft(cells);
        draft.merge(receivers);
        const Partition merged = std::move(draft).finished();
        QCOMPARE(merged.pieceCount(), 2u);
        QVERIFY(!verifyPartition(merged, outline));
        QCOMPARE(pieceOutline(merged, merged.pieceOfSeed[0]).holes.size(), std::size_t{1});
    }
    /// Random merges and splits of random partitions keep one planar subdivision without losses.
    void randomDraftsStayPlanar() {
        int splits = 0, merges = 0;
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 3));
            PieceDraft draft(made.partition);
            for (int round = 0; round < 6; ++round) {
                const auto piece = static_cast<std::uint32_t>(random.below(draft.count()));
                const auto other = static_cast<std::uint32_t>(random.below(draft.count()));
                if (!draft.exists(piece)) continue;
                if (round % 2 == 0) {
                    const Vec2 at = made.seeds[random.below(made.seeds.size())];
                    const Vec2 direction{random.between(-1.0, 1.0), random.between(0.1, 1.0)};
                    if (draft.split(piece, {at, direction}) > 1) ++splits;
                } else if (piece != other && draft.exists(other) && draft.areNeighbours(piece, other)) {
                    std::vector<std::uint32_t> receivers(draft.count());
                    std::iota(receivers.begin(), receivers.end(), 0u);
                    receivers[other] = piece;
                    draft.merge(receivers);
                    ++merges;
                }
            }
            const Partition partition = std::move(draft).finished();
            const auto fault = verifyPartition(partition, made.outline);
            QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
        }
        QVERIFY(splits > 1500);
        QVERIFY(merges > 500);
    }
};

RUBBLE_TEST(PieceDraftTest)
#include "PieceDraftTest.moc"
