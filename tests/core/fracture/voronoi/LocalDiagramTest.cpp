#include "core/fracture/voronoi/LocalDiagram.h"

#include "core/base/Random.h"
#include "core/fracture/voronoi/PerturbedDiagram.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>

using namespace rubble;

namespace {

constexpr int kDrags = 4000;
// Two roundings; no outline here has a radius above 8.
constexpr double kCornerTolerance = 2.0 * kConstructionError * 8.0;

/// A corner of a piece, and the seed behind the edge that starts there.
struct Corner {
    Vec2 position;
    std::uint32_t neighbour;
};
using Loop = std::vector<Corner>;

bool isSameCorner(const Corner& a, const Corner& b) {
    return a.neighbour == b.neighbour && glm::distance(a.position, b.position) <= kCornerTolerance;
}
bool isSameLoop(Loop a, const Loop& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (std::ranges::equal(a, b, isSameCorner)) return true;
        std::ranges::rotate(a, a.begin() + 1);
    }
    return false;
}

/// All rings of a seed's pieces; `nameOf` maps seeds to those of the whole pattern.
template <class NameOf>
std::vector<Loop> loopsOf(const Partition& partition, std::uint32_t seed, NameOf nameOf) {
    std::vector<Loop> loops;
    const std::uint32_t first = partition.pieceOfSeed[seed];
    for (std::uint32_t piece = first; piece < partition.pieceCount() && partition.seedOfPiece[piece] == seed; ++piece) {
        for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
            Loop loop;
            for (std::uint32_t k = partition.cornersOfRing[ring]; k < partition.cornersOfRing[ring + 1]; ++k) {
                const std::uint32_t neighbour = partition.neighbours[k];
                loop.push_back({partition.points[partition.corners[k]],
                                neighbour == kNone ? kNone : nameOf(partition.seedOfPiece[neighbour])});
            }
            loops.push_back(loop);
        }
    }
    return loops;
}

/// The first difference between the cells around a move and those of the whole diagram after it; empty if there is
/// none.
QString localFault(const LocalCells& cells, const Partition& before, const Partition& after) {
    const auto itself = [](std::uint32_t seed) { return seed; };
    const auto ofWhole = [&](std::uint32_t seed) { return cells.seeds[seed]; };
    std::set<std::uint32_t> complete;
    for (const std::uint32_t local : cells.complete) {
        const std::uint32_t seed = cells.seeds[local];
        complete.insert(seed);
        const std::vector<Loop> wanted = loopsOf(after, seed, itself), made = loopsOf(cells.partition, local, ofWhole);
        if (!std::ranges::is_permutation(made, wanted, isSameLoop))
            return QString("the cell of seed %1 is wrong").arg(seed);
    }
    for (std::uint32_t seed = 0; seed < after.pieceOfSeed.size(); ++seed) {
        if (complete.contains(seed)) continue;
        if (!std::ranges::is_permutation(loopsOf(before, seed, itself), loopsOf(after, seed, itself), isSameLoop)) {
            return QString("the cell of seed %1 changed and was left out").arg(seed);
        }
    }
    return {};
}

QString localFault(const Polygon& outline, std::vector<Vec2> seeds, const std::vector<MovedSeed>& moved) {
    const Result<Delaunay> delaunay = triangulate(seeds);
    const Result<Partition> before = voronoiPartition(outline, *delaunay);
    const Result<LocalCells> cells = LocalDiagram(seeds, *delaunay).cellsAround(outline, moved);
    if (!cells) return QString::fromStdString(cells.error().message);
    for (const auto& [seed, position] : moved) seeds[seed] = position;
    return localFault(*cells, *before, *voronoiPartition(outline, seeds));
}

/// Positions around the comb; on a lattice, many are cocircular, collinear or equal.
Vec2 randomPosition(Random& random, bool isLattice) {
    const Vec2 position{random.between(-1.0, 9.0), random.between(-1.0, 9.0)};
    return isLattice ? glm::round(position) : position;
}

}  // namespace

class LocalDiagramTest : public QObject {
    Q_OBJECT
private slots:
    void smallMoveChangesOnlyNeighbours() {
        std::vector<Vec2> seeds;
        for (int k = 0; k < 400; ++k)
            seeds.push_back({0.05 * (k % 20) + 0.001 * (k % 7), 0.05 * (k / 20) + 0.001 * (k % 5)});
        const Result<Delaunay> delaunay = triangulate(seeds);
        const LocalDiagram diagram(seeds, *delaunay);
        const Result<LocalCells> cells =
            diagram.cellsAround(unitSquare(), std::vector<MovedSeed>{{210, seeds[210] + Vec2(0.01)}});
        QVERIFY(cells->complete.size() < 20);
        QVERIFY(cells->seeds.size() < 60);
    }
    void localCellsMatchTheWholeDiagram_data() {
        QTest::addColumn<bool>("isLattice");
        QTest::newRow("anywhere") << false;
        QTest::newRow("on a lattice") << true;
    }
    void localCellsMatchTheWholeDiagram() {
        QFETCH(const bool, isLattice);
        for (std::uint64_t drag = 0; drag < kDrags / 2; ++drag) {
            Random random(drag);
            std::vector<Vec2> seeds(1 + random.below(drag % 10 == 0 ? 300 : 40));
            for (Vec2& seed : seeds) seed = randomPosition(random, isLattice);
            std::map<std::uint32_t, Vec2> places;
            for (std::uint64_t k = 0; k <= random.below(4); ++k) {
                const auto seed = static_cast<std::uint32_t>(random.below(seeds.size()));
                const Vec2 near = seeds[seed] + Vec2(random.between(-0.3, 0.3), random.between(-0.3, 0.3));
                places[seed] = drag % 2 == 0 ? randomPosition(random, isLattice) : near;
            }
            std::vector<MovedSeed> moved;
            for (const auto& [seed, position] : places) moved.push_back({seed, position});
            const QString fault = localFault(combWithHole(), seeds, moved);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("random seed %1: %2").arg(drag).arg(fault)));
        }
    }
    void movingASeedUncoversItsDuplicate() {
        const std::vector<Vec2> seeds = {{0.25, 0.5}, {0.25, 0.5}, {0.75, 0.5}, {0.5, 0.9}, {0.5, 0.1}};
        QCOMPARE(localFault(unitSquare(), seeds, {{0, {0.3, 0.6}}}), QString());
        QCOMPARE(localFault(unitSquare(), seeds, {{1, {0.3, 0.6}}}), QString());
        QCOMPARE(localFault(unitSquare(), seeds, {{2, {0.25, 0.5}}}), QString());
    }
    void nonFinitePositionIsRejected() {
        const std::vector<Vec2> seeds = {{0.25, 0.5}, {0.75, 0.5}, {0.5, 0.9}};
        QVERIFY(localFault(unitSquare(), seeds, {{0, {std::numeric_limits<double>::infinity(), 0.0}}})
                    .contains("not finite"));
    }
};

RUBBLE_TEST(LocalDiagramTest)
#include "LocalDiagramTest.moc"
