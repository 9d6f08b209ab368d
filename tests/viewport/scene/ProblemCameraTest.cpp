// Tests viewport/scene/ProblemCamera.cpp.
#include "tests/support/TestProgram.h"
#include "viewport/scene/ProblemCamera.h"
#include "viewport/scene/SurfacePicking.h"

#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <glm/geometric.hpp>

#include <QTest>

#include <numbers>

using namespace rubble;

namespace {

const TriangleMesh kWall = prismSolid({rectangle({0, 0}, {2, 1}), {}}, 0.5);

SourceModel modelOf(const TriangleMesh& mesh) {
    SourceObject object{.name = "wall", .points = mesh.points};
    for (const auto& triangle : mesh.triangles) object.triangles.push_back({triangle, {}, 0});
    return sourceModel({0.0, {{}}, {object}}, 1.0, UpAxis::Y);
}

/// A problem at one triangle of a mesh.
MeshProblem problemAt(const TriangleMesh& mesh, std::size_t triangle) {
    MeshProblem problem;
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.points[mesh.triangles[triangle][k]];
    problem.triangles = {corners};
    problem.place = (corners[0] + corners[1] + corners[2]) / 3.0;
    return problem;
}

Camera from(double azimuthDegrees, double elevationDegrees) {
    Camera camera;
    camera.azimuth = azimuthDegrees * std::numbers::pi / 180.0;
    camera.elevation = elevationDegrees * std::numbers::pi / 180.0;
    return camera;
}

}  // namespace

class ProblemCameraTest : public QObject {
    Q_OBJECT
private slots:
    void everySideIsSeenFromEverywhere() {
        const SourceModel model = modelOf(kWall);
        for (std::size_t triangle = 0; triangle < kWall.triangles.size(); ++triangle) {
            const MeshProblem problem = problemAt(kWall, triangle);
            const auto& [a, b, c] = problem.triangles.front();
            const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
            for (const double azimuth : {0.0, 100.0, 190.0}) {
                for (const double elevation : {-60.0, 20.0}) {
                    const Vec3 back = axesOf(facing(problem, model, from(azimuth, elevation))).back;
                    QVERIFY(glm::dot(back, normal) > 0.1);
                    QVERIFY(!surfaceHit(importScene(model, {}), {problem.place + 1e-3 * back, back}));
                }
            }
        }
    }
    void edgesOfAHoleFaceTheCamera() {
        TriangleMesh open = kWall;
        const MeshProblem missing = problemAt(kWall, 0);  // of the back, at z = -0.25
        open.triangles.erase(open.triangles.begin());
        const auto& [a, b, c] = missing.triangles.front();
        const MeshProblem hole{"", a, {}, {{a, b}, {b, c}, {c, a}}};
        QVERIFY(axesOf(facing(hole, modelOf(open), from(0, 20))).back.z < -0.3);
    }
    void cameraThatSeesThePlaceStays() {
        const SourceModel model = modelOf(kWall);
        const Camera camera = from(10, 20);
        QVERIFY(facing(problemAt(kWall, 1), model, camera) == camera);  // of the front
    }
    void cameraStaysWhereNothingIsSeen() {
        const TriangleMesh inner = prismSolid({rectangle({0.7, 0.25}, {1.3, 0.75}), {}}, 0.46);
        const SourceModel model = modelOf(joined(kWall, inner));
        MeshProblem problem = problemAt(inner, 0);
        const Camera camera = from(10, 20);
        QVERIFY(facing(problem, model, camera) == camera);
    }
    void targetAndDistanceStay() {
        Camera camera = from(0, 0);
        camera.target = {1, 2, 3};
        camera.distance = 7.0;
        const Camera rotated = facing(problemAt(kWall, 0), modelOf(kWall), camera);
        QVERIFY(rotated != camera);
        QCOMPARE(rotated.target, camera.target);
        QCOMPARE(rotated.distance, camera.distance);
    }
};

RUBBLE_TEST_WITH(ProblemCameraTest, QCoreApplication)
#include "ProblemCameraTest.moc"
