#include "tests/support/TestProgram.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

constexpr ImageSize kOutlineSize{240, 240};

/// From the front, without shadows and edges.
RenderView frontOf(const RenderScene& scene) {
    RenderView view{.size = kOutlineSize};
    view.camera = framing(view.camera, boundsOf(scene), kOutlineSize);
    view.settings.hasShadows = view.settings.hasAxes = view.settings.hasEdges = false;
    view.settings.msaa = 1;
    view.settings.accent = {1.0, 0.0, 1.0};  // no surface has this colour
    return view;
}

QImage picture(const std::shared_ptr<const RenderScene>& scene, const RenderView& view, int samples = 0) {
    const Image image = renderImage(scene, view, samples).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

/// How far a pixel is from grey towards the accent, in [0, 255].
int accentAt(const QImage& image, int x, int y) {
    const QColor colour = image.pixelColor(x, y);
    return std::min(colour.red(), colour.blue()) - colour.green();
}
bool isAccent(const QImage& image, int x, int y) { return accentAt(image, x, y) > 120; }

int accentPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += isAccent(image, x, y) ? 1 : 0;
    }
    return count;
}

/// The fragments of the wall in a scene.
std::vector<std::uint32_t> fragmentsOf(const RenderScene& scene) {
    std::vector<std::uint32_t> fragments;
    for (const PickId& pick : scene.picks) fragments.push_back(pick.fragment);
    return fragments;
}

/// The scene with fragments of its wall selected; all of them if none are given.
std::shared_ptr<const RenderScene> withSelected(const std::vector<std::uint32_t>& fragments) {
    const auto scene = test::starterScene();
    std::vector<PickId> selected;
    for (const std::uint32_t fragment : fragments) selected.push_back({scene->picks[0].asset, 0, fragment});
    if (fragments.empty()) selected.push_back({scene->picks[0].asset, scene->picks[0].instance});
    return test::starterScene({.selected = selected});
}

}  // namespace

class OutlinePassTest : public QObject {
    Q_OBJECT
private slots:
    void selectionKeepsTheMaterialVisible() {
        const RenderView view = frontOf(*test::starterScene());
        const QImage plain = picture(test::starterScene(), view), selected = picture(withSelected({}), view);
        QCOMPARE(selected.pixelColor(120, 120), plain.pixelColor(120, 120));
        QVERIFY(accentPixels(plain) == 0 && accentPixels(selected) > 200);
    }
    void wholeInstanceHasOneOutline() {
        const RenderView view = frontOf(*test::starterScene());
        const QImage seen = picture(withSelected({}), view);
        int crossings = 0;
        for (int x = 1; x < 240; ++x) crossings += isAccent(seen, x, 120) && !isAccent(seen, x - 1, 120) ? 1 : 0;
        QCOMPARE(crossings, 2);
    }
    /// All fragments together look as the whole.
    void neighboursShareAnOutline() {
        const auto scene = test::starterScene();
        const RenderView view = frontOf(*scene);
        const std::vector<std::uint32_t> all = fragmentsOf(*scene);
        const QImage whole = picture(withSelected({}), view), parts = picture(withSelected(all), view);
        QVERIFY(all.size() == 20 && whole == parts);
    }
    /// The wall is seen from so far that its fragments are a few pixels wide.
    void smallFragmentsStayVisible() {
        RenderView view = frontOf(*test::starterScene());
        view.camera.distance *= 8.0;
        const QImage plain = picture(test::starterScene(), view);
        for (std::uint32_t fragment = 0; fragment < 20; ++fragment) {
            const QImage seen = picture(withSelected({fragment}), view);
            const auto scene = withSelected({fragment});
            const Vec2 middle = pixelOf(view.camera, boundsOf(*scene, kSelected).centre(), kOutlineSize).value();
            int kept = 0;  // of 3 x 3 pixels about the centre of the fragment's bounds
            for (int k = 0; k < 9; ++k) {
                const int x = static_cast<int>(middle.x) + k % 3 - 1, y = static_cast<int>(middle.y) + k / 3 - 1;
                kept += seen.pixelColor(x, y) == plain.pixelColor(x, y) ? 1 : 0;
            }
            QVERIFY2(kept >= 3, qPrintable(QString("%1: %2").arg(fragment).arg(kept)));
        }
    }
    void distantSelectedFragmentsHaveOutlines() {
        const RenderView view = frontOf(*test::starterScene());
        const auto centre = [](std::uint32_t fragment) {
            return boundsOf(*withSelected({fragment}), kSelected).centre();
        };
        std::uint32_t far = 1;  // from fragment 0
        for (std::uint32_t k = 2; k < 20; ++k) {
            if (glm::distance(centre(k), centre(0)) > glm::distance(centre(far), centre(0))) far = k;
        }
        const int one = accentPixels(picture(withSelected({0}), view));
        const int other = accentPixels(picture(withSelected({far}), view));
        const int both = accentPixels(picture(withSelected({0, far}), view));
        QVERIFY(one > 40 && other > 40);
        QCOMPARE(both, one + other);
    }
    void outlineIsWiderOnDenseScreens() {
        RenderView view = frontOf(*test::starterScene());
        const int thin = accentPixels(picture(withSelected({}), view));
        view.settings.scale = 2.0;
        const int wide = accentPixels(picture(withSelected({}), view));
        QVERIFY2(wide > 1.6 * thin && wide < 2.6 * thin, qPrintable(QString::number(1.0 * wide / thin)));
    }
    void occludedOutlineIsFainter() {
        RenderScene scene = *withSelected({0});
        const RenderView view = frontOf(scene);
        const QImage open = picture(std::make_shared<RenderScene>(scene), view);
        for (std::size_t body = 1; body < scene.poses.size(); ++body) {  // a screen of the other fragments before it
            scene.poses[body].position.z += 0.6f;
            scene.poses[body].position.x = scene.poses[0].position.x;
            scene.poses[body].position.y = scene.poses[0].position.y;
        }
        const QImage hidden = picture(std::make_shared<RenderScene>(scene), view);
        int faint = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 240; ++x) {
                if (!isAccent(open, x, y)) continue;
                const int accent = accentAt(hidden, x, y);
                faint += accent > 30 && accent < 0.6 * accentAt(open, x, y) ? 1 : 0;
            }
        }
        QVERIFY2(faint > 20, qPrintable(QString::number(faint)));
    }
    void wireframeShowsTheOutlineOnly() {
        RenderView view = frontOf(*test::starterScene());
        view.settings.shading = Shading::Wireframe;
        const QImage seen = picture(withSelected({}), view);
        QVERIFY(accentPixels(seen) > 200);
        for (int x = 80; x < 160; ++x) QVERIFY(!isAccent(seen, x, 120));
    }
    void hoveredBodyHasAnOutline() {
        RenderView view = frontOf(*test::starterScene());
        const QImage plain = picture(test::starterScene(), view);
        view.hovered = 3;
        const QImage seen = picture(test::starterScene(), view);
        int lighter = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 240; ++x) lighter += accentAt(seen, x, y) > 60 ? 1 : 0;
        }
        QVERIFY2(lighter > 40, qPrintable(QString::number(lighter)));
    }
    /// The pass draws near the outlined bodies only: what it drew of others before is not seen around them.
    void nothingIsLeftOfEarlierOutlines() {
        RenderView view = frontOf(*test::starterScene());
        const auto bodies = static_cast<std::uint32_t>(test::starterScene()->picks.size());
        std::vector<QImage> alone;
        for (std::uint32_t body = 0; body < bodies; ++body) {
            view.hovered = body;
            alone.push_back(picture(test::starterScene(), view));
        }
        Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
        QVERIFY(renderer.hasValue());
        const auto hovered = [&](std::uint32_t body) {
            view.hovered = body % bodies;
            const Image image = renderer->renderImage(test::starterScene(), view, 0).value();
            return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888)
                .copy();
        };
        for (std::uint32_t body = 0; body < bodies; ++body) {
            for (std::uint32_t other = 1; other < bodies; ++other) hovered(body + other);
            QVERIFY2(hovered(body) == alone[body], qPrintable(QString::number(body)));
        }
    }
    /// Also over the mean of several samples, whose sum is blended otherwise.
    void hoveredSurfaceIsOnlyABitBrighter() {
        RenderView view = frontOf(*test::starterScene());
        for (const int samples : {0, 4}) {
            view.hovered.reset();
            const QImage plain = picture(test::starterScene(), view, samples);
            view.hovered = 3;
            const QImage seen = picture(test::starterScene(), view, samples);
            int brighter = 0, white = 0;
            for (int y = 0; y < 240; ++y) {
                for (int x = 0; x < 240; ++x) {
                    const QColor before = plain.pixelColor(x, y), after = seen.pixelColor(x, y);
                    brighter += after.green() > before.green() + 5 ? 1 : 0;
                    white += after.green() > 250 && before.green() < 240 ? 1 : 0;
                }
            }
            QVERIFY2(brighter > 100 && white == 0,
                     qPrintable(QString("%1 samples: %2 brighter, %3 white").arg(samples).arg(brighter).arg(white)));
        }
    }
};

RUBBLE_TEST_WITH(OutlinePassTest, QCoreApplication)
#include "OutlinePassTest.moc"
