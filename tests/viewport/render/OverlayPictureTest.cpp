// Tests the overlays of viewport/render/RenderPasses.cpp: lines, boxes, dust, chips, decals, marks, scale bar.
#include "core/asset/library/StarterProject.h"
#include "core/asset/project/FragmentColours.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
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
QImage picture(const RenderScene& scene, double scale = 1.0, StandardView from = StandardView::Front) {
    RenderView view{.size = kPictureSize};
    view.camera = alignedTo(view.camera, from);
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
    /// What has not broken is drawn as a whole, without its cracks.
    void theSceneAloneHasNoCracks() {
        const Project project = starterProject();
        const auto alone = [&](bool isWhole, bool isAlone) {
            const AssetBakes bakes = isWhole ? AssetBakes() : bakesOf(project).value();
            const auto scene = std::make_shared<RenderScene>(sceneOf(project, bakes, {.isWhole = isWhole}));
            RenderView view{.size = kPictureSize};
            view.camera = framing(view.camera, boundsOf(*scene), kPictureSize);
            view.settings.hasShadows = view.settings.hasAxes = view.settings.hasGrid = false;
            view.settings.hasOverlays = !isAlone;
            const Image image = renderImage(scene, view, 0).value();
            return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888)
                .copy(60, 60, 80, 80);
        };
        const QImage whole = alone(true, true);
        QVERIFY(test::meanDifference(alone(false, true), whole) < 0.2);
        QVERIFY(test::meanDifference(alone(false, false), whole) > 1.0);
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
    /// It is lit by the sky and, from above, by the key light: darker at its bottom.
    void dustIsShaded() {
        RenderScene scene = centredWall();
        const QImage clear = picture(scene);
        scene.particles = {
            {glm::vec4(0.0f, 0.0f, 1.0f, 0.4f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), glm::vec4(0.8f, 0.8f, 0.8f, 0.3f)}};
        const QImage seen = picture(scene);
        const auto brightness = [&](int y) {
            double sum = 0.0;
            for (int x = 85; x < 115; ++x) {
                for (int row = y; row < y + 12; ++row) sum += seen.pixelColor(x, row).green();
            }
            return sum / (30.0 * 12.0);
        };
        QVERIFY2(brightness(75) > brightness(113) + 10.0,
                 qPrintable(QString("%1 %2").arg(brightness(75)).arg(brightness(113))));
    }
    void chipsAreSolidsThatBodiesHide() {
        RenderScene scene = centredWall();
        const QImage clear = picture(scene);
        const auto chipAt = [&](float z, float angle) {
            scene.chips = {{glm::vec4(0.0f, 0.0f, z, 0.2f), glm::vec4(0.0f), glm::vec4(1.0f, 0.0f, 0.0f, angle),
                            glm::vec4(0.9f, 0.2f, 0.2f, 0.3f)}};
            return picture(scene);
        };
        QCOMPARE(test::meanDifference(chipAt(-1.0f, 0.0f), clear), 0.0);
        const QImage seen = chipAt(1.0f, 0.0f);
        std::set<QRgb> shades;  // of its faces
        int covered = 0;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 200; ++x) {
                const QColor colour = seen.pixelColor(x, y);
                if (seen.pixel(x, y) == clear.pixel(x, y) || colour.red() < 2 * colour.green()) continue;
                ++covered;
                shades.insert(qRgb(colour.red() / 8, colour.green() / 8, colour.blue() / 8));
            }
        }
        QVERIFY2(covered > 600 && covered < 8000, qPrintable(QString::number(covered)));
        QVERIFY2(shades.size() >= 2 && shades.size() < 20, qPrintable(QString::number(shades.size())));
        QVERIFY(test::meanDifference(chipAt(1.0f, 1.0f), seen) > 0.1);  // rotated
    }
    void lyingChipDarkensTheGroundBelowIt() {
        RenderScene scene = centredWall();
        for (BodyAppearance& body : scene.appearances) body.marks = kHidden;
        scene.groundHeight = scene.origin.y - 0.5;
        const auto from = StandardView::Top;
        const QImage clear = picture(scene, 1.0, from);
        const auto darkened = [&](float height) {
            scene.chips = {{glm::vec4(0.0f, -0.5f + height, 0.0f, 0.1f), glm::vec4(0.0f),
                            glm::vec4(1.0f, 0.0f, 0.0f, 0.0f), glm::vec4(1.0f, 1.0f, 1.0f, 0.3f)}};
            const QImage seen = picture(scene, 1.0, from);
            int count = 0;
            for (int y = 0; y < 200; ++y) {
                for (int x = 0; x < 200; ++x) {
                    count += seen.pixelColor(x, y).green() < clear.pixelColor(x, y).green() - 15 ? 1 : 0;
                }
            }
            return count;
        };
        const int lying = darkened(0.02f), flying = darkened(0.5f);
        QVERIFY2(lying > flying + 20, qPrintable(QString("%1 %2").arg(lying).arg(flying)));
    }
    void decalsCoverWhatIsWithinTheirRadius() {
        RenderScene scene = centredWall();
        const QImage clear = picture(scene);
        const auto differenceOf = [&](DecalKind kind, float z, const QRect& where) {
            scene.decals = {{glm::vec4(0.0f, 0.0f, z, 0.3f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                             glm::vec4(static_cast<float>(kind), 0.0f, 0.5f, 0.0f)}};
            return test::meanDifference(picture(scene).copy(where), clear.copy(where));
        };
        const QRect middle(90, 90, 20, 20), corner(20, 20, 20, 20);
        QVERIFY(differenceOf(DecalKind::Light, 0.35f, middle) > 20.0);
        QCOMPARE(differenceOf(DecalKind::Light, 0.35f, corner), 0.0);
        QCOMPARE(differenceOf(DecalKind::Light, 0.6f, middle), 0.0);   // too far before the wall
        QCOMPARE(differenceOf(DecalKind::Scorch, 0.3f, middle), 0.0);  // which is not ground
        QCOMPARE(differenceOf(DecalKind::ShockRing, 0.3f, middle), 0.0);
    }
    void marksChangeTheirPlaceOnTheirBody() {
        RenderScene scene = centredWall();
        const QImage clear = picture(scene);
        const auto differenceOf = [&](const glm::vec4& normal, float z, const QRect& where) {
            scene.surfaceMarks.clear();
            for (std::uint32_t body = 0; body < scene.poses.size(); ++body) {
                const glm::vec4 origin = scene.poses[body].position;
                scene.surfaceMarks.push_back(
                    {glm::vec4(glm::vec3(0.0f, 0.0f, z) - glm::vec3(origin), 0.15f), normal, body});
            }
            return test::meanDifference(picture(scene).copy(where), clear.copy(where));
        };
        const QRect middle(80, 80, 40, 40), corner(20, 20, 40, 40);
        const glm::vec4 outwards(0.0f, 0.0f, 1.0f, 0.4f), soot(0.0f, 0.0f, 0.0f, 0.4f);
        for (const glm::vec4& normal : {outwards, soot}) {
            QVERIFY(differenceOf(normal, 0.25f, middle) > 4.0);
            QCOMPARE(differenceOf(normal, 0.25f, corner), 0.0);
            QCOMPARE(differenceOf(normal, -0.25f, middle), 0.0);  // on the other side
        }
        QCOMPARE(differenceOf(-outwards, 0.25f, middle), 0.0);
    }
    void scorchAndRingLieOnTheGround() {
        RenderScene scene = centredWall();
        for (BodyAppearance& body : scene.appearances) body.marks = kHidden;
        scene.groundHeight = scene.origin.y - 0.5;
        const QImage clear = picture(scene, 1.0, StandardView::Top);
        const auto seen = [&](DecalKind kind) {
            scene.decals = {{glm::vec4(0.0f, -0.5f, 0.0f, 0.5f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                             glm::vec4(static_cast<float>(kind), 0.0f, 0.5f, 0.0f)}};
            return picture(scene, 1.0, StandardView::Top);
        };
        const QRect middle(95, 95, 10, 10);
        QVERIFY(test::meanDifference(seen(DecalKind::Scorch).copy(middle), clear.copy(middle)) > 60.0);
        QCOMPARE(test::meanDifference(seen(DecalKind::ShockRing).copy(middle), clear.copy(middle)), 0.0);
        QVERIFY(test::meanDifference(seen(DecalKind::ShockRing), clear) > 1.0);
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
