#include "core/fracture/partition/EdgeIndex.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

using namespace rubble;

class EdgeIndexTest : public QObject {
    Q_OBJECT
private slots:
    void edgesHaveADirectionAndAGroup() {
        const Partition halves = *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}});
        EdgeIndex index;
        index.add(halves, {.group = 5, .piece = 0});
        index.sort();
        const std::uint32_t from = halves.corners[0], to = halves.corners[1];
        QCOMPARE(index.find(5, {from, to}), 0u);
        QCOMPARE(index.find(5, {to, from}), kNone);
        QCOMPARE(index.find(4, {from, to}), kNone);
        QCOMPARE(index.find(6, {from, to}), kNone);
    }
    void edgeOfTheWholeGroupIsFoundInItsPiece() {
        for (std::uint64_t number = 1; number <= 100; ++number) {
            Random random(number);
            const Partition partition = test::randomPartition(random, static_cast<int>(number % 3)).partition;
            EdgeIndex index;
            for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece)
                index.add(partition, {.group = piece % 2, .piece = piece});
            index.sort();
            for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
                forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                    QVERIFY2(index.find(piece % 2, {from, to}) == piece, qPrintable(faultOfSeed(number, "own")));
                    if (neighbour == kNone) return;
                    QVERIFY2(index.find(neighbour % 2, {to, from}) == neighbour,
                             qPrintable(faultOfSeed(number, "other")));
                });
            }
        }
    }
};

RUBBLE_TEST(EdgeIndexTest)
#include "EdgeIndexTest.moc"
