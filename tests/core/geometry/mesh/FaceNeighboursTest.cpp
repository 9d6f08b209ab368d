// Tests core/geometry/mesh/FaceNeighbours.cpp.
#include "core/geometry/mesh/FaceNeighbours.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Meshes.h"

#include <QTest>

#include <set>

using namespace rubble;

class FaceNeighboursTest : public QObject {
    Q_OBJECT
private slots:
    /// Each face of a box has the four beside it, but not the one opposite.
    void facesOfABoxHaveFourNeighbours() {
        const Mesh box = boxMesh();
        const FaceNeighbours neighbours(box);
        for (std::uint32_t face = 0; face < 6; ++face) {
            std::set<std::uint32_t> beside;
            neighbours.forEachAround(box, face, [&](std::uint32_t other) { beside.insert(other); });
            QCOMPARE(beside.size(), std::size_t{4});
            QVERIFY(!beside.contains(face));
            for (const std::uint32_t other : beside) {
                const Vec3 normal = box.normals[box.faces[face].normal];
                QCOMPARE(glm::dot(normal, box.normals[box.faces[other].normal]), 0.0);
            }
        }
    }
    void edgesOfOpenMeshesHaveNone() {
        Mesh open = boxMesh();
        open.faces.pop_back();  // the left one
        const FaceNeighbours neighbours(open);
        int count = 0;
        for (std::uint32_t face = 0; face < 5; ++face)
            neighbours.forEachAround(open, face, [&](std::uint32_t) { ++count; });
        QCOMPARE(count, 2 * 8);  // of 12 edges, all but four
    }
};

RUBBLE_TEST(FaceNeighboursTest)
#include "FaceNeighboursTest.moc"
