#include "core/structure/bonds/FaceEdges.h"

#include "core/fracture/fragments/Extrusion.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

class FaceEdgesTest : public QObject {
    Q_OBJECT
private slots:
    void halvesHaveOneEdgeFromOutlineToOutline() {
        const Polygon outline{rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 1.0}, {1.5, 1.0}};
        const Fragments all = *extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds));
        const std::vector<FaceEdge> edges = faceEdges(all, bondsOf(all, Seeds{.positions = seeds}));
        QCOMPARE(edges.size(), std::size_t{1});
        QCOMPARE(edges[0].from.x, 1.0);
        QCOMPARE(edges[0].to.x, 1.0);
        QCOMPARE(std::minmax(edges[0].from.y, edges[0].to.y), std::minmax(0.0, 2.0));
        QVERIFY(edges[0].startsOutside && edges[0].endsOutside);
    }
    void endsInsideAreNotOutside() {
        const Polygon outline{rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 0.5}, {1.5, 0.5}, {1.0, 1.5}};  // three edges meet in the middle
        const Fragments all = *extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds));
        const std::vector<FaceEdge> edges = faceEdges(all, bondsOf(all, Seeds{.positions = seeds}));
        QCOMPARE(edges.size(), std::size_t{3});
        for (const FaceEdge& edge : edges) QVERIFY(edge.startsOutside != edge.endsOutside);
    }
    void edgesFillTheFacesOfRandomBonds() {
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            const test::RandomPartition made = test::randomPartition(random, static_cast<int>(seed % 2));
            const Fragments all = *extrudedFragments({made.outline, 0.5}, made.partition);
            const std::vector<Bond> bonds = bondsOf(all, Seeds{.positions = made.seeds});
            std::vector<double> areas(bonds.size(), 0.0);
            for (const FaceEdge& edge : faceEdges(all, bonds))
                areas[edge.bond] += all.extruded()->depth * glm::distance(edge.from, edge.to);
            for (std::size_t k = 0; k < bonds.size(); ++k) {
                const bool isEqual = std::abs(areas[k] - bonds[k].area) <= 1e-12 * bonds[k].area + 1e-14;
                QVERIFY2(isEqual, qPrintable(faultOfSeed(seed, "the edges of a bond do not sum to its area")));
            }
        }
    }
};

RUBBLE_TEST(FaceEdgesTest)
#include "FaceEdgesTest.moc"
