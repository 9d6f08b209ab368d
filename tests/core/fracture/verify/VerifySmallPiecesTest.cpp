#include "core/fracture/verify/VerifySmallPieces.h"

#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr SmallPieces areaOfAtLeast(double limit) { return {SmallPieceRule::Merge, PieceMeasure::Area, limit}; }

/// A strip of 0.25 m² and one of 0.75 m².
Partition strips() { return *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.125, 0.5}, {0.375, 0.5}}); }

}  // namespace

class VerifySmallPiecesTest : public QObject {
    Q_OBJECT
private slots:
    void pieceBelowTheLimitIsNamed() {
        const std::string small = std::to_string(strips().pieceOfSeed[0]);
        QCOMPARE(verifyNoSmallPieces(strips(), areaOfAtLeast(0.5), 1.0).value_or(""),
                 "Piece " + small + " has 0.25 m², less than the 0.5 m² that it must have.");
        QVERIFY(verifyNoSmallPieces(strips(), {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.6}, 1.0));
        QVERIFY(!verifyNoSmallPieces(strips(), {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.4}, 1.0));
    }
    void limitItselfIsAllowed() {
        QVERIFY(!verifyNoSmallPieces(strips(), areaOfAtLeast(0.25), 1.0));
        QVERIFY(!verifyNoSmallPieces(strips(), areaOfAtLeast(0.25 * (1.0 + 1e-10)), 1.0));
        QVERIFY(verifyNoSmallPieces(strips(), areaOfAtLeast(0.25 * (1.0 + 1e-8)), 1.0));
    }
    void keptPiecesMayHaveAnySize() {
        QVERIFY(!verifyNoSmallPieces(strips(), {SmallPieceRule::Keep, PieceMeasure::Area, 0.5}, 1.0));
    }
    void onlyPieceMayHaveAnySize() {
        const Partition whole = *voronoiPartition(unitSquare(), std::vector<Vec2>{});
        QVERIFY(!verifyNoSmallPieces(whole, areaOfAtLeast(100.0), 1.0));
    }
};

RUBBLE_TEST(VerifySmallPiecesTest)
#include "VerifySmallPiecesTest.moc"
