// Tests the overlays of viewport/render/RenderPasses.cpp: lines, boxes, dust, scale bar.
#include "core/asset/library/StarterProject.h"
#include "core/asset/project/FragmentColours.h"
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/Pictures.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/scene/play/OverlayColours.h"

#include <QTest>

#include <set>

using namespace rubble;

namespace {

constexpr ImageSize kPictureSize{200, 200};
constexpr glm::vec4 kRed{1.0f, 0.0f, 0.0f, 1.0f};

/// A wall of 1 x 1 x 0.5 m about its origin.
RenderScene centredWall() {
    RenderScene scene = sceneOf(starterProject(), {});
    const Vec3 middle = boundsOf(scene).centre();
    for (RenderPose& motion : scene.poses) motion.position += glm::vec4(glm::vec3(scene.origin - middle), 0.0f);
    return scene;
}

/// From the front, without shadows. `scale`: pixels per point.
QImage picture(const RenderScene& scene, double scale = 1.0) {
    RenderView view{.size = kPictureSize};
    view.camera = framing(view.camera, boundsOf(centredWall()), kPictureSize);
    view.settings.hasShadows = view.settings.hasAxes = false;
    view.settings.msaa = 1;
    view.settings.scale = scale;
    const Image image = renderImage(std::make_shared<RenderScene>(scene), view, 0).value();
    return QImage(image.pixels.data(), kPictureSize.width, kPictureSize.height, 3 * kPictureSize.width,
                  QImage::Format_RGB888)
        .copy();
}

bool isRed(const QImage& image, int x, int y) {
    const QColor colour = image.pixelColor(x, y);
    return colour.red() > 200 && colour.green() < 60;
}

}  // namespace

class OverlayPictureTest : public QObject {
    Q_OBJECT
private slots:
    void lineHasItsPositionAndWidth() {
        RenderScene scene = centredWall();
        const float front = 0.6f;  // in front of the wall, m
        scene.lines = {{glm::vec4(-0.3f, 0.0f, front, 4.0f), glm::vec4(0.3f, 0.0f, front, 0.0f), kRed}};
        for (const int scale : {1, 2}) {
            const QImage seen = picture(scene, scale);
            QVERIFY(isRed(seen, 100, 100) && !isRed(seen, 20, 100));
            int wide = 0;
            for (int y = 60; y < 140; ++y) wide += isRed(seen, 100, y) ? 1 : 0;
            QVERIFY2(std::abs(wide - 8 * scale) <= 1, qPrintable(QString::number(wide)));
        }
    }
    void occludedLineIsFaint() {
        RenderScene scene = centredWall();
        const QColor wall = picture(scene).pixelColor(100, 100);
        scene.lines = {{glm::vec4(-0.3f, 0.0f, -0.6f, 4.0f), glm::vec4(0.3f, 0.0f, -0.6f, 0.0f), kRed}};
        const QImage seen = picture(scene);
        QVERIFY(!isRed(seen, 100, 100));
        QVERIFY(seen.pixelColor(100, 100).green() < wall.green() - 20);
    }
    void boxIsDrawnAsItsEdges() {
        RenderScene scene = centredWall();
        scene.boxes = {{glm::vec4(-0.3f, -0.3f, 0.5f, 2.0f), glm::vec4(0.3f, 0.3f, 0.6f, 0.0f), kRed}};
        const QImage seen = picture(scene);
        QVERIFY(!isRed(seen, 100, 100));
        int edges = 0;
        for (int x = 1; x < 200; ++x) edges += isRed(seen, x, 100) && !isRed(seen, x - 1, 100) ? 1 : 0;
        QVERIFY2(edges == 2 || edges == 4, qPrintable(QString::number(edges)));  // near and far edges may coincide
    }
    void dustIsOccludedByWalls() {
        RenderScene scene = centredWall();
        const QImage clear = picture(scene);
        const auto puffAt = [&](float z) {
            scene.particles = {
                {glm::vec4(0.0f, 0.0f, z, 0.3f), glm::vec4(0.0f, 0.0f, 0.0f, 0.9f), glm::vec4(1.0f, 1.0f, 1.0f, 0.3f)}};
            return test::meanDifference(picture(scene).copy(80, 80, 40, 40), clear.copy(80, 80, 40, 40));
        };
        QVERIFY(puffAt(1.0f) > 8.0);
        QVERIFY(puffAt(-1.0f) < 0.01);
        QVERIFY(puffAt(0.26f) < puffAt(1.0f));  // it fades at the wall
    }
    void outdoorSceneHasHorizonAndScaleBar() {
        RenderScene scene = centredWall();
        scene.isOutdoors = true;
        const QImage seen = picture(scene);
        QVERIFY(seen.pixelColor(5, 5).blue() > seen.pixelColor(5, 5).red() + 3);   // sky
        QVERIFY(seen.pixelColor(5, 190).red() >= seen.pixelColor(5, 190).blue());  // ground
        int dark = 0;  // of the bar, which is 22 points from the corner
        for (int y = 170; y < 185; ++y) dark += seen.pixelColor(170, y).lightness() < 110 ? 1 : 0;
        QVERIFY(dark >= 1 && dark <= 3);
    }
};

RUBBLE_TEST_WITH(OverlayPictureTest, QCoreApplication)
#include "OverlayPictureTest.moc"
