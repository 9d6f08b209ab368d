#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/Pictures.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <QDir>
#include <QTest>

#include <algorithm>

using namespace rubble;
using test::meanDifference;

namespace {

const QString kPictures = RUBBLE_SOURCE_DIR "/tests/data/pictures/";
constexpr ImageSize kReferenceSize{240, 160};
// Mean absolute difference over all pixels and channels, of 255. Drivers draw edges slightly differently; without the
// key light or with faces inside out, images differ by more than 4.
constexpr double kTolerance = 1.0;

std::shared_ptr<const RenderScene> houseScene(const SceneOptions& options) {
    const Project house = loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble").value();
    AssetBakes bakes;
    for (const Asset& asset : house.assets) bakes[{asset.id}] = std::make_shared<const Bake>(bake(asset).value());
    return std::make_shared<const RenderScene>(sceneOf(house, bakes, options));
}

RenderView viewOf(const RenderScene& scene, const RenderSettings& settings, double moment = 1.0) {
    RenderView view{
        .camera = orbited({}, 0.6, 0.4), .size = kReferenceSize, .settings = settings, .stepFraction = moment};
    view.camera = framing(view.camera, boundsOf(scene), kReferenceSize);
    return view;
}

QImage shown(const std::shared_ptr<const RenderScene>& scene, const RenderView& view, int samples = 0) {
    const Image image = renderImage(scene, view, samples).value();
    return QImage(image.pixels.data(), kReferenceSize.width, kReferenceSize.height, 3 * kReferenceSize.width,
                  QImage::Format_RGB888)
        .copy();
}
QImage shown(const std::shared_ptr<const RenderScene>& scene, const RenderSettings& settings, int samples) {
    return shown(scene, viewOf(*scene, settings), samples);
}

}  // namespace

/// Compares with the reference images in tests/data/pictures. RUBBLE_UPDATE_PICTURES=1 rewrites them: look at them
/// before committing.
class OffscreenRendererTest : public QObject {
    Q_OBJECT
private slots:
    /// Bodies are opaque, and sky and ground are not there.
    void cutOutsShowTheBodiesAlone() {
        const auto scene = houseScene({});
        Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
        QVERIFY(renderer);
        for (const int samples : {0, 4}) {
            const Image image =
                renderer->renderCutOut(scene, viewOf(*scene, {.hasOverlays = false, .msaa = 4}), samples).value();
            const auto opacity = [&](int x, int y) {
                return image.opacities[static_cast<std::size_t>(y * image.width + x)];
            };
            QCOMPARE(opacity(0, 0), std::uint8_t{0});
            QCOMPARE(opacity(image.width - 1, image.height - 1), std::uint8_t{0});
            QCOMPARE(opacity(image.width / 2, image.height / 2), std::uint8_t{255});
            const auto seen = std::ranges::count(image.opacities, std::uint8_t{255});
            QVERIFY(seen > 4000 && seen < 20'000);
        }
    }
    void matchesReferenceImage_data() {
        QTest::addColumn<SceneOptions>("options");
        QTest::addColumn<RenderSettings>("settings");
        QTest::addColumn<int>("samples");
        const Project house = loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble").value();
        const Id wall = findAsset(house, "wall")->id;
        QTest::newRow("house") << SceneOptions{} << RenderSettings{.msaa = 4} << 0;
        QTest::newRow("house-soft") << SceneOptions{} << RenderSettings{.msaa = 4} << 16;
        QTest::newRow("house-apart-dark") << SceneOptions{.colouring = SceneColouring::Fragment, .explodeFactor = 0.5}
                                          << RenderSettings{.theme = Theme::Dark, .msaa = 4} << 0;
        QTest::newRow("wires") << SceneOptions{} << RenderSettings{.shading = Shading::Wireframe, .msaa = 4} << 0;
        QTest::newRow("wall-selected") << SceneOptions{.asset = wall,
                                                       .explodeFactor = 0.2,
                                                       .hasHulls = true,
                                                       .marks = {.selected = {{wall, 0, 1}}}}
                                       << RenderSettings{.msaa = 4} << 0;
    }
    void matchesReferenceImage() {
        QFETCH(SceneOptions, options);
        QFETCH(RenderSettings, settings);
        QFETCH(int, samples);
        const QString path = kPictures + QTest::currentDataTag() + ".png";
        const QImage seen = shown(houseScene(options), settings, samples);
        if (qEnvironmentVariableIsSet("RUBBLE_UPDATE_PICTURES")) QVERIFY(seen.save(path));
        const QImage expected = QImage(path).convertToFormat(QImage::Format_RGB888);
        QCOMPARE(seen.size(), expected.size());
        const double difference = meanDifference(seen, expected);
        if (difference > kTolerance) seen.save(QString(QTest::currentDataTag()) + "-seen.png");
        QVERIFY2(difference <= kTolerance, qPrintable(QString("differs by %1").arg(difference)));
    }
    void playLooksLikeTheDocumentBeforeBreaks() {
        const Project house = loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble").value();
        const auto play = playScene(house).value();
        const Session session = Session::start(play).value();
        const QImage moment = shown(SessionSceneBuilder(play).sceneOf(session), {.msaa = 4}, 0);
        RenderScene standing = *houseScene({.isWhole = true});
        standing.isOutdoors = true;
        const QImage wholes = shown(std::make_shared<RenderScene>(standing), {.msaa = 4}, 0);
        QVERIFY(meanDifference(moment, wholes) < 0.05);
    }
    void stepFractionInterpolatesPoses() {
        RenderScene scene = *houseScene({.isWhole = true});
        scene.previousPoses = scene.poses;
        for (std::size_t k = 0; k < scene.poses.size(); k += 3) {
            scene.previousPoses[k].position += glm::vec4(0.0f, 1.0f, 0.5f, 0.4f);
            scene.previousPoses[k].orientation = -glm::normalize(glm::vec4(0.3f, 0.1f, 0.2f, 0.9f));
        }
        RenderScene half = scene;
        for (std::uint32_t k = 0; k < scene.poses.size(); ++k) half.poses[k] = poseAt(scene, k, 0.5);
        half.previousPoses.clear();
        half.summary = scene.summary = summaryOf(scene);  // for the same shadow maps
        const auto moving = std::make_shared<const RenderScene>(scene);
        const RenderView view = viewOf(half, {.msaa = 4}, 0.5);
        const QImage expected = shown(std::make_shared<RenderScene>(half), view);
        QVERIFY(meanDifference(shown(moving, view), expected) < 0.02);
        QVERIFY(meanDifference(shown(moving, viewOf(half, {.msaa = 4}, 1.0)), expected) > 1.0);
        QVERIFY(meanDifference(shown(moving, viewOf(half, {.msaa = 4}, 0.0)), expected) > 1.0);
    }
    void rejectsSizesOutOfRange() {
        for (const ImageSize size : {ImageSize{0, 10}, ImageSize{10, 8193}}) {
            const Result<Image> image = renderImage(houseScene({}), {.size = size}, 0);
            QVERIFY(image.error().code == ErrorCode::BadInput);
        }
        QCOMPARE(QString::fromStdString(renderImage(houseScene({}), {.size = {0, 10}}, 0).error().message),
                 QString("A picture of 0 x 10 pixels: its sides can be 1 to 8192."));
    }
    void renderingCanBeCancelled() {
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(renderImage(houseScene({}), {.size = kReferenceSize}, 4, task).error().code == ErrorCode::Cancelled);
    }
    void pngRoundTripKeepsPixels() {
        Image image{2, 3, {}};
        for (std::uint8_t k = 0; k < 18; ++k) image.pixels.push_back(14 * k);
        const std::string png = pngOf(image).value();
        const QImage read = QImage::fromData(QByteArray::fromStdString(png)).convertToFormat(QImage::Format_RGB888);
        QCOMPARE(read.size(), QSize(2, 3));
        QCOMPARE(read.pixelColor(1, 2), QColor(14 * 15, 14 * 16, 14 * 17));
    }
};

RUBBLE_TEST_WITH(OffscreenRendererTest, QCoreApplication)
#include "OffscreenRendererTest.moc"
