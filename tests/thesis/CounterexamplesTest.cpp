// Tests core/fracture/voronoi/VoronoiPartition.cpp on the cases in which app/thesis/ThesisMethod.cpp fails.
#include "app/thesis/ThesisMethod.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"
#include "tests/support/fracture/VerifiedPartition.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr double kAreaTolerance = 1e-13;  // of an area: a cell's few roundings

/// The neighbours of each seed's cell, ascending.
std::vector<std::vector<std::uint32_t>> neighboursOf(const Partition& partition, double least) {
    std::vector<std::vector<std::uint32_t>> neighbours(partition.pieceOfSeed.size());
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        std::vector<std::uint32_t>& list = neighbours[partition.seedOfPiece[piece]];
        for (const PieceContact& contact : contactsOf(partition, piece, least)) {
            list.push_back(partition.seedOfPiece[contact.piece]);
        }
        std::ranges::sort(list);
    }
    return neighbours;
}

/// Whether the thesis method gives every cell its area, up to a thousandth.
bool isRightByThesisMethod(const test::Counterexample& example) {
    const ThesisDiagram diagram = thesisDiagram(example.outline.outer, example.seeds);
    for (std::size_t seed = 0; seed < example.areas.size(); ++seed) {
        const double area = std::abs(signedArea(diagram.cells[seed]));
        if (!(std::abs(area / example.areas[seed] - 1.0) < 1e-3)) return false;
    }
    return true;
}

}  // namespace

/// Small cases in which the thesis method fails.
class CounterexamplesTest : public QObject {
    Q_OBJECT
private slots:
    void fileHasEighteenCases() { QCOMPARE(test::counterexamples().size(), std::size_t{18}); }
    void cellsHaveTheExpectedAreas_data() {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const test::Counterexample& example : test::counterexamples()) {
            QTest::newRow(example.name.c_str()) << index++;
        }
    }
    void cellsHaveTheExpectedAreas() {
        QFETCH(int, index);
        const test::Counterexample example = test::counterexamples()[static_cast<std::size_t>(index)];
        const Result<Partition> partition = verifiedPartition(example.outline, example.seeds);
        QVERIFY2(partition.hasValue(), partition ? "" : partition.error().message.c_str());
        for (std::uint32_t seed = 0; seed < example.areas.size(); ++seed) {
            const double area = areaOfSeed(*partition, seed), exact = example.areas[seed];
            QVERIFY2(std::abs(area - exact) <= kAreaTolerance * exact,
                     qPrintable(QString("seed %1: %2 for %3").arg(seed).arg(area, 0, 'g', 17).arg(exact, 0, 'g', 17)));
        }
        const double least = kMinSharedEdge * boundsOf(example.outline.outer).diagonal();
        QCOMPARE(neighboursOf(*partition, least), example.neighbours);
        QVERIFY(partition->diagnostics.empty());
    }
    void thesisMethodIsRightInOneCase() {
        for (const test::Counterexample& example : test::counterexamples()) {
            // Four seeds on a circle around the square's centre: all rays point outwards and are long enough.
            QVERIFY2(isRightByThesisMethod(example) == (example.name == "R12_square4"), example.name.c_str());
        }
    }
};

RUBBLE_TEST(CounterexamplesTest)
#include "CounterexamplesTest.moc"
