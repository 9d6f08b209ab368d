#include "tests/support/Outlines.h"
#include "tests/support/VerifiedPartition.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

const std::vector<Vec2> kSeeds = {{1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}, {2.0, 0.25}};

/// Five cells of a square of side 4 around a hole.
Partition frame() { return verifiedPartition(squareRing(), kSeeds).value(); }

std::uint32_t pointAt(const Partition& partition, Vec2 place) {
    const auto found = std::ranges::find(partition.points, place);
    return static_cast<std::uint32_t>(found - partition.points.begin());
}

std::string faultOf(const Partition& partition) { return verifyPartition(partition, squareRing()).value_or(""); }

/// Breaks a sound partition in one way and gives what is said about it.
template <class Break>
std::string faultAfter(Break breakIt) {
    Partition partition = frame();
    breakIt(partition);
    return faultOf(partition);
}

/// A square whose middle piece touches its left and right side, so that the one around it is cut apart.
const Polygon kPlate{{{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}}, {}};
Partition pieceCutApart() {
    Partition partition;
    partition.points = {{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}, {2, 1}, {2, 3}};
    partition.seedOfPiece = {0, 1};
    partition.pieceOfSeed = {0, 1};
    partition.ringsOfPiece = {0, 2, 3};
    partition.cornersOfRing = {0, 6, 10, 14};
    partition.corners = {0, 1, 2, 3, 4, 5, 5, 7, 2, 6, 5, 6, 2, 7};
    partition.across.assign(6, kNone);
    partition.across.insert(partition.across.end(), {1, 1, 1, 1, 0, 0, 0, 0});
    return partition;
}

}  // namespace

/// A check that cannot fail is worth nothing: each breaks a sound partition in one way.
class VerifyPartitionTest : public QObject {
    Q_OBJECT
private slots:
    void aSoundPartitionPasses() {
        QCOMPARE(faultOf(frame()), std::string());
        QCOMPARE(verifyNearestSeed(frame(), kSeeds).value_or(""), std::string());
    }
    void arraysMustFit() {
        const std::string misfit = "The partition's arrays do not fit each other.";
        QCOMPARE(faultAfter([](Partition& p) { p.across.pop_back(); }), misfit);
        QCOMPARE(faultAfter([](Partition& p) { p.ringsOfPiece.back()++; }), misfit);
        QCOMPARE(faultAfter([](Partition& p) { p.cornersOfRing[1] = 1000; }), misfit);
    }
    void seedsMustKnowTheirPieces() {
        QCOMPARE(faultAfter([](Partition& p) { p.pieceOfSeed[p.seedOfPiece[2]] = kNone; }),
                 "Seed " + std::to_string(frame().seedOfPiece[2]) + " does not know its piece 2.");
    }
    void pointsMustBeThereAndFinite() {
        QCOMPARE(faultAfter([](Partition& p) { p.corners[3] = 9999; }),
                 std::string("Corner 3 names a point that is not there."));
        QCOMPARE(faultAfter([](Partition& p) {
                     p.points[p.corners[3]].x = std::numeric_limits<double>::infinity();
                 }).substr(0, 6),
                 std::string("Corner"));
    }
    void neighboursMustBeMutual() {
        const std::string fault = faultAfter([](Partition& p) {
            const auto inner = std::ranges::find_if(p.across, [](std::uint32_t piece) { return piece != kNone; });
            *inner = *inner == 0 ? 1 : 0;
        });
        QVERIFY2(fault.find("does not have the right neighbour behind its edge") != fault.npos, fault.c_str());
    }
    void aCornerInsideANeighboursEdgeIsFound() {
        // A T-junction: one side of an inner edge gets a point that the other side does not have.
        const std::string fault = faultAfter([](Partition& p) {
            std::size_t corner = 0;
            while (p.across[corner] == kNone) ++corner;
            p.points.push_back((p.points[p.corners[corner]] + p.points[p.corners[corner + 1]]) / 2.0);
            const auto at = static_cast<std::ptrdiff_t>(corner + 1);
            p.corners.insert(p.corners.begin() + at, static_cast<std::uint32_t>(p.points.size() - 1));
            p.across.insert(p.across.begin() + at, p.across[corner]);
            for (std::uint32_t& end : p.cornersOfRing) end += end > corner ? 1 : 0;
        });
        QVERIFY2(fault.find("does not have the right neighbour behind its edge") != fault.npos, fault.c_str());
    }
    void aMissingPieceIsFound() {
        const std::string fault = faultAfter([](Partition& p) {
            p.pieceOfSeed[p.seedOfPiece.back()] = kNone;
            p.seedOfPiece.pop_back();
            p.ringsOfPiece.pop_back();
            p.cornersOfRing.resize(p.ringsOfPiece.back() + 1);
            p.corners.resize(p.cornersOfRing.back());
            p.across.resize(p.corners.size());
            for (std::uint32_t& piece : p.across) piece = piece == p.pieceCount() ? kNone : piece;
        });
        QVERIFY2(!fault.empty(), fault.c_str());
    }
    void aPieceGivenTwiceIsFound() {
        const std::string fault = faultAfter([](Partition& p) {
            p.seedOfPiece.push_back(p.seedOfPiece[0]);
            for (std::uint32_t corner = 0; corner < p.cornersOfRing[1]; ++corner) {
                p.corners.push_back(p.corners[corner]);
                p.across.push_back(p.across[corner]);
            }
            p.cornersOfRing.push_back(static_cast<std::uint32_t>(p.corners.size()));
            p.ringsOfPiece.push_back(p.ringsOfPiece.back() + 1);
        });
        QVERIFY2(fault.find("repeats the edge") != fault.npos, fault.c_str());
    }
    void aMovedPointOfTheOutlineIsFound() {
        QCOMPARE(faultAfter([](Partition& p) {
                     p.points[pointAt(p, {4, 4})] = {4.0, 3.9};
                 }),
                 std::string("The pieces leave the outline behind point 1."));
        QCOMPARE(faultAfter([](Partition& p) {
                     p.points[pointAt(p, {3, 3})] = {3.0, 3.1};
                 }),
                 std::string("The pieces leave hole 0 behind point 0."));
    }
    void aPointBesideTheOutlineIsFound() {
        QCOMPARE(faultAfter([](Partition& p) {
                     p.points[pointAt(p, {4, 2})].x = 3.99;
                 }),
                 std::string("The pieces leave the outline behind point 1."));
    }
    void aRingThatRunsTheWrongWayIsFound() {
        // All rings reversed: every edge still has its reverse.
        Partition partition = verifiedPartition(unitSquare(), std::vector<Vec2>{{0.5, 0.5}}).value();
        std::ranges::reverse(partition.corners);
        const Polygon mirrored{reversed(unitSquare().outer), {}};
        QCOMPARE(verifyPartition(partition, mirrored).value_or(""),
                 std::string("Ring 0 of piece 0 runs the wrong way or has no area."));
    }
    void aWrongGapIsFound() {
        QCOMPARE(faultAfter([](Partition& p) { p.gap = 0.5; }),
                 std::string("The pieces' areas sum to 12.000000 m^2 instead of 11.500000 m^2."));
    }
    void aPieceCutApartByPointsIsFound() {
        QCOMPARE(verifyPartition(pieceCutApart(), kPlate).value_or(""),
                 std::string("Points cut piece 0 apart, one of them is 2."));
    }
    void aCornerNearerToAnotherSeedIsFound() {
        Partition partition = frame();
        partition.points[pointAt(partition, {4, 2})].y += 1e-6;
        const std::string fault = verifyNearestSeed(partition, kSeeds).value_or("");
        QVERIFY2(fault.find("has a corner that is nearer to another seed than to seed") != fault.npos, fault.c_str());
    }
    void piecesNamedAfterEachOthersSeedsAreFound() {
        Partition partition = frame();
        std::swap(partition.seedOfPiece[0], partition.seedOfPiece[1]);
        QVERIFY(verifyNearestSeed(partition, kSeeds).has_value());
    }
    void aForgottenSeedIsFound() {
        std::vector<Vec2> seeds = kSeeds;
        seeds.push_back({2.0, 3.5});
        QVERIFY(verifyNearestSeed(frame(), seeds).has_value());
    }
};

QTEST_APPLESS_MAIN(VerifyPartitionTest)
#include "VerifyPartitionTest.moc"
