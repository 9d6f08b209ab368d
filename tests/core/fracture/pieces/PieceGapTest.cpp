#include "core/fracture/pieces/PieceGap.h"

#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/pieces/PieceDraft.h"
#include "core/fracture/pieces/SmallPieces.h"
#include "core/fracture/verify/VerifyFragments.h"
#include "core/fracture/verify/VerifyGap.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numeric>

using namespace rubble;

namespace {

Fragments withGap(const Polygon& outline, const std::vector<Vec2>& seeds, double gap) {
    return *extrudedFragments({outline, 2.0}, *voronoiPartition(outline, seeds), gap);
}

double widthOfBox(const Fragment& fragment) { return boundsOf(fragment.extruded()->outline().outer).size().x; }

/// An upper bound of the area that a margin removes from a piece: strips along its cut edges, and corners.
double mostLost(const Partition& partition, std::uint32_t piece, double margin) {
    double length = 0.0, corners = 0.0;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
        if (neighbour == kNone) return;
        length += glm::distance(partition.points[from], partition.points[to]);
        corners += 2.0;
    });
    return margin * length + 4.0 * corners * margin * margin;
}

}  // namespace

class PieceGapTest : public QObject {
    Q_OBJECT
private slots:
    void halfTheGapIsRemovedOnEachSide() {
        const Fragments halves = withGap(unitSquare(), {{0.25, 0.5}, {0.75, 0.5}}, 0.25);
        QCOMPARE(halves.count(), 2u);
        QCOMPARE(widthOfBox(halves[0]), 0.375);  // nothing is removed along the outline
        QCOMPARE(halves[0].volume(), 0.75);
        QCOMPARE(halves.extruded()->gapArea, 0.25);
        QCOMPARE(QString::fromStdString(halves.diagnostics.back().message),
                 QString("The gap between fragments takes 0.5 m³ from them."));
        QVERIFY(!verifyFragments(halves, {unitSquare(), 2.0}));
        QVERIFY(!verifyGap(halves, 0.25));
        QVERIFY(verifyGap(halves, 0.26));
    }
    void bondsDoNotDependOnTheGap() {
        const Fragments halves = withGap(unitSquare(), {{0.25, 0.5}, {0.75, 0.5}}, 0.25);
        QCOMPARE(halves[0].contacts().size(), std::size_t{1});
        QCOMPARE(halves[0].contacts()[0].area, 2.0);
        std::vector<std::uint32_t> neighbour = halves[0].extruded()->edgeNeighbours();
        std::ranges::sort(neighbour);
        QCOMPARE(neighbour, (std::vector<std::uint32_t>{1, kNone, kNone, kNone}));
    }
    void pieceNarrowerThanTheGapVanishes() {
        const Fragments strips = withGap(unitSquare(), {{0.25, 0.5}, {0.5, 0.5}, {0.625, 0.5}}, 0.2);
        QCOMPARE(strips.count(), 2u);
        QCOMPARE(strips.diagnostics[0].code, DiagnosticCode::VanishedPiece);
        QCOMPARE(strips.diagnostics[0].value, 0.1875);
        QVERIFY(!verifyFragments(strips, {unitSquare(), 2.0}));
    }
    void outlineParallelToACutStays() {
        // A hammer: the cut beside the handle continues in the lower edge of the head, from which nothing is removed.
        const Polygon hammer{{{0, 0}, {4, 0}, {4, 1}, {2.5, 1}, {2.5, 3}, {1.5, 3}, {1.5, 1}, {0, 1}}, {}};
        const Fragments pieces = withGap(hammer, {{2, 0.5}, {2, 1.5}}, 0.5);
        QCOMPARE(pieces.count(), 2u);
        const Fragment& head = pieces[0];
        // A strip of 0.25 along the cut, which is as wide as the handle, and as much beyond it.
        QVERIFY(std::abs(head.volume() / 2.0 - (4.0 - 1.5 * 0.25)) < 1e-9);
        QCOMPARE(pieces[1].volume(), 2.0 * 1.75);
        QVERIFY(!verifyGap(pieces, 0.5));
    }
    void reflexCornersAreMitred() {
        // An L of three squares around the fourth: its inner corner is moved by the margin along both axes.
        Partition four =
            *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}});
        const auto piece = [&](int seed) { return four.pieceOfSeed[static_cast<std::size_t>(seed)]; };
        std::vector<std::uint32_t> receivers(4, piece(0));
        receivers[piece(3)] = piece(3);
        PieceDraft draft(four);
        draft.merge(receivers);
        const Fragments pieces = *extrudedFragments({unitSquare(), 1.0}, std::move(draft).finished(), 0.25);
        QCOMPARE(pieces.count(), 2u);
        QCOMPARE(pieces[0].volume(), 1.0 - 0.625 * 0.625);
        QCOMPARE(pieces[1].volume(), 0.375 * 0.375);
    }
    void disconnectedPieceKeepsItsLargestPart() {
        // A dumbbell, whose bar is narrower than the gap.
        const Polygon outline{rectangle({0, 0}, {4, 3}), {}};
        const Partition cells =
            *voronoiPartition(outline, std::vector<Vec2>{{0.5, 1.5}, {1.5, 1.5}, {2.5, 1.5}, {3.5, 1.5}});
        PieceDraft draft(cells);
        std::vector<std::uint32_t> bar;
        for (std::uint32_t piece = 0; piece < 4; ++piece) {
            if (cells.seedOfPiece[piece] != 1) continue;
            QCOMPARE(draft.split(piece, {{0, 1.4}, {1, 0}}), 2u);
            QCOMPARE(draft.split(piece, {{0, 1.6}, {1, 0}}), 1u);
            bar = {piece, 4};
        }
        QCOMPARE(draft.split(4, {{0, 1.6}, {1, 0}}), 2u);
        std::vector<std::uint32_t> receivers(draft.count());
        std::iota(receivers.begin(), receivers.end(), 0u);
        std::uint32_t left = kNone, right = kNone;
        for (std::uint32_t piece = 0; piece < cells.pieceCount(); ++piece) {
            if (cells.seedOfPiece[piece] == 0) left = piece;
            if (cells.seedOfPiece[piece] == 2) right = piece;
        }
        receivers[4] = receivers[right] = left;  // the bar between the cuts connects both sides
        draft.merge(receivers);
        const Partition dumbbell = std::move(draft).finished();
        QVERIFY(!verifyPartition(dumbbell, outline));
        const Fragments pieces = *extrudedFragments({outline, 1.0}, dumbbell, 0.3);
        QVERIFY(!verifyGap(pieces, 0.3));
        QVERIFY(!verifyFragments(pieces, {outline, 1.0}));
        QCOMPARE(pieces.diagnostics[0].code, DiagnosticCode::VanishedPiece);
        QVERIFY(pieces.diagnostics[0].message.find("apart") != std::string::npos);
    }
    /// On all kinds of outlines, with merged pieces, so that many are concave and some have holes.
    void gapsOfRandomPartitionsVerify() {
        int concave = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 3));
            const Partition partition =
                withoutSmallPieces(made.partition, {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.7}, 1.0);
            const double gap = random.between(0.0001, 0.1);
            const Prism prism{made.outline, 0.5};
            const Fragments pieces = *extrudedFragments(prism, partition, gap);
            auto fault = verifyGap(pieces, gap);
            if (!fault) fault = verifyFragments(pieces, prism);
            QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            double lost = 0.0;
            for (std::uint32_t k = 0; k < pieces.count(); ++k) {
                if (!pieces[k].isConvex()) ++concave;
                const std::uint32_t piece = pieces.extruded()->pieceOfFragment[k];
                const double taken = pieceArea(partition, piece) - pieces[k].volume() / 0.5;
                const bool isApart = std::ranges::any_of(pieces.diagnostics, [&](const Diagnostic& report) {
                    return report.code == DiagnosticCode::VanishedPiece && report.place.seed == pieces[k].seed();
                });
                const bool isLittle = isApart || taken <= mostLost(partition, piece, gap / 2.0) + 1e-9;
                QVERIFY2(isLittle, qPrintable(faultOfSeed(seed, "too much of " + std::to_string(k))));
                lost += pieces[k].volume();
            }
            QVERIFY2(std::abs(lost + pieces.extruded()->gapArea * 0.5 - area(made.outline) * 0.5) < 1e-9,
                     qPrintable(faultOfSeed(seed, "volume")));
        }
        QVERIFY(concave > 1500);
    }
};

RUBBLE_TEST(PieceGapTest)
#include "PieceGapTest.moc"
