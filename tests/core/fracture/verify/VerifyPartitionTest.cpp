// Tests core/fracture/verify/VerifyPartition.cpp and core/fracture/verify/VerifyNearestSeed.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

const std::vector<Vec2> kFrameSeeds = {{1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}, {2.0, 0.25}};

/// Five cells of a square of side 4 around a hole.
Partition frame() { return verifiedPartition(squareRing(), kFrameSeeds).value(); }

std::uint32_t pointAt(const Partition& partition, Vec2 place) {
    const auto found = std::ranges::find(partition.points, place);
    return static_cast<std::uint32_t>(found - partition.points.begin());
}

std::string frameFault(const Partition& partition) { return verifyPartition(partition, squareRing()).value_or(""); }

/// The fault that is found after a valid partition is damaged.
template <class Break>
std::string frameFaultAfter(Break breakIt) {
    Partition partition = frame();
    breakIt(partition);
    return frameFault(partition);
}

/// A square whose central piece touches its left and right side, so that the piece around it is disconnected.
const Polygon kPlate{{{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}}, {}};
Partition pieceCutApart() {
    Partition partition;
    partition.points = {{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}, {2, 1}, {2, 3}};
    partition.seedOfPiece = {0, 1};
    partition.pieceOfSeed = {0, 1};
    partition.ringsOfPiece = {0, 2, 3};
    partition.cornersOfRing = {0, 6, 10, 14};
    partition.corners = {0, 1, 2, 3, 4, 5, 5, 7, 2, 6, 5, 6, 2, 7};
    partition.neighbours.assign(6, kNone);
    partition.neighbours.insert(partition.neighbours.end(), {1, 1, 1, 1, 0, 0, 0, 0});
    return partition;
}

}  // namespace

/// Each test damages a valid partition in one way, which must be found.
class VerifyPartitionTest : public QObject {
    Q_OBJECT
private slots:
    void validPartitionPasses() {
        QCOMPARE(frameFault(frame()), std::string());
        QCOMPARE(verifyNearestSeed(frame(), kFrameSeeds).value_or(""), std::string());
    }
    void mismatchedArraysAreFound() {
        const std::string misfit = "The sizes of the partition's arrays do not match.";
        QCOMPARE(frameFaultAfter([](Partition& p) { p.neighbours.pop_back(); }), misfit);
        QCOMPARE(frameFaultAfter([](Partition& p) { p.ringsOfPiece.back()++; }), misfit);
        QCOMPARE(frameFaultAfter([](Partition& p) { p.cornersOfRing[1] = 1000; }), misfit);
    }
    void wrongPieceOfSeedIsFound() {
        QCOMPARE(frameFaultAfter([](Partition& p) { p.pieceOfSeed[p.seedOfPiece[2]] = kNone; }),
                 "Seed " + std::to_string(frame().seedOfPiece[2]) + " does not refer to its piece 2.");
    }
    void invalidPointsAreFound() {
        QCOMPARE(frameFaultAfter([](Partition& p) { p.corners[3] = 9999; }),
                 std::string("Corner 3 refers to a point that does not exist."));
        QCOMPARE(frameFaultAfter([](Partition& p) {
                     p.points[p.corners[3]].x = std::numeric_limits<double>::infinity();
                 }).substr(0, 6),
                 std::string("Corner"));
    }
    void wrongNeighbourIsFound() {
        const std::string fault = frameFaultAfter([](Partition& p) {
            const auto inner = std::ranges::find_if(p.neighbours, [](std::uint32_t piece) { return piece != kNone; });
            *inner = *inner == 0 ? 1 : 0;
        });
        QVERIFY2(fault.find("does not have the right neighbour behind its edge") != fault.npos, fault.c_str());
    }
    void cornerInsideANeighboursEdgeIsFound() {
        // A T-junction: one side of an inner edge gets a point that the other side does not have.
        const std::string fault = frameFaultAfter([](Partition& p) {
            std::size_t corner = 0;
            while (p.neighbours[corner] == kNone) ++corner;
            p.points.push_back((p.points[p.corners[corner]] + p.points[p.corners[corner + 1]]) / 2.0);
            const auto at = static_cast<std::ptrdiff_t>(corner + 1);
            p.corners.insert(p.corners.begin() + at, static_cast<std::uint32_t>(p.points.size() - 1));
            p.neighbours.insert(p.neighbours.begin() + at, p.neighbours[corner]);
            for (std::uint32_t& end : p.cornersOfRing) end += end > corner ? 1 : 0;
        });
        QVERIFY2(fault.find("does not have the right neighbour behind its edge") != fault.npos, fault.c_str());
    }
    void missingPieceIsFound() {
        const std::string fault = frameFaultAfter([](Partition& p) {
            p.pieceOfSeed[p.seedOfPiece.back()] = kNone;
            p.seedOfPiece.pop_back();
            p.ringsOfPiece.pop_back();
            p.cornersOfRing.resize(p.ringsOfPiece.back() + 1);
            p.corners.resize(p.cornersOfRing.back());
            p.neighbours.resize(p.corners.size());
            for (std::uint32_t& piece : p.neighbours) piece = piece == p.pieceCount() ? kNone : piece;
        });
        QVERIFY2(!fault.empty(), fault.c_str());
    }
    void duplicatePieceIsFound() {
        const std::string fault = frameFaultAfter([](Partition& p) {
            p.seedOfPiece.push_back(p.seedOfPiece[0]);
            for (std::uint32_t corner = 0; corner < p.cornersOfRing[1]; ++corner) {
                p.corners.push_back(p.corners[corner]);
                p.neighbours.push_back(p.neighbours[corner]);
            }
            p.cornersOfRing.push_back(static_cast<std::uint32_t>(p.corners.size()));
            p.ringsOfPiece.push_back(p.ringsOfPiece.back() + 1);
        });
        QVERIFY2(fault.find("repeats the edge") != fault.npos, fault.c_str());
    }
    void movedOutlinePointIsFound() {
        QCOMPARE(frameFaultAfter([](Partition& p) {
                     p.points[pointAt(p, {4, 4})] = {4.0, 3.9};
                 }),
                 std::string("The pieces leave the outline after point 1."));
        QCOMPARE(frameFaultAfter([](Partition& p) {
                     p.points[pointAt(p, {3, 3})] = {3.0, 3.1};
                 }),
                 std::string("The pieces leave hole 0 after point 0."));
    }
    void pointBesideTheOutlineIsFound() {
        QCOMPARE(frameFaultAfter([](Partition& p) {
                     p.points[pointAt(p, {4, 2})].x = 3.99;
                 }),
                 std::string("The pieces leave the outline after point 1."));
    }
    void wrongWindingIsFound() {
        // All rings reversed: every edge still has its reverse.
        Partition partition = verifiedPartition(unitSquare(), std::vector<Vec2>{{0.5, 0.5}}).value();
        std::ranges::reverse(partition.corners);
        const Polygon mirrored{reversed(unitSquare().outer), {}};
        QCOMPARE(verifyPartition(partition, mirrored).value_or(""),
                 std::string("Ring 0 of piece 0 has the wrong winding or no area."));
    }
    void wrongGapIsFound() {
        QCOMPARE(frameFaultAfter([](Partition& p) { p.gap = 0.5; }),
                 std::string("The pieces' areas sum to 12 m² instead of 11.5 m²."));
    }
    void pieceDisconnectedByPointsIsFound() {
        QCOMPARE(verifyPartition(pieceCutApart(), kPlate).value_or(""),
                 std::string("Piece 0 is disconnected by points, one of them is 2."));
    }
    void cornerNearerToAnotherSeedIsFound() {
        Partition partition = frame();
        partition.points[pointAt(partition, {4, 2})].y += 1e-6;
        const std::string fault = verifyNearestSeed(partition, kFrameSeeds).value_or("");
        QVERIFY2(fault.find("has a corner that is nearer to another seed than to seed") != fault.npos, fault.c_str());
    }
    void swappedSeedsAreFound() {
        Partition partition = frame();
        std::swap(partition.seedOfPiece[0], partition.seedOfPiece[1]);
        QVERIFY(verifyNearestSeed(partition, kFrameSeeds).has_value());
    }
    void ignoredSeedIsFound() {
        std::vector<Vec2> seeds = kFrameSeeds;
        seeds.push_back({2.0, 3.5});
        QVERIFY(verifyNearestSeed(frame(), seeds).has_value());
    }
};

RUBBLE_TEST(VerifyPartitionTest)
#include "VerifyPartitionTest.moc"
