#include "core/fracture/voronoi/VoronoiPartition.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/polygon/LocalFrame.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

const Polygon kFrame = {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{2, 2}, {2, 6}, {6, 6}, {6, 2}}}};

}  // namespace

class VoronoiPartitionTest : public QObject {
    Q_OBJECT
private slots:
    void noSeedsGiveOnePiece() {
        const Result<Partition> partition = voronoiPartition(kFrame, std::vector<Vec2>{});
        QCOMPARE(partition->pieceCount(), 1u);
        QCOMPARE(partition->seedOfPiece[0], kNone);
        QCOMPARE(verifyPartition(*partition, kFrame).value_or(""), std::string());
    }
    void collinearSeedsGiveStrips() {
        const std::vector<Vec2> seeds = {{0.125, 0.5}, {0.375, 0.5}, {0.625, 0.5}, {0.875, 0.5}};
        const Result<Partition> partition = voronoiPartition(unitSquare(), seeds);
        for (std::uint32_t seed = 0; seed < 4; ++seed) QCOMPARE(areaOfSeed(*partition, seed), 0.25);
        QCOMPARE(partitionFault(unitSquare(), seeds), std::string());
    }
    void fourCocircularSeedsShareOnePoint() {
        const std::vector<Vec2> seeds = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
        const Result<Partition> partition = voronoiPartition(unitSquare(), seeds);
        QCOMPARE(partition->corners.size(), std::size_t{16});
        QCOMPARE(partitionFault(unitSquare(), seeds), std::string());
    }
    void lShapeSplitsACell() {
        // The far corner of the square that the L leaves out lies between both ends of the cell of seed 0.
        // The bisector runs exactly through the L's inner corner.
        for (const bool farFirst : {true, false}) {
            const std::vector<Vec2> seeds =
                farFirst ? std::vector<Vec2>{{2, 2}, {0, 0}} : std::vector<Vec2>{{0, 0}, {2, 2}};
            const Result<Partition> partition = voronoiPartition(lShape(), seeds);
            QCOMPARE(partition->pieceCount(), 3u);
            QCOMPARE(areaOfSeed(*partition, farFirst ? 0 : 1), 1.0);
            QCOMPARE(partition->diagnostics.size(), std::size_t{1});
            QCOMPARE(QString::fromStdString(partition->diagnostics[0].message),
                     QString("The outline cuts the cell of seed %1 into 2 pieces.").arg(farFirst ? 0 : 1));
            QCOMPARE(partitionFault(lShape(), seeds), std::string());
        }
    }
    /// Teeth of the outline multiply flat cells.
    void tooManyOutlineCrossingsAreRefused() {
        constexpr int kTeeth = 1500, kSeeds = 3000;
        Polygon comb{{{0.0, -0.5}, {1.0, -0.5}, {1.0, 0.0}}, {}};
        for (int k = kTeeth - 1; k >= 0; --k) {
            const double left = static_cast<double>(k) / kTeeth, right = (k + 0.5) / kTeeth;
            for (const Vec2 point : {Vec2(right, 0.0), Vec2(right, 1.0), Vec2(left, 1.0), Vec2(left, 0.0)})
                comb.outer.push_back(point);
        }
        Random random(7);
        std::vector<Vec2> seeds;
        for (int k = 0; k < kSeeds; ++k) seeds.push_back({0.5 + 1e-9 * random.unit(), (k + 0.5) / kSeeds});
        const Result<Prism> prism = validated({comb, 1.0});
        QVERIFY2(prism, prism ? "" : prism.error().message.c_str());
        const Result<Partition> partition = voronoiPartition(prism->outline, seeds);
        QVERIFY(!partition);
        QCOMPARE(partition.error().message,
                 std::string("The outline crosses cells of the pattern in more than 8000000 places. Use fewer seeds or "
                             "a simpler outline."));
    }
    void farSeedHasNoCell() {
        const Result<Partition> partition = voronoiPartition(unitSquare(), std::vector<Vec2>{{0.5, 0.5}, {100, 100}});
        QCOMPARE(partition->pieceOfSeed, (UninitializedVector<std::uint32_t>{0, kNone}));
        QCOMPARE(partition->diagnostics[0].code, DiagnosticCode::SeedWithoutCell);
    }
    void holeInsideOneCellIsKept() {
        const std::vector<Vec2> seeds = {{4, 4}, {4, 40}};
        const Result<Partition> partition = voronoiPartition(kFrame, seeds);
        QCOMPARE(partition->ringsOfPiece, (UninitializedVector<std::uint32_t>{0, 2}));
        QCOMPARE(areaOfSeed(*partition, 0), 48.0);
    }
    void bisectorsAlongTheOutlineLeaveNoSliver() {
        // The bisector x = 1 is the L's own edge from (1, 1) to (1, 2).
        for (const std::vector<Vec2>& seeds : {std::vector<Vec2>{{0.5, 0.5}, {1.5, 0.5}}, {{1.5, 0.5}, {0.5, 0.5}}}) {
            const Result<Partition> partition = voronoiPartition(lShape(), seeds);
            QCOMPARE(partition->pieceCount(), 2u);
            QCOMPARE(partition->corners.size(), std::size_t{9});
            QCOMPARE(partitionFault(lShape(), seeds), std::string());
        }
    }
    void acuteCornerIsKept() {
        // A cell edge cuts off an acute corner that is too narrow for two points.
        for (const double degrees : {2.0, 10.0, 30.0, 44.0}) {
            const double angle = degrees * 3.14159265 / 180.0;
            const Polygon outline = {{{0, 0}, {1, 0}, {cosine(angle), sine(angle)}}, {}};
            const Vec2 along = {cosine(angle / 2.0), sine(angle / 2.0)};
            for (const double times : {0.5, 0.99, 1.01, 2.0, 4.0}) {
                const double tip = times * kWeldFraction / (2.0 * sine(angle / 2.0));
                QCOMPARE(partitionFault(outline, {0.5 * tip * along, 1.5 * tip * along}), std::string());
            }
        }
    }
    void manyEdgesInAnAcuteCornerKeepIt() {
        const std::uint64_t seed = 11;
        Random random(seed);
        for (int round = 0; round < 4000; ++round) {
            const double angle = (round % 2 == 0 ? 7e-5 : 0.5) * (1.0 + random.unit());
            const Polygon outline = {{{0, 0}, {1, 0}, {cosine(angle), sine(angle)}}, {}};
            const Vec2 along = {cosine(angle / 2.0), sine(angle / 2.0)};
            const double tip = kWeldFraction / (2.0 * sine(angle / 2.0));
            std::vector<Vec2> seeds;
            for (std::uint64_t count = 2 + random.below(7); count > 0; --count) {
                const double aside =
                    round % 3 == 0 ? 0.0 : random.between(-1.0, 1.0) * (round % 3 == 1 ? kWeldFraction : tip);
                seeds.push_back(random.between(-0.5, 4.0) * tip * along + aside * Vec2{-along.y, along.x});
            }
            const std::string fault = partitionFault(outline, seeds);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1, round %2: ").arg(seed).arg(round) + fault.c_str()));
        }
    }
    void narrowestValidOutlineLosesNothing() {
        // A notch, a short edge, an acute corner and a hole, each just wide enough to be accepted.
        const double minDistance = 1.01 * 0x1p-42;  // 2^-44 of a bounding radius of 4
        const std::vector<Polygon> outlines = {
            {{{0, 0}, {4, 0}, {4, 4}, {2, minDistance}, {0, 4}}, {}},
            {{{0, 0}, {4, 0}, {4, 4}, {minDistance, 4}, {0, 4}}, {}},
            {{{0, 0}, {4, 0}, {4, 3e-4}}, {}},
            {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{minDistance, 1}, {minDistance, 2}, {2, 2}, {2, 1}}}}};
        const std::vector<Vec2> places = {{2, 0}, {0, 4}, {0, 0}, {0, 1.5}};
        const std::uint64_t seed = 12;
        Random random(seed);
        for (int round = 0; round < 400; ++round) {
            const std::size_t k = static_cast<std::size_t>(round) % outlines.size();
            const double spread = round % 3 == 0 ? 4.0 : round % 3 == 1 ? 1e-3 : 4.0 * minDistance;
            std::vector<Vec2> seeds;
            const bool isMany =
                round % 10 == 0 && spread > minDistance * 1e3;  // far apart against the rounding of points
            for (std::uint64_t count = isMany ? 1000 : 1 + random.below(9); count > 0; --count)
                seeds.push_back(places[k] + spread * Vec2{random.between(-1.0, 1.0), random.between(-1.0, 1.0)});
            const std::string fault = partitionFault(outlines[k], seeds);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1, round %2: ").arg(seed).arg(round) + fault.c_str()));
        }
    }
    void areaIsKeptFarFromTheOrigin() {
        Polygon outline;
        for (const Vec2 point : unitSquare().outer) outline.outer.push_back(point * 0x1p-20 + Vec2{0x1p20, -0x1p20});
        const std::vector<Vec2> seeds = {outline.outer[0] + Vec2{0x1p-22, 0x1p-21},
                                         outline.outer[0] + Vec2{0x1.8p-21, 0x1p-21}};
        const Result<Partition> partition = voronoiPartition(outline, seeds);
        QCOMPARE(areaOfSeed(*partition, 0), 0x1p-41);
        QCOMPARE(areaOfSeed(*partition, 1), 0x1p-41);
    }
    void manySeedsGiveTheSameOnAnyNumberOfThreads() {
        // With seeds outside the outline, whole rings inside cells, and a disconnected cell.
        Random random(5);
        std::vector<Vec2> seeds;
        for (int i = 0; i < 40'000; ++i) seeds.push_back(Vec2{random.unit(), random.unit()} * 9.0 - Vec2{0.5, 0.5});
        for (const Polygon& outline : {lShape(), kFrame, combWithHole()}) {
            const Result<Partition> one = voronoiPartition(outline, seeds, {.threads = 1});
            const Result<Partition> two = voronoiPartition(outline, seeds, {.threads = 2});
            QCOMPARE(verifyPartition(*one, outline).value_or(""), std::string());
            QVERIFY(one->seedOfPiece == two->seedOfPiece && one->ringsOfPiece == two->ringsOfPiece);
            QVERIFY(one->corners == two->corners && one->neighbours == two->neighbours && one->points == two->points);
        }
    }
    void randomInputsVerify() {
        const std::uint64_t seed = 3;
        Random random(seed);
        const auto lattice = [&](std::uint64_t size) { return static_cast<double>(random.below(size)); };
        for (int round = 0; round < 1500; ++round) {
            std::vector<Vec2> seeds;
            const std::uint64_t count = 1 + random.below(round % 10 == 0 ? 200 : 12);
            for (std::uint64_t i = 0; i < count; ++i) {
                switch (round % 4) {
                    case 0: seeds.push_back(Vec2{random.unit(), random.unit()} * 8.0); break;
                    case 1: seeds.push_back({lattice(9), lattice(9)}); break;
                    case 2: seeds.push_back(Vec2{lattice(17), lattice(17)} * 0.5); break;
                    case 3: seeds.push_back({4.0 + lattice(9) * 0x1p-50, lattice(9)}); break;
                }
            }
            for (const Polygon& outline : {unitSquare(), lShape(), kFrame, combWithHole()}) {
                const std::string fault = partitionFault(outline, seeds);
                QVERIFY2(fault.empty(),
                         qPrintable(QString("seed %1, round %2: ").arg(seed).arg(round) + fault.c_str()));
            }
        }
    }
};

RUBBLE_TEST(VoronoiPartitionTest)
#include "VoronoiPartitionTest.moc"
