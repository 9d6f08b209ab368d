#include "core/fracture/voronoi/PerturbedDiagram.h"

#include "core/fracture/voronoi/OutlineTrace.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/TracedCells.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

Vec2 latticePoint(Random& random) {
    return {static_cast<double>(random.below(9)), static_cast<double>(random.below(9))};
}

DirectedLine latticeLine(Random& random) {
    const Vec2 from = latticePoint(random);
    Vec2 to = from;
    while (to == from) to = latticePoint(random);
    return {from, to};
}

std::uint32_t siteOfSeed(const Delaunay& delaunay, std::uint32_t seed) {
    return static_cast<std::uint32_t>(std::ranges::find(delaunay.seedOf, seed) - delaunay.seedOf.begin());
}

}  // namespace

class PerturbedDiagramTest : public QObject {
    Q_OBJECT
private slots:
    void ofEquallyNearSitesTheLowerSeedIsNearer() {
        const Delaunay delaunay = *triangulate(std::vector<Vec2>{{2.0, 0.0}, {0.0, 0.0}});
        const PerturbedDiagram diagram(delaunay);
        const std::uint32_t right = siteOfSeed(delaunay, 0), left = siteOfSeed(delaunay, 1);
        QVERIFY(diagram.isNearer({1.5, 5.0}, right, left));
        QVERIFY(diagram.isNearer({0.5, 5.0}, left, right));
        QVERIFY(diagram.isNearer({1.0, 5.0}, right, left));
        QVERIFY(!diagram.isNearer({1.0, 5.0}, left, right));
    }
    void bisectorIsCrossedCounterClockwise() {
        const Delaunay delaunay = *triangulate(std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}});
        const PerturbedDiagram diagram(delaunay);
        const std::uint32_t left = siteOfSeed(delaunay, 0), right = siteOfSeed(delaunay, 1);
        const DirectedLine low{{0.0, 0.0}, {2.0, 0.5}}, high{{2.0, 1.0}, {0.0, 1.0}};
        QVERIFY(diagram.crossesBefore(left, right, low, high));  // upwards around the left one
        QVERIFY(!diagram.crossesBefore(left, right, high, low));
        QVERIFY(diagram.crossesBefore(right, left, high, low));
    }
    void tiedCrossingsHaveOneOrder() {  // lines through one point of the bisector, which moves to the right
        const Delaunay delaunay = *triangulate(std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}});
        const PerturbedDiagram diagram(delaunay);
        const std::uint32_t left = siteOfSeed(delaunay, 0), right = siteOfSeed(delaunay, 1);
        const DirectedLine level{{0.0, 1.0}, {2.0, 1.0}}, rising{{0.0, 0.0}, {2.0, 2.0}};
        QVERIFY(diagram.crossesBefore(left, right, level, rising));
        QVERIFY(!diagram.crossesBefore(left, right, rising, level));
    }
    void cornerHasASide() {
        const Delaunay delaunay = *triangulate(std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}, {0.0, 2.0}});
        const PerturbedDiagram diagram(delaunay);
        for (std::uint32_t k = 0; k < delaunay.triangles.size(); ++k) {
            if (delaunay.triangles[k].isGhost()) continue;  // the other one is about (1, 1)
            QCOMPARE(diagram.sideOfCorner({{0.0, 0.0}, {0.0, 1.0}}, k), -1);
            QCOMPARE(diagram.sideOfCorner({{2.0, 0.0}, {2.0, 1.0}}, k), 1);
        }
    }
    /// Cells stay convex under the perturbation, so that a line enters and leaves each at most once; on a lattice, most
    /// lines pass through corners.
    void lineEntersACellAtMostOnce() {
        for (std::uint64_t number = 1; number <= 400; ++number) {
            Random random(number);
            const Delaunay delaunay = *triangulate(test::randomSeeds(random, 40, true));
            const std::vector<std::uint32_t> outgoing = outgoingHalfEdges(delaunay);
            const PerturbedDiagram diagram(delaunay);
            const DirectedLine line = latticeLine(random), back{line.to, line.from};
            for (std::uint32_t site = 0; site < delaunay.sites.size(); ++site) {
                int changes = 0;
                std::uint32_t spoke = outgoing[site];
                do {
                    const std::uint32_t triangle = Delaunay::triangleOf(spoke);
                    const std::uint32_t before = Delaunay::triangleOf(delaunay.twin(spoke));
                    const int side = diagram.sideOfCorner(line, triangle);
                    QCOMPARE(diagram.sideOfCorner(back, triangle), -side);
                    changes += side != diagram.sideOfCorner(line, before) ? 1 : 0;
                    spoke = nextAround(delaunay, spoke);
                } while (spoke != outgoing[site]);
                QVERIFY2(changes == 0 || changes == 2, qPrintable(faultOfSeed(number, std::to_string(changes))));
            }
        }
    }
    void circumcentresAreAsFarFromAllCorners() {
        QCOMPARE(circumcentre({0.0, 0.0}, {4.0, 0.0}, {0.0, 2.0}, {1.0, 1.0}, 4.0), Vec2(1.0, 0.0));
        for (std::uint64_t number = 1; number <= 2000; ++number) {
            Random random(number);
            const Vec2 a(random.unit(), random.unit()), b(random.unit(), random.unit());
            const Vec2 middle = (a + b) / 2.0, offset = perpendicular(b - a) * random.between(1e-12, 1.0);
            const Vec2 c = middle + offset;
            const Vec2 centre = circumcentre(a, b, c, {0.0, 0.0}, 1.0),
                       exact = circumcentreExactly(a, b, c, {0.0, 0.0});
            const double radius = glm::distance(exact, a);
            if (radius > 1.0) continue;  // beyond the bounding radius it is less accurate
            QVERIFY2(glm::distance(centre, exact) <= 2.0 * kConstructionError,
                     qPrintable(faultOfSeed(number, "centre")));
            QVERIFY2(std::abs(glm::distance(exact, c) - radius) < 1e-14, qPrintable(faultOfSeed(number, "radius")));
        }
    }
    void intersectionWithTheBisectorIsOnTheLine() {
        QCOMPARE(intersectionWithBisector({{0.0, 1.0}, {4.0, 1.0}}, {0.0, 0.0}, {2.0, 0.0}, {0.5, 0.5}, 4.0),
                 Vec2(0.5, 0.5));
        // An intersection at an end is that end, to the last bit.
        const Vec2 end(0.1, 0.7);
        QCOMPARE(intersectionWithBisector({end, {3.0, 0.2}}, end + Vec2(-0.25, 0.0), end + Vec2(0.25, 0.0), {}, 4.0),
                 end);
    }
};

RUBBLE_TEST(PerturbedDiagramTest)
#include "PerturbedDiagramTest.moc"
