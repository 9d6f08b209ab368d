#include "tests/support/TestProgram.h"
#include "viewport/scene/SurfacePicking.h"

#include "core/asset/library/StarterProject.h"
#include "core/base/Random.h"
#include "core/geometry/hull/PolytopeRay.h"
#include "tests/support/asset/Projects.h"
#include "viewport/scene/SceneBuilder.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

Project scatteredBox() {
    Project project;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{.count = 40})};
    project.instances = {{.id = 4, .name = "a", .asset = 2, .pose = {{1.0, 2.0, 3.0}, {0.8, 0.0, 0.6, 0.0}}}};
    return project;
}

}  // namespace

class SurfacePickingTest : public QObject {
    Q_OBJECT
private slots:
    /// Compares with ray casts against the hulls of all fragments.
    void raysHitTheNearestSurface() {
        const Project project = scatteredBox();
        const auto baked = std::make_shared<const Bake>(*bake(project.assets[0]));
        const RenderScene scene = sceneOf(project, {{{2, 0}, baked}});
        const Pose& pose = project.instances[0].pose;
        const Vec3 middle = pose.position + pose.orientation * Vec3(0.5, 0.5, 0.0);
        Random random(31);
        int hits = 0;
        for (int k = 0; k < 500; ++k) {
            const Vec3 from(random.between(-3.0, 5.0), random.between(0.0, 5.0), random.between(8.0, 10.0));
            const Vec3 to = middle + Vec3(random.between(-0.7, 0.7), random.between(-0.7, 0.7), 0.0);
            const Ray ray{from, glm::normalize(to - from)};
            double nearest = 1e308;
            std::uint32_t expected = kNone;
            for (std::uint32_t piece = 0; piece < baked->fragmentCount(); ++piece) {
                const Fragment solid = baked->fragment(piece).solid;
                const Quat back = glm::conjugate(pose.orientation);
                const Ray local{back * (ray.from - pose.position) - solid.offset(), back * ray.direction};
                const auto entry = castRay(solid.hulls()[0], local);
                if (!entry || entry->distance >= nearest) continue;
                nearest = entry->distance;
                expected = piece;
            }
            const auto found = surfaceHit(scene, ray);
            QCOMPARE(found.has_value(), expected != kNone);
            if (!found) continue;
            ++hits;
            QVERIFY(glm::distance(found->point, ray.at(nearest)) < 1e-5);  // the scene's vertices are floats
        }
        QVERIFY(hits > 100);
    }
    void raysPassHiddenBodies() {
        const Project project = scatteredBox();
        const auto baked = std::make_shared<const Bake>(*bake(project.assets[0]));
        RenderScene scene = sceneOf(project, {{{2, 0}, baked}});
        const Vec3 middle =
            project.instances[0].pose.position + project.instances[0].pose.orientation * Vec3(0.5, 0.5, 0.0);
        const Ray ray{middle + Vec3(0.0, 0.0, 9.0), {0.0, 0.0, -1.0}};
        const auto first = surfaceHit(scene, ray);
        QVERIFY(first);
        setMarks(scene, {.hidden = {scene.picks[first->body]}});
        const auto second = surfaceHit(scene, ray);
        QVERIFY(!second || second->body != first->body);
        setMarks(scene, {.hidden = {{2, 0, kNone}}});
        QVERIFY(!surfaceHit(scene, ray));
    }
    void findsTheNearestFrontVertex() {
        Project project = scatteredBox();
        project.assets[0].pattern.layers.clear();
        project.instances[0].pose = {};
        const auto baked = std::make_shared<const Bake>(*bake(project.assets[0]));
        const RenderScene scene = sceneOf(project, {{{2, 0}, baked}});
        Camera camera = framing(alignedTo(Camera{}, StandardView::Front), boundsOf(scene), {400, 400});
        camera.projection = Projection::Orthographic;
        const Vec3 corner(1.0, 1.0, 0.25);
        const Vec2 pixel = *pixelOf(camera, corner, {400, 400});
        const auto near = cornerNear(scene, 0, camera, {400, 400}, pixel + Vec2(4.0, -3.0), 8.0);
        QVERIFY(near && glm::distance(*near, corner) < 1e-6);  // not the one behind it
        QVERIFY(!cornerNear(scene, 0, camera, {400, 400}, pixel + Vec2(9.0, 0.0), 8.0));
        QVERIFY(!cornerNear(scene, 0, camera, {400, 400}, Vec2(200.0, 200.0), 8.0));  // a fan's centre is no vertex
    }
};

RUBBLE_TEST_WITH(SurfacePickingTest, QCoreApplication)
#include "SurfacePickingTest.moc"
