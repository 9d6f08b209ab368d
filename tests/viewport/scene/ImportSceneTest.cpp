// Tests viewport/scene/ImportScene.cpp and viewport/scene/SurfaceGeometry.cpp.
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "viewport/scene/ImportScene.h"
#include "viewport/scene/SurfaceGeometry.h"

#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

using namespace rubble;

namespace {

SourceScene sceneOf(const TriangleMesh& mesh) {
    SourceObject object{.name = "wall", .points = mesh.points};
    for (const auto& triangle : mesh.triangles) object.triangles.push_back({triangle, {}, 0});
    return {0.0, {{}}, {object}};
}

TriangleMesh wallMesh() { return prismSolid({rectangle({0, 0}, {2, 1}), {}}, 0.5); }

/// The number of vertices on visible edges.
std::size_t edgeCorners(const SceneGeometry& geometry) {
    return static_cast<std::size_t>(std::ranges::count_if(
        geometry.vertices, [](const SceneVertex& vertex) { return vertex.across[0] == 0 || vertex.across[1] == 0; }));
}

}  // namespace

class ImportSceneTest : public QObject {
    Q_OBJECT
private slots:
    void meshIsScaledToMetresAndYUp() {
        const SourceModel model = sourceModel(sceneOf(wallMesh()), 0.1, UpAxis::Z);
        const Box3 bounds = boundsOf(importScene(model, {}));
        QVERIFY(isWithinDistance(bounds.max - bounds.min, {0.2, 0.05, 0.1}, 1e-6));
        QVERIFY(isWithinDistance(bounds.min, {0.0, -0.025, -0.1}, 1e-6));
    }
    void keepsPrecisionFarFromTheOrigin() {
        const SourceModel model = sourceModel(sceneOf(placed(wallMesh(), {{1e7, 0, 0}})), 1.0, UpAxis::Y);
        const Box3 bounds = boundsOf(importScene(model, {}));
        QVERIFY(isWithinDistance(bounds.max - bounds.min, {2.0, 1.0, 0.5}, 1e-6));
    }
    void prismOverlaysItsMeshAndArrowFollowsItsAxis() {
        const TriangleMesh mesh = placed(wallMesh(), {{3, 4, 5}, Quat(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0)});
        const Result<PrismFit> found = fitPrism(mesh, PrismAxis::Thinnest, 1e-5);
        QVERIFY(found.hasValue());
        const RenderScene scene = importScene(sourceModel(sceneOf(mesh), 1.0, UpAxis::Y), {.prism = &*found});
        QCOMPARE(scene.batches.size(), std::size_t{3});
        QVERIFY(!scene.batches[1].hulls->indices.empty());
        QVERIFY(scene.batches[1].geometry->indices.empty());
        const Vec3 middle = boundsOf(mesh).centre();
        for (const std::size_t body : {1, 2}) {
            QVERIFY(isWithinDistance(scene.origin + Vec3(glm::vec3(scene.poses[body].position)), middle, 1e-6));
        }
        const Box3 bounds = boundsOf(scene);
        QVERIFY(std::abs(bounds.max.x - bounds.min.x - 1.7) < 1e-6);  // 0.5, and 0.3 of 2 beyond each cap
        QCOMPARE(scene.groundHeight, boundsOf(mesh).min.y);
    }
    void closedMeshHasABox() {
        const TriangleMesh mesh = placed(wallMesh(), {{30, 4, 5}});
        const SolidFit solid = *fittedSolid(mesh, {})->solid;
        const RenderScene scene = importScene(sourceModel(sceneOf(mesh), 1.0, UpAxis::Y), {.solid = &solid});
        QCOMPARE(scene.batches.size(), std::size_t{1});
        QCOMPARE(scene.boxes.size(), std::size_t{1});
        QVERIFY(isWithinDistance(scene.origin + Vec3(glm::vec3(scene.boxes[0].from)), boundsOf(mesh).min, 1e-5));
        QVERIFY(isWithinDistance(scene.origin + Vec3(glm::vec3(scene.boxes[0].to)), boundsOf(mesh).max, 1e-5));
    }
    void problemsAreMarkedInRed() {
        TriangleMesh mesh = placed(wallMesh(), {{30, 4, 5}});
        mesh.triangles.pop_back();
        const std::vector problems{*fittedSolid(mesh, {})->problem};
        const SourceModel model = sourceModel(sceneOf(mesh), 1.0, UpAxis::Y);
        const RenderScene scene = importScene(model, {.problems = problems});
        QCOMPARE(scene.appearances.size(), std::size_t{3});  // above and below the surface
        QCOMPARE(scene.appearances[1].outside, 0xe8372cu);
        QCOMPARE(scene.lines.size(), std::size_t{3});
        const Vec3 from = scene.origin + Vec3(glm::vec3(scene.lines[0].from));
        QVERIFY(isWithinDistance(from, problems[0].edges[0][0], 1e-5));
        QVERIFY(isWithinDistance(boundsOf(scene).max, boundsOf(mesh).max, 0.01));
    }
    void problemIsFramedWithItsSurroundings() {
        TriangleMesh mesh = wallMesh();
        const SourceModel model = sourceModel(sceneOf(mesh), 1.0, UpAxis::Y);
        const MeshProblem small{"", {2, 1, 0}, {}, {{Vec3(2, 1, 0), Vec3(2, 0.7, 0)}}};
        const Box3 box = surroundingsOf(small, model);
        QVERIFY(box.min.y < 0.71 && box.max.y > 1.1 && box.diagonal() < 1.0);
        const MeshProblem wide{"", {2, 1, 0}, {}, {{Vec3(2, 1, 0), Vec3(2, 1, 0)}, {Vec3(0, 0, 0), Vec3(0, 1, 0)}}};
        QVERIFY(surroundingsOf(wide, model).min.x > 1.5);
    }
    void drawsBothSidesAndHidesFlatEdges() {
        SceneGeometry geometry;
        addSurface(geometry, wallMesh());
        QCOMPARE(geometry.indices.size(), 3 * 2 * wallMesh().triangles.size());
        // Each side has two triangles, each with two visible edges: all its vertices lie on one.
        QCOMPARE(edgeCorners(geometry), geometry.vertices.size());
        SceneGeometry apart;  // as in STL: triangles share no vertices
        TriangleMesh soup;
        for (const auto& triangle : wallMesh().triangles) {
            for (const std::uint32_t point : triangle) soup.points.push_back(wallMesh().points[point]);
            const auto first = static_cast<std::uint32_t>(soup.points.size() - 3);
            soup.triangles.push_back({first, first + 1, first + 2});
        }
        addSurface(apart, soup);
        QCOMPARE(apart.vertices.size(), geometry.vertices.size());
        QCOMPARE(apart.vertices.size(),
                 apart.indices.size());  // no fan around a centre: no triangle has three visible edges
    }
    void boundaryEdgesAreVisible() {
        TriangleMesh triangle;
        triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        triangle.triangles = {{0, 1, 2}};
        SceneGeometry geometry;
        addSurface(geometry, triangle);
        QCOMPARE(edgeCorners(geometry), std::size_t{6});
        QCOMPARE(geometry.vertices.size(), std::size_t{8});
    }
};

RUBBLE_TEST_WITH(ImportSceneTest, QCoreApplication)
#include "ImportSceneTest.moc"
