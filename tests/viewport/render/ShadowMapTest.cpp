#include "tests/support/TestProgram.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/Lighting.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

/// Towards the key light.
Vec3 studioSun() { return skyOf(SkyPreset::Studio, Theme::Light).sunDirection; }

constexpr ImageSize kShadowPicture{300, 300};

/// A camera high above the ground that sees `radius` m around a point of it.
RenderView fromAbove(Vec3 target, double radius) {
    RenderView view{.size = kShadowPicture};
    view.camera = alignedTo(view.camera, StandardView::Top);
    view.camera.projection = Projection::Orthographic;
    view.camera.target = target;
    view.camera.distance *= radius / (0.5 * kShadowPicture.height * metresPerPixel(view.camera, kShadowPicture));
    view.settings.hasAxes = view.settings.hasGrid = false;
    view.settings.msaa = 1;
    return view;
}

/// How much a picture is darkened by shadows at a point of the world, from 0 to 255.
int shadowAt(const RenderScene& scene, RenderView view, Vec3 point, int samples = 0) {
    const auto shared = std::make_shared<const RenderScene>(scene);
    const Vec2 pixel = pixelOf(view.camera, point, view.size).value();
    const auto lightness = [&] {
        const Image image = renderImage(shared, view, samples).value();
        const auto at = 3 * (static_cast<std::size_t>(pixel.y) * 300 + static_cast<std::size_t>(pixel.x));
        return static_cast<int>(image.pixels[at]);
    };
    const int shaded = lightness();
    view.settings.hasShadows = false;
    return lightness() - shaded;
}

/// Where the key light's shadow of a point falls on the ground.
Vec3 shadowOf(Vec3 point, double groundHeight) {
    return point - (point.y - groundHeight) / studioSun().y * studioSun();
}

}  // namespace

class ShadowMapTest : public QObject {
    Q_OBJECT
private slots:
    void shadowOfABodyHighAboveTheGroundIsWhole() {
        RenderScene scene = *test::starterScene();
        for (RenderPose& pose : scene.poses) pose.position.y += 6.0f;
        const Vec3 foot = shadowOf(boundsOf(scene).centre(), scene.groundHeight);
        for (const int samples : {0, 64}) {
            const int dark = shadowAt(scene, fromAbove(foot, 2.0), foot, samples);
            QVERIFY2(dark > 40, qPrintable(QString("%1 samples: %2").arg(samples).arg(dark)));
        }
    }
    void shadowOfATallBodyReachesItsTip() {
        RenderScene scene = *test::starterScene();
        std::erase_if(scene.batches, [](const SceneBatch& batch) { return batch.firstBodies.empty(); });
        const float up = 0.9f;  // a stack of walls
        const std::vector<RenderPose> first = scene.poses;
        const std::vector<BodyAppearance> appearances = scene.appearances;
        const std::vector<PickId> picks = scene.picks;
        for (int level = 1; level < 8; ++level) {
            scene.batches[0].firstBodies.push_back(static_cast<std::uint32_t>(scene.poses.size()));
            for (RenderPose pose : first) {
                pose.position.y += up * static_cast<float>(level);
                scene.poses.push_back(pose);
            }
            scene.appearances.insert(scene.appearances.end(), appearances.begin(), appearances.end());
            scene.picks.insert(scene.picks.end(), picks.begin(), picks.end());
        }
        const Box3 bounds = boundsOf(scene);
        const Vec3 top(bounds.centre().x, bounds.max.y - 0.1, bounds.centre().z);
        const Vec3 tip = shadowOf(top, scene.groundHeight);
        QVERIFY(shadowAt(scene, fromAbove(tip, 2.0), tip) > 40);
    }
    void shadowsGrowWithTheScene() {
        RenderScene scene = *test::starterScene();
        for (const float apart : {5.0f, 50.0f}) {  // one fragment flies away
            scene.poses[0].position = {apart, 1.0f, 0.0f, 0.0f};
            scene.summary.reset();
            const Vec3 foot = shadowOf(scene.origin + Vec3(scene.poses[0].position), scene.groundHeight);
            QVERIFY(shadowAt(scene, fromAbove(foot, 1.0), foot) > 40);
        }
    }
};

RUBBLE_TEST_WITH(ShadowMapTest, QCoreApplication)
#include "ShadowMapTest.moc"
