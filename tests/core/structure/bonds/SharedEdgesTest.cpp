#include "core/structure/bonds/SharedEdges.h"

#include "core/fracture/fragments/Extrusion.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/RandomPartitions.h"

#include <QTest>

using namespace rubble;

class SharedEdgesTest : public QObject {
    Q_OBJECT
private slots:
    void halvesShareOneEdge() {
        const Polygon outline{rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 1.0}, {1.5, 1.0}};
        const Fragments halves = *extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds));
        const std::vector<SharedEdge> edges = sharedEdges(halves);
        QCOMPARE(edges.size(), std::size_t{1});
        QCOMPARE(edges[0].first, 0u);
        QCOMPARE(edges[0].second, 1u);
        QCOMPARE(halves.extruded()->partition.points[edges[0].from].y, 0.0);  // counter-clockwise around the left half
        QCOMPARE(halves.extruded()->partition.points[edges[0].to].y, 2.0);
    }
    void aSingleFragmentSharesNone() {
        const Polygon outline{rectangle({0.0, 0.0}, {2.0, 2.0}), {}};
        const std::vector<Vec2> seeds{{0.5, 1.0}};
        QVERIFY(sharedEdges(*extrudedFragments({outline, 0.5}, *voronoiPartition(outline, seeds))).empty());
    }
};

RUBBLE_TEST(SharedEdgesTest)
#include "SharedEdgesTest.moc"
