// Tests viewport/render/LightBuffer.cpp, viewport/render/light/Lighting.cpp and viewport/render/SkyMaps.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/Lighting.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

/// Towards the key light.
Vec3 studioLamp() { return skyOf(SkyPreset::Studio, Theme::Light).sunDirection; }

constexpr ImageSize kGroundPicture{400, 300};

/// The ground around a point from above, `radius` m upwards in the picture.
RenderView groundFromAbove(Vec3 target, double radius) {
    RenderView view{.size = kGroundPicture};
    view.camera = alignedTo(view.camera, StandardView::Top);
    view.camera.projection = Projection::Orthographic;
    view.camera.target = target;
    view.camera.distance *= radius / (0.5 * kGroundPicture.height * metresPerPixel(view.camera, kGroundPicture));
    view.settings.hasAxes = view.settings.hasGrid = view.settings.hasEdges = false;
    view.settings.msaa = 1;
    return view;
}

QImage drawn(const RenderScene& scene, const RenderView& view, int samples) {
    const Image image = renderImage(std::make_shared<const RenderScene>(scene), view, samples).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

/// The brightness of each column, in the mean over some rows, which hides dithering.
std::vector<double> columns(const QImage& image, int fromRow, int rows) {
    std::vector<double> means;
    for (int x = 0; x < image.width(); ++x) {
        double sum = 0.0;
        for (int y = fromRow; y < fromRow + rows; ++y) sum += image.pixelColor(x, y).red();
        means.push_back(sum / rows);
    }
    return means;
}

/// The largest change from one column to the next.
double largestStep(const std::vector<double>& means) {
    double largest = 0.0;
    for (std::size_t k = 1; k < means.size(); ++k) largest = std::max(largest, std::abs(means[k] - means[k - 1]));
    return largest;
}

/// The starter wall as opaque as given, whole or in fragments, `up` m above the ground.
RenderScene wallAt(double up, double opacity = 1.0) {
    RenderScene scene = *test::starterScene();
    for (RenderPose& pose : scene.poses) pose.position.y += static_cast<float>(up);
    for (BodyAppearance& body : scene.appearances) {
        body.outside = packedSurface({0.5, 0.7, 0.6}, opacity);
        body.inside = body.outside;
    }
    scene.summary.reset();
    return scene;
}

/// The end of a wall's shadow on the ground: the middle of its right edge.
Vec3 shadowEdge(const RenderScene& scene) {
    const Box3 bounds = boundsOf(scene);
    const Vec3 side(bounds.max.x, bounds.centre().y, bounds.centre().z);
    return side - (side.y - scene.groundHeight) / studioLamp().y * studioLamp();
}

void addSampleCounts() {
    QTest::addColumn<int>("samples");
    for (const int samples : {0, 8, 32}) QTest::addRow("%d samples", samples) << samples;
}

}  // namespace

/// The light of pictures is soft: shadows fade without steps, and light from the sky leaves no polygons on the ground.
class LightBufferTest : public QObject {
    Q_OBJECT
private slots:
    void shadowEdgesHaveNoSteps_data() { addSampleCounts(); }
    void shadowEdgesHaveNoSteps() {
        QFETCH(int, samples);
        const RenderScene scene = wallAt(2.0);
        const QImage seen = drawn(scene, groundFromAbove(shadowEdge(scene), 0.3), samples);
        const std::vector<double> means = columns(seen, 145, 10);
        const double contrast = *std::ranges::max_element(means) - *std::ranges::min_element(means);
        QVERIFY2(contrast > 30.0, qPrintable(QString::number(contrast)));
        const double step = largestStep(means);  // the edge is about 100 pixels wide
        QVERIFY2(step < 0.06 * contrast, qPrintable(QString("%1 of %2").arg(step).arg(contrast)));
    }
    void groundAroundABodyHasNoPatches_data() { addSampleCounts(); }
    void groundAroundABodyHasNoPatches() {
        QFETCH(int, samples);
        const RenderScene scene = wallAt(0.0);
        const Box3 bounds = boundsOf(scene);
        // In full light, left of the wall and from 10 cm of it on.
        RenderView view = groundFromAbove({bounds.min.x - 0.9, 0.0, bounds.centre().z}, 0.6);
        const QImage seen = drawn(scene, view, samples);
        const std::vector<double> means = columns(seen, 145, 10);
        const double step = largestStep(means);
        QVERIFY2(step < 0.8, qPrintable(QString::number(step)));
        QVERIFY(means.back() < means.front() - 3.0);  // darker near the wall
    }
    /// Before a wall that faces the key light: by depth taps, since the maps of the sky have texels of centimetres.
    void groundIsDarkerWhereABodyTouchesIt() {
        const RenderScene scene = wallAt(0.0);
        const Box3 bounds = boundsOf(scene);
        RenderView view = groundFromAbove({bounds.centre().x, 0.0, bounds.max.z}, 0.6);
        view.camera.elevation = 0.6;
        const QImage seen = drawn(scene, view, 0);  // the wall touches the ground in its middle
        const auto lightness = [&](int pixelsBefore) {
            double sum = 0.0;
            for (int x = 150; x < 250; ++x) sum += seen.pixelColor(x, 150 + pixelsBefore).red();
            return sum / 100.0;
        };
        const double near = lightness(4), far = lightness(40);
        QVERIFY2(near < far - 14.0, qPrintable(QString("%1, %2").arg(near).arg(far)));
    }
    void silhouettesBeforeTheSkyAreNotDark() {
        const RenderScene scene = wallAt(0.0);
        RenderView view{.camera = orbited({}, 0.3, 0.1), .size = kGroundPicture};
        view.camera = framing(view.camera, boundsOf(scene), kGroundPicture);
        view.settings.hasAxes = view.settings.hasEdges = false;
        view.settings.msaa = 1;
        const QImage seen = drawn(scene, view, 0);
        int least = 255;
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) least = std::min(least, seen.pixelColor(x, y).lightness());
        }
        QVERIFY2(least > 40, qPrintable(QString::number(least)));
    }
    void shadowOfGlassHasNoPattern_data() { addSampleCounts(); }
    void shadowOfGlassHasNoPattern() {
        QFETCH(int, samples);
        RenderScene scene = sceneOf(starterProject(), {}, {.isWhole = true});
        scene.appearances[0].outside = scene.appearances[0].inside = packedSurface({0.5, 0.7, 0.6}, 0.3);
        scene.poses[0].position.y += 1.0f;
        scene.summary.reset();
        const Vec3 centre = boundsOf(scene).centre();
        const Vec3 middle = centre - (centre.y - scene.groundHeight) / studioLamp().y * studioLamp();
        const QImage seen = drawn(scene, groundFromAbove(middle, 0.1), samples).copy(100, 100, 200, 100);
        const QImage open = drawn(scene, groundFromAbove(middle + Vec3(5.0, 0.0, 0.0), 0.1), samples);
        int least = 255, most = 0;
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) {
                least = std::min(least, seen.pixelColor(x, y).red());
                most = std::max(most, seen.pixelColor(x, y).red());
            }
        }
        QVERIFY(most < open.pixelColor(200, 150).red() - 5);
        QVERIFY2(most - least <= 4, qPrintable(QString("%1 to %2").arg(least).arg(most)));
    }
};

RUBBLE_TEST_WITH(LightBufferTest, QCoreApplication)
#include "LightBufferTest.moc"
