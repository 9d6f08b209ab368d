#include "tests/support/TestProgram.h"
#include "viewport/scene/SurfacePicking.h"

#include "core/asset/library/StarterProject.h"
#include "core/base/Random.h"
#include "core/geometry/hull/PolytopeRay.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/viewport/StarterScene.h"
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

constexpr ImageSize kViewSize{200, 200};
const Vec2 kMiddle(100.0, 100.0);

/// The starter project's wall from the front.
Camera frontCamera(const RenderScene& scene) { return framing({}, boundsOf(scene), kViewSize); }

/// The body at a pixel of that view, which does not follow the scene, at a step fraction.
std::optional<std::uint32_t> pickedAt(const RenderScene& scene, Vec2 pixel, double stepFraction = 1.0) {
    const Camera camera = frontCamera(*test::starterScene());
    const auto hit = surfaceHit(scene, rayThrough(camera, pixel, kViewSize), stepFraction);
    return hit ? std::optional(hit->body) : std::nullopt;
}

}  // namespace

class SurfacePickingTest : public QObject {
    Q_OBJECT
private slots:
    void picksTheVisibleBody() {
        const auto scene = test::starterScene();
        const Camera camera = frontCamera(*scene);
        const double scale = 1.0 / metresPerPixel(camera, kViewSize);
        for (std::uint32_t body = 0; body < scene->poses.size(); ++body) {
            const Vec3 centre = scene->origin + Vec3(scene->poses[body].position) - camera.target;
            // The front face is nearer than the target, and so a little larger.
            const double nearer = camera.distance / (camera.distance - 0.25);
            const Vec2 pixel = Vec2(100.0) + nearer * scale * Vec2(centre.x, -centre.y);
            QCOMPARE(pickedAt(*scene, pixel), std::optional(body));
        }
        QVERIFY(!pickedAt(*scene, {0.0, 0.0}));
    }
    void picksMovingBodiesAtInterpolatedPoses() {
        RenderScene moved = *test::starterScene();
        const std::uint32_t body = pickedAt(moved, kMiddle, 1.0).value();
        moved.previousPoses = moved.poses;
        moved.previousPoses[body].position += glm::vec4(4.0f, 0.0f, 0.0f, 0.0f);  // out of view
        QCOMPARE(pickedAt(moved, kMiddle, 1.0), std::optional(body));
        QVERIFY(pickedAt(moved, kMiddle, 0.5) != body);
        moved.previousPoses[body].position -= glm::vec4(8.0f, 0.0f, 0.0f, 0.0f);
        for (RenderPose& now : moved.poses)
            now.position.x += 4.0f;  // at half the step they are at their original poses
        for (std::uint32_t k = 0; k < moved.previousPoses.size(); ++k) {
            if (k != body) moved.previousPoses[k].position.x -= 4.0f;
        }
        QCOMPARE(pickedAt(moved, kMiddle, 0.5), std::optional(body));
        QVERIFY(pickedAt(moved, kMiddle, 1.0) != body);
    }
    void hiddenBodiesAreNotPicked() {
        const auto all = test::starterScene();
        const std::uint32_t body = pickedAt(*all, kMiddle).value();
        QVERIFY(pickedAt(*test::starterScene({.hidden = {all->picks[body]}}), kMiddle) != body);
    }
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
