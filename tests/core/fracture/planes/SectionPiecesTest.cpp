#include "core/fracture/planes/SectionPieces.h"

#include "core/fracture/solid/SolidCut.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <algorithm>

using namespace rubble;
using namespace rubble::test;

class SectionPiecesTest : public QObject {
    Q_OBJECT
private slots:
    /// Pieces have the area of what is cut, meet edge by edge, and have the seeds of their fragments.
    void piecesAreAPartitionOfTheSection() {
        for (const TriangleMesh& mesh : {bumpySphere(24), torus(40, 16)}) {
            const SolidPartition solid = *cutSolid(mesh, seedsInBox(mesh, 60, 5));
            const Box3 box = boundsOf(mesh);
            for (int axis = 0; axis < 3; ++axis) {
                const SolidSection section =
                    sectionOf(solid, sectionPlane(axis, 0.4 * box.min[axis] + 0.6 * box.max[axis]));
                const SectionPieces pieces = sectionPieces(section, solid, true);
                double sum = 0.0;
                for (const double area : pieceAreas(pieces.partition)) sum += area;
                QVERIFY(std::abs(sum - section.area) < 1e-12);
                QVERIFY(std::ranges::is_sorted(pieces.seeds));
                QCOMPARE(pieces.partition.pieceOfSeed.size(), pieces.seeds.size());
                std::uint32_t piece = 0, shared = 0;
                for (const SolidSection::Part& part : section.parts) {
                    for (std::size_t k = 0; k < part.polygons.size(); ++k, ++piece)
                        QCOMPARE(pieces.seeds[pieces.partition.seedOfPiece[piece]],
                                 solid.seedOfFragment[part.fragment]);
                }
                QCOMPARE(piece, pieces.partition.pieceCount());
                for (piece = 0; piece < pieces.partition.pieceCount(); ++piece) {
                    forEachEdge(pieces.partition, piece, [&](std::uint32_t a, std::uint32_t b, std::uint32_t other) {
                        if (other == kNone) return;
                        ++shared;
                        QVERIFY(hasEdge(pieces.partition, other, {b, a}));
                    });
                }
                QVERIFY(shared > 20);
            }
        }
    }
    void withoutSeedsPiecesHaveNone() {
        const TriangleMesh mesh = cubes({{0, 0, 0}});
        const SolidPartition solid = *cutSolid(mesh, seedsInBox(mesh, 1, 1));
        const SectionPieces pieces = sectionPieces(sectionOf(solid, sectionPlane(1, 0.5)), solid, false);
        QCOMPARE(pieces.partition.pieceCount(), 1u);
        QCOMPARE(pieces.partition.seedOfPiece[0], kNone);
        QVERIFY(pieces.seeds.empty() && pieces.partition.pieceOfSeed.empty());
    }
};

RUBBLE_TEST(SectionPiecesTest)
#include "SectionPiecesTest.moc"
