// Tests viewport/render/TransparencyPass.cpp and viewport/render/gl/RenderTarget.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/gl/RenderTarget.h"

#include <QImage>
#include <QTest>

#include <cmath>
#include <utility>

using namespace rubble;

namespace {

constexpr ImageSize kPaneSize{160, 160};
constexpr std::uint32_t kGreenPane = 0x10a010, kRedPane = 0xd01010;

/// Copies of the starter project's wall, whole, one behind the other from the front, a metre apart.
RenderScene walls(const std::vector<std::uint32_t>& colours) {
    RenderScene scene = sceneOf(starterProject(), {}, {.isWhole = true});
    const RenderScene one = scene;
    for (std::size_t k = 0; k < colours.size(); ++k) {
        if (k > 0) {
            scene.batches[0].firstBodies.push_back(static_cast<std::uint32_t>(k));
            scene.poses.push_back(one.poses[0]);
            scene.appearances.push_back(one.appearances[0]);
            scene.picks.push_back(one.picks[0]);
        }
        scene.poses[k].position.z -= static_cast<float>(k);
        scene.appearances[k].outside = scene.appearances[k].inside = colours[k];
    }
    return scene;
}

/// From the front, without shadows, edges and axes.
RenderView panesFromFront(const RenderScene& scene) {
    RenderView view{.size = kPaneSize};
    view.camera = framing(view.camera, boundsOf(scene), kPaneSize);
    view.settings.hasShadows = view.settings.hasAxes = view.settings.hasEdges = false;
    view.settings.msaa = 1;
    return view;
}

QImage panePicture(const RenderScene& scene, const RenderView& view, int samples = 0) {
    const Image image = renderImage(std::make_shared<RenderScene>(scene), view, samples).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

QColor middleOf(const RenderScene& scene, int samples = 0, int msaa = 1) {
    RenderView view = panesFromFront(walls({kGreenPane}));
    view.settings.msaa = msaa;
    return panePicture(scene, view, samples).pixelColor(80, 80);
}

/// How much the lightest or darkest pixel of a picture stands out from both pixels beside it, on any line through it.
double speckle(const QImage& image) {
    double most = 0.0;
    const auto at = [&](int x, int y) { return static_cast<double>(image.pixelColor(x, y).lightness()); };
    for (int y = 1; y + 1 < image.height(); ++y) {
        for (int x = 1; x + 1 < image.width(); ++x) {
            double least = 255.0;
            for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
                const double before = at(x, y) - at(x - dx, y - dy), after = at(x, y) - at(x + dx, y + dy);
                least = std::min(least, before * after > 0.0 ? std::min(std::abs(before), std::abs(after)) : 0.0);
            }
            most = std::max(most, least);
        }
    }
    return most;
}

std::uint32_t withOpacity(std::uint32_t colour, double opacity) {
    return packedSurface({}, opacity) >> 24 << 24 | colour;
}

}  // namespace

class TransparencyPassTest : public QObject {
    Q_OBJECT
private slots:
    void glassShowsWhatIsBehind() {
        const QColor opaque = middleOf(walls({kGreenPane, kRedPane})), red = middleOf(walls({kRedPane}));
        for (const int samples : {0, 16}) {
            const QColor through = middleOf(walls({withOpacity(kGreenPane, 0.3), kRedPane}), samples);
            QVERIFY(through.red() > opaque.red() + 60 && through.red() < red.red());
            QVERIFY(through.green() > red.green() + 15 && through.green() < opaque.green());
        }
    }
    void opacityIsThatOfTheMaterial() {
        int last = middleOf(walls({kRedPane})).red() + 1;
        for (const double opacity : {0.1, 0.4, 0.7, 1.0}) {
            const int red = middleOf(walls({withOpacity(kGreenPane, opacity), kRedPane})).red();
            QVERIFY2(red < last - 10, qPrintable(QString("%1 at %2").arg(red).arg(opacity)));
            last = red;
        }
    }
    void antialiasingKeepsTheColour() {
        const RenderScene scene = walls({withOpacity(kGreenPane, 0.3), kRedPane});
        const QColor one = middleOf(scene), four = middleOf(scene, 0, 4);
        QVERIFY(std::abs(one.red() - four.red()) <= 1 && std::abs(one.green() - four.green()) <= 1);
    }
    void orderOfBodiesDoesNotMatter() {
        const std::uint32_t green = withOpacity(kGreenPane, 0.3), red = withOpacity(kRedPane, 0.5);
        RenderScene swapped = walls({red, green});
        std::swap(swapped.poses[0], swapped.poses[1]);
        const RenderView view = panesFromFront(swapped);
        QVERIFY(test::meanDifference(panePicture(walls({green, red}), view), panePicture(swapped, view)) < 0.02);
    }
    void nearerPanesWeighMore() {
        const std::uint32_t green = withOpacity(kGreenPane, 0.5), red = withOpacity(kRedPane, 0.5);
        const QColor greenFirst = middleOf(walls({green, red})), redFirst = middleOf(walls({red, green}));
        QVERIFY(greenFirst.green() > redFirst.green() + 10 && redFirst.red() > greenFirst.red() + 10);
    }
    void shadowOfGlassIsLighter_data() {
        QTest::addColumn<int>("samples");
        QTest::newRow("one pass") << 0;
        QTest::newRow("soft light") << 32;
    }
    void shadowOfGlassIsLighter() {
        QFETCH(int, samples);
        const auto darkness = [&](double opacity) {
            const RenderScene scene = walls({withOpacity(kGreenPane, opacity)});
            RenderView view = panesFromFront(scene);
            view.camera = alignedTo(view.camera, StandardView::Top);
            view.settings.hasGrid = false;
            view.camera.target = {0.8, 0.0, -0.6};  // in the wall's shadow
            view.camera.distance = 1.0;
            const QImage lit = panePicture(scene, view, samples);
            view.settings.hasShadows = true;
            return test::meanDifference(panePicture(scene, view, samples).copy(60, 60, 40, 40),
                                        lit.copy(60, 60, 40, 40));
        };
        const double opaque = darkness(1.0), glass = darkness(0.3);
        QVERIFY2(opaque > 20.0 && glass > 0.15 * opaque && glass < 0.5 * opaque,
                 qPrintable(QString("%1 of %2").arg(glass).arg(opaque)));
    }
    /// A ray enters fragments that touch one after the other. Their parts of the sky differ somewhat.
    void shadowOfFragmentsIsThatOfTheWhole() {
        const auto shadow = [&](RenderScene scene, bool hasShadows) {
            for (BodyAppearance& body : scene.appearances) body.outside = body.inside = withOpacity(kGreenPane, 0.3);
            scene.summary.reset();
            RenderView view = panesFromFront(scene);
            view.camera = alignedTo(view.camera, StandardView::Top);
            view.settings.hasGrid = false;
            view.camera.target = {0.8, 0.0, -0.6};  // in the wall's shadow
            view.camera.distance = 1.0;
            view.settings.hasShadows = hasShadows;
            return panePicture(scene, view).copy(60, 60, 40, 40);
        };
        const RenderScene wall = walls({kGreenPane});
        const QImage whole = shadow(wall, true);
        const double depth = test::meanDifference(shadow(wall, false), whole);
        const double apart = test::meanDifference(shadow(*test::starterScene(), true), whole);
        QVERIFY2(depth > 5.0 && apart < 0.3 * depth, qPrintable(QString("%1 of %2").arg(apart).arg(depth)));
    }
    /// Light goes a longer way through a pane along it than across.
    void longerWaysAbsorbMore() {
        Project project = starterProject();
        project.assets[0].prism().depth = 0.05;
        project.materials[0].finish = Finish::Glass;
        project.materials[0].opacity = 0.3;
        project.materials[0].outside = project.materials[0].inside = {0.1, 0.3, 0.2};
        const RenderScene scene = sceneOf(project, {}, {.isWhole = true});
        RenderView view = panesFromFront(scene);
        view.settings.hasGrid = false;
        view.camera.projection = Projection::Orthographic;
        const auto darkness = [&](StandardView from) {
            view.camera = framing(alignedTo(view.camera, from), boundsOf(scene), kPaneSize);
            const QImage picture = panePicture(scene, view);
            return picture.pixelColor(2, 40).lightness() - picture.pixelColor(80, 80).lightness();
        };
        const int across = darkness(StandardView::Front), along = darkness(StandardView::Right);
        QVERIFY2(across > 10 && along > 1.5 * across, qPrintable(QString("%1, %2").arg(across).arg(along)));
    }
    /// The sides of shards, a fraction of a pixel wide, hit some pixels and miss others.
    void thinSidesHaveNoSpeckles() {
        Project project = starterProject();
        project.assets[0].prism().depth = 0.006;
        AssetBakes bakes;
        bakes[{project.assets[0].id}] = std::make_shared<const Bake>(bake(project.assets[0]).value());
        RenderScene scene = sceneOf(project, bakes, {.explodeFactor = 0.3});
        for (BodyAppearance& body : scene.appearances) {
            body.outside = withOpacity(0xc0e0e8, 0.3);
            body.inside = withOpacity(0x406860, 0.6);
        }
        scene.summary.reset();
        RenderView view = panesFromFront(scene);
        view.camera.distance *= 2.0;
        view.settings.hasGrid = false;
        double worst = 0.0;
        for (const double azimuth : {-0.6, 0.3, 0.7}) {
            view.camera.azimuth = azimuth;
            view.camera.elevation = 0.5;
            worst = std::max(worst, speckle(panePicture(scene, view)));
        }
        QVERIFY2(worst < 25.0, qPrintable(QString::number(worst)));
    }
};

RUBBLE_TEST_WITH(TransparencyPassTest, QCoreApplication)
#include "TransparencyPassTest.moc"
