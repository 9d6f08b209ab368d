// Tests core/geometry/mesh/Mesh.cpp and core/geometry/mesh/VerifyMesh.cpp.
#include "core/geometry/mesh/Mesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Meshes.h"

#include <glm/geometric.hpp>

#include <QTest>

#include <array>

using namespace rubble;

namespace {

/// A tetrahedron whose bottom is a needle, with the normal of that turned by 0.05 about its longest edge.
Mesh needleMesh() {
    constexpr double kWidth = 1e-9;
    Mesh mesh;
    mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, kWidth, 0.0}, {0.5, 0.0, 1.0}};
    mesh.uvs = {{0.0, 0.0}};
    constexpr std::uint32_t kCorners[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (std::uint32_t face = 0; face < 4; ++face) {
        const auto& corners = kCorners[face];
        const Vec3 a = mesh.positions[corners[0]];
        const Vec3 area = glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a);
        mesh.normals.push_back(glm::normalize(face == 0 ? Vec3(0.0, 0.05, -1.0) : area));
        mesh.faces.push_back({3 * face, 3, face, 0, FaceSide::Outside});
        for (const std::uint32_t corner : corners) mesh.corners.push_back({corner, 0});
    }
    return mesh;
}

std::string faultOf(const Mesh& mesh) { return verifyMesh(mesh, 8.0).value_or(""); }

}  // namespace

class MeshTest : public QObject {
    Q_OBJECT
private slots:
    void boxIsClosed() {
        QCOMPARE(volumeOf(boxMesh()), 8.0);
        QCOMPARE(faultOf(boxMesh()), "");
        QCOMPARE(volumeOf(Mesh{}), 0.0);
    }
    void capsBecomeFansAndSidesAreSplit() {
        const Mesh triangles = triangulated(boxMesh());
        QCOMPARE(triangles.faces.size(), std::size_t{2 * 4 + 4 * 2});
        QCOMPARE(triangles.positions.size(), std::size_t{10});
        QVERIFY(triangles.positions[8] == Vec3(0.0, 0.0, 1.0));
        QVERIFY(triangles.positions[9] == Vec3(0.0, 0.0, -1.0));
        QVERIFY(triangles.uvs[8] == Vec2(0.0, 0.0));
        for (const MeshFace& face : triangles.faces) QCOMPARE(face.cornerCount, 3u);
        QCOMPARE(faultOf(triangles), "");
        QVERIFY(triangles.faces[11].side == FaceSide::Outside && triangles.faces[12].side == FaceSide::Inside);
    }
    void trianglesAreUnchanged() {
        const Mesh triangles = triangulated(boxMesh());
        QCOMPARE(triangulated(triangles).positions.size(), triangles.positions.size());
        QCOMPARE(triangulated(triangles).faces.size(), triangles.faces.size());
    }
    /// What is cut from a large mesh is rounded as that is, so that its faces may be thinner than its own rounding.
    void needlesOfWhatWasCutHaveNoOrientation() {
        Mesh box = boxMesh();
        box.faces.push_back(box.faces[3]);  // a needle that stands on its plane
        box.faces.back().firstCorner = static_cast<std::uint32_t>(box.corners.size());
        box.faces.back().cornerCount = 3;
        const std::array<MeshCorner, 2> edge{box.cornersOf(box.faces[3])[0], box.cornersOf(box.faces[3])[1]};
        const Vec3 middle = (box.positions[edge[0].position] + box.positions[edge[1].position]) / 2.0;
        box.positions.push_back(middle + 1e-10 * box.normals[3]);
        box.corners.insert(box.corners.end(), {edge[0], edge[1], {8, edge[1].uv}});
        QCOMPARE(faultOf(box), "Face 6 is not counter-clockwise about its normal.");
        QVERIFY(!verifyMesh(box, 8.0, 1000.0).value_or("").starts_with("Face 6 is not"));
    }
    void everyFaultIsReported_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<QString>("message");
        const char* messages[] = {
            "Face 2 has fewer than three corners.",
            "Face 5 lacks corners.",
            "Face 4 has no normal.",
            "Face 0 has a corner without a position.",
            "Face 0 has a corner without texture coordinates.",
            "Face 3 has a normal not of length 1.",
            "Face 3 is not counter-clockwise about its normal.",
            "Face 0 is not counter-clockwise about its normal.",
            "Face 5 is an outside face after an inside one.",
            "Edge 0-4 is open.",
            "Edge 0-1 is used twice in the same direction.",
            "The volume is 8 instead of 7.5.",
        };
        for (int i = 0; i < 12; ++i) QTest::addRow("%d", i) << i << QString(messages[i]);
    }
    void everyFaultIsReported() {
        QFETCH(int, fault);
        QFETCH(QString, message);
        Mesh box = boxMesh();
        switch (fault) {
            case 0: box.faces[2].cornerCount = 2; break;
            case 1: box.faces[5].cornerCount = 5; break;
            case 2: box.faces[4].normal = 6; break;
            case 3: box.corners[1].position = 8; break;
            case 4: box.corners[1].uv = 8; break;
            case 5: box.normals[3] *= 0.5; break;
            case 6: box.normals[3] = {0.0, 0.0, 1.0}; break;
            case 7: std::swap(box.corners[1], box.corners[3]); break;
            case 8: box.faces[5].side = FaceSide::Outside; break;
            case 9: box.faces.pop_back(); break;
            case 10: box.faces.insert(box.faces.begin(), box.faces[0]); break;
            default: break;
        }
        const double expectedVolume = fault == 11 ? 7.5 : 8.0;
        QCOMPARE(QString::fromStdString(verifyMesh(box, expectedVolume).value_or("")), message);
    }
    void needlesAreRoundedAsWhatTheyAreCutFrom() {
        const Mesh needle = needleMesh();
        const double volume = volumeOf(needle);
        const auto fault = [&](double extent) {
            return QString::fromStdString(verifyMesh(needle, volume, extent).value_or(""));
        };
        QCOMPARE(fault(0.0), "Face 0 is not counter-clockwise about its normal.");
        QCOMPARE(fault(1.0), "Face 0 is not counter-clockwise about its normal.");
        QCOMPARE(fault(10.0), "");
    }
};

RUBBLE_TEST(MeshTest)
#include "MeshTest.moc"
