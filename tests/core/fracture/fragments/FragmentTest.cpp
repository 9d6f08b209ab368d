// Tests core/fracture/fragments/Fragment.cpp, core/fracture/fragments/Extrusion.cpp, core/fracture/pieces/HullParts.cpp
// and core/fracture/pieces/MassTransfer.cpp.
#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/fragments/Fragment.h"

#include "core/base/Random.h"
#include "core/fracture/verify/VerifyFragments.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// Four teeth and a hole.
const Polygon kComb = {{{0, 0}, {8, 0}, {8, 8}, {7, 8}, {7, 1}, {6, 1}, {6, 8}, {5, 8}, {5, 1}, {4, 1}, {4, 8}, {0, 8}},
                       {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};

struct Broken {
    Prism prism;
    Fragments fragments;
    Fragment operator[](std::uint32_t i) const { return fragments[i]; }
    std::size_t count() const { return fragments.count(); }
    std::string fault() const { return verifyFragments(fragments, prism).value_or(""); }
};

Broken extruded(Partition partition, const Polygon& outline, double depth, int threads = 1) {
    const Prism prism{outline, depth};
    TaskContext task;
    task.threads = threads;
    return {prism, *extrudedFragments(prism, std::move(partition), task)};
}

Broken broken(const Polygon& outline, const std::vector<Vec2>& seeds, double depth = 0.5) {
    return extruded(*voronoiPartition(outline, seeds), outline, depth);
}

/// Cuts [0, x_n] x [0, 1] at x_1 ... x_(n-1); strip i belongs to seed i.
Partition stripsBetween(const std::vector<double>& cuts) {
    Partition partition;
    const auto count = static_cast<std::uint32_t>(cuts.size());
    partition.points = {{0, 0}, {0, 1}};
    partition.ringsOfPiece = {0};
    partition.cornersOfRing = {0};
    for (std::uint32_t i = 0; i < count; ++i) {
        partition.points.push_back({cuts[i], 0});
        partition.points.push_back({cuts[i], 1});
        partition.corners.insert(partition.corners.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
        partition.neighbours.insert(partition.neighbours.end(), {kNone, i + 1 < count ? i + 1 : kNone, kNone, i - 1});
        partition.cornersOfRing.push_back(4 * (i + 1));
        partition.ringsOfPiece.push_back(i + 1);
        partition.seedOfPiece.push_back(i);
        partition.pieceOfSeed.push_back(i);
    }
    return partition;
}

std::vector<Vec2> randomSeeds(Random& random, std::uint64_t count, Vec2 size) {
    std::vector<Vec2> seeds;
    for (std::uint64_t i = 0; i < count; ++i) seeds.push_back(Vec2{random.unit(), random.unit()} * size);
    return seeds;
}

bool areEqual(const Fragment& a, const Fragment& b) {
    const auto sameContact = [](const FragmentContact& x, const FragmentContact& y) {
        return x.fragment == y.fragment && x.area == y.area;
    };
    return a.seed() == b.seed() && a.partOfCell() == b.partOfCell() &&
           a.extruded()->outline() == b.extruded()->outline() &&
           a.extruded()->edgeNeighbours() == b.extruded()->edgeNeighbours() && a.offset() == b.offset() &&
           a.volume() == b.volume() && a.mass().inertia == b.mass().inertia && a.isConvex() == b.isConvex() &&
           std::ranges::equal(a.contacts(), b.contacts(), sameContact);
}

}  // namespace

class FragmentTest : public QObject {
    Q_OBJECT
private slots:
    void noSeedsGiveOneFragment() {
        const Broken box = broken({rectangle({2, 2}, {4, 6}), {}}, {}, 3.0);
        QCOMPARE(box.count(), std::size_t{1});
        QCOMPARE(box[0].seed(), kNone);
        QVERIFY(box[0].offset() == Vec3(3, 4, 0));
        QVERIFY(box[0].extruded()->outline().outer == rectangle({-1, -2}, {1, 2}));
        QCOMPARE(box[0].volume(), 24.0);
        QCOMPARE(box[0].mass().inertia[2][2], 24.0 * (4.0 + 16.0) / 12.0);
        QVERIFY(box[0].hulls()[0].vertices[0] == Vec3(-1, -2, 1.5));
        QVERIFY(box[0].contacts().empty());
        QCOMPARE(box.fault(), std::string());
    }
    void halvesOfABoxAreBonded() {
        const Broken halves = broken(unitSquare(), {{0.75, 0.5}, {0.25, 0.5}}, 0.5);
        QCOMPARE(halves.count(), std::size_t{2});
        QVERIFY(halves[0].offset() == Vec3(0.75, 0.5, 0));
        QVERIFY(halves[1].offset() == Vec3(0.25, 0.5, 0));
        QCOMPARE(halves[0].volume(), 0.25);
        QCOMPARE(halves[0].contacts().size(), std::size_t{1});
        QCOMPARE(halves[0].contacts()[0].fragment, 1u);
        QCOMPARE(halves[0].contacts()[0].area, 0.5);
        QCOMPARE(std::ranges::count(halves[0].extruded()->edgeNeighbours(), 1u), 1);
        QCOMPARE(std::ranges::count(halves[0].extruded()->edgeNeighbours(), kNone), 3);
        QCOMPARE(halves.fault(), std::string());
    }
    void cellsTouchingInAPointAreNotBonded() {
        const Broken quarters = broken(unitSquare(), {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}});
        QCOMPARE(quarters.count(), std::size_t{4});
        QCOMPARE(quarters[0].contacts().size(), std::size_t{2});
        QCOMPARE(quarters[0].contacts()[0].fragment, 1u);
        QCOMPARE(quarters[0].contacts()[1].fragment, 2u);
        QCOMPARE(quarters.fault(), std::string());
    }
    void concavePieceHasOneHullPerConvexPart() {
        const Broken ell = broken(lShape(), {{0.5, 0.5}, {100, 100}});
        QCOMPARE(ell.count(), std::size_t{1});
        QCOMPARE(ell[0].hulls().size(), std::size_t{2});
        QCOMPARE(ell[0].volume(), 1.5);
        QCOMPARE(ell.fault(), std::string());
    }
    void holeOfAPieceIsKept() {
        const Broken frame = broken(squareRing(), {});
        QCOMPARE(frame[0].extruded()->outline().holes.size(), std::size_t{1});
        QCOMPARE(frame[0].extruded()->edgeNeighbours().size(), std::size_t{8});
        QCOMPARE(frame[0].hulls().size(), std::size_t{4});
        QCOMPARE(frame[0].volume(), 6.0);
        QCOMPARE(frame.fault(), std::string());
    }
    void disconnectedCellGivesNumberedPieces() {
        const Broken ell = broken(lShape(), {{2, 2}, {0, 0}});
        QCOMPARE(ell.count(), std::size_t{3});
        QCOMPARE(ell[0].partOfCell(), 0u);
        QCOMPARE(ell[1].seed(), 0u);
        QCOMPARE(ell[1].partOfCell(), 1u);
        QCOMPARE(ell[2].seed(), 1u);
        QCOMPARE(ell[2].partOfCell(), kNone);
        QVERIFY(ell[0].offset().x < ell[1].offset().x);
        QCOMPARE(ell.fault(), std::string());
    }
    void ringsMayTouchInAPoint() {
        // A square with a diamond-shaped hole that touches the middle of its lower side.
        Partition partition;
        partition.points = {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {3, 1}, {2, 2}, {1, 1}};
        partition.seedOfPiece = {0, 1};
        partition.pieceOfSeed = {0, 1};
        partition.ringsOfPiece = {0, 2, 3};
        partition.cornersOfRing = {0, 5, 9, 13};
        partition.corners = {0, 1, 2, 3, 4, 1, 7, 6, 5, 1, 5, 6, 7};
        partition.neighbours = {kNone, kNone, kNone, kNone, kNone, 1, 1, 1, 1, 0, 0, 0, 0};
        const Polygon outline{{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, {}};
        const Broken square = extruded(partition, outline, 1.0);
        QCOMPARE(square.count(), std::size_t{2});
        QCOMPARE(square[0].volume(), 14.0);
        QCOMPARE(square[1].hulls().size(), std::size_t{1});
        QCOMPARE(square[0].contacts()[0].area, 4.0 * std::sqrt(2.0));
        QCOMPARE(square.fault(), std::string());
    }
    void thinPieceTransfersItsMassToItsNeighbour() {
        const double width = 0x1p-40;
        const Broken box = extruded(stripsBetween({0.5, 0.5 + width, 1.0}), unitSquare(), 1.0);
        QCOMPARE(box.count(), std::size_t{2});
        QCOMPARE(box.fragments.diagnostics.size(), std::size_t{1});
        const Diagnostic& report = box.fragments.diagnostics[0];
        QCOMPARE(report.code, DiagnosticCode::ThinPiece);
        QCOMPARE(report.place.seed, 1u);
        QCOMPARE(report.place.otherSeed, 0u);
        QCOMPARE(report.value, width);
        QVERIFY(report.message.starts_with("A piece of the cell of seed 1 is 9.09"));
        QVERIFY(report.message.ends_with("too thin for a hull; its mass is transferred to the cell of seed 0."));
        QCOMPARE(box[0].volume(), 0.5 + width);
        QCOMPARE(box[1].extruded()->edgeNeighbours()[3], 0u);  // behind the thin piece
        QCOMPARE(box[0].extruded()->edgeNeighbours()[1], 0u);  // itself, with the mass of the thin piece
        QCOMPARE(box[0].contacts().size(), std::size_t{1});
        QCOMPARE(box[0].contacts()[0].area, 1.0);
        QCOMPARE(box.fault(), std::string());
    }
    void massTransfersPassThinNeighbours() {
        const double width = 0x1p-40;
        const Broken box = extruded(stripsBetween({width, 2 * width, 3 * width, 1.0}), unitSquare(), 1.0);
        QCOMPARE(box.count(), std::size_t{1});
        QCOMPARE(box[0].seed(), 3u);
        QCOMPARE(box[0].volume(), 1.0);
        QCOMPARE(box[0].offset().x, 0.5);
        QCOMPARE(box.fragments.diagnostics.size(), std::size_t{3});
        for (const Diagnostic& report : box.fragments.diagnostics) QCOMPARE(report.place.otherSeed, 3u);
        QCOMPARE(box.fault(), std::string());
    }
    void thinOutlineHasFragments() {
        const Polygon plank{rectangle({0, 0}, {1, 1e-12}), {}};
        const Broken pieces = broken(plank, {{0.25, 0}, {0.75, 0}});
        QCOMPARE(pieces.count(), std::size_t{2});
        QCOMPARE(pieces.fault(), std::string());
    }
    void precisionIsKeptFarFromTheOrigin() {
        Polygon outline;
        for (const Vec2 point : unitSquare().outer) outline.outer.push_back(point * 0x1p-20 + Vec2{0x1p20, -0x1p20});
        const Broken halves = broken(outline, {outline.outer[0], outline.outer[1]}, 1.0);
        QCOMPARE(halves[0].volume(), 0x1p-41);
        QVERIFY(boundsOf(halves[0].extruded()->outline().outer).min == Vec2(-0x1p-22, -0x1p-21));
        QCOMPARE(halves.fault(), std::string());
    }
    void resultDoesNotDependOnThreadCount() {
        Random random(5);
        const Partition partition = *voronoiPartition(kComb, randomSeeds(random, 2000, {8, 8}));
        const Broken one = extruded(partition, kComb, 0.5, 1);
        const Broken two = extruded(partition, kComb, 0.5, 2);
        QCOMPARE(one.count(), two.count());
        for (std::uint32_t i = 0; i < one.count(); ++i) QVERIFY(areEqual(one[i], two[i]));
    }
    void cancelledTaskFails() {
        TaskContext task;
        task.cancel.cancel();
        const Result<Fragments> fragments = extrudedFragments({unitSquare(), 1.0}, stripsBetween({0.5, 1.0}), task);
        QVERIFY(!fragments);
        QCOMPARE(fragments.error().code, ErrorCode::Cancelled);
    }
    void randomInputsVerify() {
        const std::uint64_t seed = 11;
        Random random(seed);
        const auto lattice = [&](std::uint64_t size) { return static_cast<double>(random.below(size)); };
        for (int round = 0; round < 1500; ++round) {
            std::vector<Vec2> seeds = randomSeeds(random, 1 + random.below(round % 10 == 0 ? 300 : 12), {8, 8});
            for (Vec2& position : seeds) {
                if (round % 4 == 1) position = {lattice(9), lattice(9)};
                if (round % 4 == 2) position = Vec2{lattice(17), lattice(17)} * 0.5;
                if (round % 4 == 3) position = {4.0 + lattice(9) * 0x1p-50, lattice(9)};
            }
            for (const Polygon& outline : {unitSquare(), lShape(), squareRing(), kComb}) {
                const std::string fault = broken(outline, seeds).fault();
                QVERIFY2(fault.empty(),
                         qPrintable(QString("seed %1, round %2: ").arg(seed).arg(round) + fault.c_str()));
            }
        }
    }
};

RUBBLE_TEST(FragmentTest)
#include "FragmentTest.moc"
