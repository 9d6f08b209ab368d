#include "core/geometry/prism/PrismSilhouette.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

std::vector<Ring> silhouetteAlong(const TriangleMesh& mesh, Vec3 axis) {
    return silhouetteRings(viewAlong(mesh, frameAlong(axis, Vec3(0.0)), 1e-6), mesh);
}

}  // namespace

class PrismSilhouetteTest : public QObject {
    Q_OBJECT
private slots:
    void silhouetteOfABoxIsASquare() {
        const std::vector<Ring> rings = silhouetteAlong(prismSolid(unitSquare(), 3.0), {0.0, 0.0, 1.0});
        QCOMPARE(rings.size(), std::size_t{1});
        QCOMPARE(signedArea(rings[0]), 1.0);
    }
    void tubeHasAClockwiseHole() {
        const std::vector<Ring> rings = silhouetteAlong(prismSolid(squareRing(), 1.0), {0.0, 0.0, 1.0});
        QCOMPARE(rings.size(), std::size_t{2});
        QCOMPARE(signedArea(rings[0]), 16.0);
        QCOMPARE(signedArea(rings[1]), -4.0);
        QCOMPARE(silhouetteAlong(prismSolid(squareRing(), 1.0), {1.0, 0.0, 0.0}).size(), std::size_t{1});
    }
    void partsSideBySideHaveARingEach() {
        const TriangleMesh box = prismSolid(unitSquare(), 1.0);
        const TriangleMesh two = joined(box, placed(box, {{3.0, 0.0, 0.0}}));
        QCOMPARE(silhouetteAlong(two, {0.0, 0.0, 1.0}).size(), std::size_t{2});
        QCOMPARE(silhouetteAlong(two, {1.0, 0.0, 0.0}).size(), std::size_t{1});
    }
    void meshWithoutExtentHasNone() { QVERIFY(silhouetteAlong({{{1, 2, 3}}, {}}, {0.0, 0.0, 1.0}).empty()); }
    void shadowOfACubeIsTheSumOfItsAxis() {  // the area of a unit cube seen along (a, b, c) is |a| + |b| + |c|
        const TriangleMesh cube = prismSolid(unitSquare(), 1.0);
        for (std::uint64_t number = 1; number <= 200; ++number) {
            Random random(number);
            const Vec3 axis =
                glm::normalize(Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
            const std::vector<Ring> rings = silhouetteAlong(cube, axis);
            const std::string name = "random seed " + std::to_string(number);
            QVERIFY2(rings.size() == 1, name.c_str());
            const double expected = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
            QVERIFY2(std::abs(signedArea(rings[0]) - expected) < 1e-6, name.c_str());  // corners are on a lattice
        }
    }
};

RUBBLE_TEST(PrismSilhouetteTest)
#include "PrismSilhouetteTest.moc"
