// Tests core/fracture/cuts/CutPartition.cpp and core/fracture/cuts/CutOverlay.cpp with the layers that cut, of which
// core/fracture/kinds/BrickBond.cpp has no other test.
#include "core/base/Random.h"
#include "core/fracture/cuts/CutPartition.h"
#include "core/fracture/kinds/BrickCourses.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QProcess>
#include <QTest>

#include <set>

using namespace rubble;

namespace {

Pattern only(const LayerParameters& parameters) { return {{{.id = 7, .randomSeed = 1, .parameters = parameters}}}; }

/// A layer of crack lines 0, 1, ...
CrackLines crackLinesAlong(std::vector<std::vector<Vec2>> lines) {
    CrackLines layer;
    for (std::uint32_t k = 0; k < lines.size(); ++k) layer.lines.push_back({k, std::move(lines[k])});
    return layer;
}

std::set<std::string> namesOf(const PatternStages& stages) {
    std::set<std::string> names;
    for (std::uint32_t piece = 0; piece < stages.partition.pieceCount(); ++piece)
        names.insert(pieceName(stages.partition, piece, stages.seeds.ids));
    return names;
}

std::vector<Diagnostic> looseCuts(const PatternStages& stages) {
    std::vector<Diagnostic> loose;
    for (const Diagnostic& report : stages.partition.diagnostics) {
        if (report.code == DiagnosticCode::LooseCut) loose.push_back(report);
    }
    return loose;
}

std::string brickName(int course, int column) { return SeedId{7, BrickCourses::cellIndex(course, column)}.text(); }

}  // namespace

class CutPartitionTest : public QObject {
    Q_OBJECT
private slots:
    void twoCrossingLinesMakeFourPieces() {
        const auto stages = verifiedStages(
            only(crackLinesAlong({{{0.5, -1.0}, {0.5, 2.0}}, {{-1.0, 0.25}, {2.0, 0.25}}})), unitSquare());
        QCOMPARE(stages->partition.pieceCount(), 4u);
        QCOMPARE(pieceArea(stages->partition, 0), 0.125);
        QCOMPARE(namesOf(*stages), (std::set<std::string>{"0.0.0", "0.0.1", "0.0.2", "0.0.3"}));
        QVERIFY(stages->partition.diagnostics.empty());
    }
    void tooManyIntersectionsAreRefused() {
        std::vector<std::vector<Vec2>> lines;
        for (int k = 0; k < 2400; ++k) {
            const double place = (k + 0.5) / 2400.0;
            lines.push_back({{place, -1.0}, {place, 2.0}});
            lines.push_back({{-1.0, place}, {2.0, place}});
        }
        const auto stages = patternStages(only(crackLinesAlong(std::move(lines))), unitSquare());
        QVERIFY(!stages);
        QCOMPARE(stages.error().code, ErrorCode::Limit);
        QCOMPARE(stages.error().message,
                 std::string("Cuts of the pattern cross each other, cells and the outline in more than 5000000 places. "
                             "Use fewer cuts, fewer seeds or a simpler outline."));
    }
    void looseEndsAreReported() {
        const auto stages = verifiedStages(
            only(crackLinesAlong({{{-1.0, 0.5}, {0.25, 0.5}}, {{0.5, -1.0}, {0.5, 2.0}}, {{0.5, 0.75}, {0.75, 0.75}}})),
            unitSquare());
        QCOMPARE(stages->partition.pieceCount(), 2u);
        const std::vector<Diagnostic> loose = looseCuts(*stages);
        QCOMPARE(loose.size(), std::size_t{2});
        QCOMPARE(loose[0].place.index, 0u);
        QCOMPARE(loose[0].place.layer, 7u);
        QCOMPARE(loose[0].value, 0.25);
        QCOMPARE(loose[1].place.index, 2u);
        QCOMPARE(loose[1].value, 0.25);
        QCOMPARE(loose[0].message,
                 std::string("Cut 0 of layer 7 separates nothing along 0.25 m; this part is omitted."));
    }
    void oneCutToAHoleSeparatesNothing() {
        const auto stages = verifiedStages(only(crackLinesAlong({{Vec2(-1.0, 2.0), Vec2(2.0, 2.0)}})), squareRing());
        QCOMPARE(stages->partition.pieceCount(), 1u);
        QCOMPARE(looseCuts(*stages).size(), std::size_t{1});
        const auto through = verifiedStages(only(crackLinesAlong({{Vec2(-1.0, 2.0), Vec2(5.0, 2.0)}})), squareRing());
        QCOMPARE(through->partition.pieceCount(), 2u);
    }
    void aClosedLineMakesAPieceAndAHole() {
        const auto stages = verifiedStages(
            only(crackLinesAlong({{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}, {0.25, 0.25}}})),
            unitSquare());
        QCOMPARE(stages->partition.pieceCount(), 2u);
        QCOMPARE(pieceArea(stages->partition, 0), 0.75);
        QCOMPARE(pieceArea(stages->partition, 1), 0.25);
        QCOMPARE(contactsOf(stages->partition, 0, 0.0)[0].length, 2.0);
    }
    void cutsAlongTheOutlineAreIgnored() {
        const auto stages = verifiedStages(
            only(crackLinesAlong({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, {{-0.5, 1.0}, {0.5, 1.0}}})), unitSquare());
        QCOMPARE(stages->partition.pieceCount(), 1u);
        QVERIFY(looseCuts(*stages).empty());
    }
    void cutsThroughOnePointShareIt() {
        std::vector<std::vector<Vec2>> lines;
        for (const Vec2 end : {Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0), Vec2(-1.0, 1.0)})
            lines.push_back({Vec2(0.5, 0.5) - 2.0 * end, Vec2(0.5, 0.5) + 2.0 * end});
        const auto stages = verifiedStages(only(crackLinesAlong(lines)), unitSquare());
        QCOMPARE(stages->partition.pieceCount(), 8u);
        for (std::uint32_t piece = 0; piece < 8; ++piece) QCOMPARE(pieceArea(stages->partition, piece), 0.125);
    }
    void piecesHaveSeedAndBrickNames() {
        Pattern pattern = only(BrickBond{.bond = BondKind::Stack, .length = 0.5, .height = 1.0, .mortar = 0.0});
        pattern.layers.push_back({.id = 3, .parameters = PlacedSeeds{{{4, {0.5, 0.25}}, {9, {0.5, 0.75}}}}});
        const auto stages = verifiedStages(pattern, unitSquare());
        const std::string left = brickName(0, 0), right = brickName(0, 1);
        QCOMPARE(namesOf(*stages),
                 (std::set<std::string>{"3.4+" + left, "3.4+" + right, "3.9+" + left, "3.9+" + right}));
    }
    void brickNamesDoNotDependOnTheOutline() {
        const Pattern bricks = only(BrickBond{.length = 0.5, .height = 0.25, .mortar = 0.0});
        const auto small = verifiedStages(bricks, unitSquare());
        const auto large = verifiedStages(bricks, {rectangle({-1.0, -1.0}, {2.0, 2.0}), {}});
        const std::set<std::string> names = namesOf(*large);
        for (const std::string& name : namesOf(*small)) QVERIFY2(names.contains(name), name.c_str());
        QVERIFY(namesOf(*small).contains(brickName(2, 1)));
    }
    /// A course of one brick that the hole cuts apart, between courses that it does not.
    void partsOfOneBrickAreNumbered() {
        const BrickBond bricks{
            .bond = BondKind::Stack, .length = 4.0, .height = 1.0, .mortar = 0.0, .origin = {0.0, 1.5}};
        const auto stages = verifiedStages(only(bricks), squareRing());
        const std::string brick = brickName(0, 0);
        QCOMPARE(namesOf(*stages), (std::set<std::string>{brickName(-2, 0), brickName(-1, 0), brick + ".0",
                                                          brick + ".1", brickName(1, 0), brickName(2, 0)}));
        QCOMPARE(stages->partition.pieceCount(), 6u);
    }
    void brickCountMatchesScript_data() {
        QTest::addColumn<int>("bond");
        for (const auto& [name, bond] : {std::pair("stretcher", BondKind::Stretcher),
                                         {"stack", BondKind::Stack},
                                         {"english", BondKind::English},
                                         {"header", BondKind::Header},
                                         {"flemish", BondKind::Flemish}}) {
            QTest::newRow(name) << static_cast<int>(bond);
        }
    }
    void brickCountMatchesScript() {
        QFETCH(int, bond);
        const BrickBond bricks{.bond = static_cast<BondKind>(bond), .origin = {0.013, -0.02}};
        const Polygon wall{rectangle({0.0, 0.0}, {3.07, 1.93}), {}};
        const auto stages = verifiedStages(only(bricks), wall);
        const Partition& partition = stages->partition;
        double joints = 0.0;
        for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
            for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) joints += contact.length / 2.0;
        }
        QProcess script;
        script.start("python3", {RUBBLE_SOURCE_DIR "/tests/core/fracture/cuts/brick_count.py", QTest::currentDataTag(),
                                 "0.24", "0.115", "0.071", "0.01", "0.013", "-0.02", "3.07", "1.93"});
        QVERIFY2(script.waitForFinished(kPatience) && script.exitCode() == 0,
                 script.readAllStandardError().constData());
        const QList<QByteArray> words = script.readAllStandardOutput().simplified().split(' ');
        QCOMPARE(partition.pieceCount(), words[0].toUInt());
        QVERIFY2(std::abs(joints - words[1].toDouble()) < 1e-9, words[1].constData());
    }
    void cancellationStops() {
        TaskContext task;
        task.cancel.cancel();
        const CutSet cuts = cutsOf(only(Slices{}), unitSquare()).value();
        const auto cut = cutApart(*voronoiPartition(unitSquare(), std::vector<Vec2>{}), unitSquare(), cuts, task);
        QCOMPARE(cut.error().code, ErrorCode::Cancelled);
    }
    void bricksFarFromTheirOriginAreRejected() {
        const auto cuts = cutsOf(only(BrickBond{.origin = {1e6, 0.0}}), unitSquare());
        QCOMPARE(cuts.error().code, ErrorCode::Limit);
        QCOMPARE(
            cuts.error().message,
            std::string("Layer 7 has bricks more than 5000 courses or columns from its origin: increase their size, or "
                        "move the origin closer."));
    }
    void invalidCrackLinesAreRejectedWithTheirIndex() {
        QCOMPARE(*verifyPattern(only(CrackLines{{{0, {Vec2(0.0)}}}})),
                 std::string("Layer 7: crack line 0 has fewer than two points."));
        QCOMPARE(*verifyPattern(only(CrackLines{{{0, {Vec2(0.0), Vec2(0.0)}}}})),
                 std::string("Layer 7: point 1 of crack line 0 equals the one before, (0, 0)."));
        CrackLines unsorted = crackLinesAlong({{{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 1.0}, {1.0, 1.0}}});
        unsorted.lines[1].index = 0;
        QCOMPARE(*verifyPattern(only(unsorted)),
                 std::string("Layer 7: crack line 0 does not come after crack line 0."));
    }
    void adversarialNearlyTouchingCutsAllSplit() {
        qInfo("random seeds 0 to 199");
        for (std::uint64_t randomSeed = 0; randomSeed < 200; ++randomSeed) {
            Random random(randomSeed);
            std::vector<std::vector<Vec2>> lines;
            // Points of a coarse grid, displaced by almost nothing: nearly coincident and nearly collinear.
            const auto coordinate = [&] {
                return (static_cast<double>(random.below(5)) - 1.0) * 0.5 + random.between(-1.0, 1.0) * 0x1p-46;
            };
            for (int k = 0; k < 12; ++k) {
                const Vec2 from{coordinate(), coordinate()}, to{coordinate(), coordinate()};
                if (from != to) lines.push_back({from, to});
            }
            const auto stages = verifiedStages(only(crackLinesAlong(lines)), unitSquare());
            QVERIFY2(
                stages,
                qPrintable(
                    QString("random seed %1: %2").arg(randomSeed).arg(stages ? "" : stages.error().message.c_str())));
        }
    }
};

RUBBLE_TEST(CutPartitionTest)
#include "CutPartitionTest.moc"
