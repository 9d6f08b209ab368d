// Tests core/geometry/mesh/MeshContainment.cpp.
#include "core/geometry/mesh/MeshContainment.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <set>

using namespace rubble;
using namespace rubble::test;

class MeshContainmentTest : public QObject {
    Q_OBJECT
private slots:
    /// Points of a grid, half of which lie on faces, edges and corners, and below others.
    void pointsOfAGridInCubes() {
        Random random(1);
        for (int round = 0; round < 200; ++round) {
            std::set<std::array<int, 3>> filled;
            for (int k = 0; k < 27; ++k) {
                if (random.below(2) == 0) filled.insert({k % 3, k / 3 % 3, k / 9});
            }
            if (filled.empty()) continue;
            const TriangleMesh mesh = cubes(filled);
            const MeshContainment index(mesh);
            for (int k = 0; k < 15 * 15 * 15; ++k) {
                const std::array<int, 3> half = {k % 15 - 4, k / 15 % 15 - 4, k / 225 - 4};
                int in = 0, all = 0;  // of the cells around the point
                for (int near = 0; near < 8; ++near) {
                    std::array<int, 3> cell{};
                    bool isAround = true;
                    for (int axis = 0; axis < 3; ++axis) {
                        const int offset = near >> axis & 1;
                        isAround = isAround && (half[axis] % 2 == 0 || offset == 0);
                        cell[axis] = (half[axis] - (half[axis] % 2 == 0 ? offset : 0)) >> 1;
                    }
                    if (!isAround) continue;
                    ++all;
                    in += filled.contains(cell);
                }
                const Containment expected = in == 0     ? Containment::Outside
                                             : in == all ? Containment::Inside
                                                         : Containment::OnBoundary;
                QCOMPARE(index.containment(Vec3(half[0], half[1], half[2]) / 2.0), expected);
            }
        }
    }
    void pointsInARoundMesh() {
        const TriangleMesh mesh = torus(40, 20);
        const MeshContainment index(mesh);
        Random random(2);
        int inside = 0;
        for (int k = 0; k < 20'000; ++k) {
            const Vec3 p(random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(-0.5, 0.5));
            const double ring = glm::length(Vec2(p)) - 1.0, distance = glm::length(Vec2(ring, p.z));
            if (distance > 0.38 && distance < 0.401) continue;  // between the mesh and the torus that it stands for
            QCOMPARE(index.isInside(p), distance < 0.39);
            inside += index.isInside(p);
        }
        QVERIFY(inside > 1000);
        for (const Vec3 corner : mesh.points) QCOMPARE(index.containment(corner), Containment::OnBoundary);
    }
};

RUBBLE_TEST(MeshContainmentTest)
#include "MeshContainmentTest.moc"
