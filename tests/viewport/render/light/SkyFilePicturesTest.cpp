// Tests skyLightOf() of pictures in viewport/render/light/SkyLight.cpp, viewport/render/light/SkyTexture.cpp and the
// shader sky_file.glsl.
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/SkyImages.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/SkyLight.h"

#include <QImage>
#include <QTest>
#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

constexpr ImageSize kPictureSize{240, 160};

QImage wallIn(const RenderSettings& settings, int samples) {
    const auto scene = test::starterScene();
    RenderView view{.camera = orbited({}, 0.6, 0.1), .size = kPictureSize, .settings = settings};
    view.camera = framing(view.camera, boundsOf(*scene), kPictureSize);
    const Image image = renderImage(scene, view, samples).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

/// What is seen of a preset, with its sun as a disc.
RadianceImage imageOf(const Sky& sky, std::uint32_t width) {
    const Vec3 sun = sky.sunLight / (2.0 * (1.0 - std::cos(sky.sunRadius)));  // by its solid angle
    return test::skyImage(width, [&](Vec3 direction) {
        return skyRadiance(sky, direction) + test::discCover(width, direction, sky.sunDirection, sky.sunRadius) * sun;
    });
}

std::shared_ptr<const SkyLight> shared(SkyLight light) { return std::make_shared<const SkyLight>(std::move(light)); }

}  // namespace

class SkyFilePicturesTest : public QObject {
    Q_OBJECT
private slots:
    /// A white surface in light that is the same from everywhere above it reflects just that.
    void constantSkyLightsByItsRadiance() {
        const SkyLight light = skyLightOf(test::skyImage(64, [](Vec3) { return Vec3(3.0, 2.0, 1.0); }));
        const Vec3 radiance =
            Vec3(light.background->pixels[0][0], light.background->pixels[0][1], light.background->pixels[0][2]);
        QVERIFY(std::abs(radiance.x / radiance.z - 3.0) < 1e-6);
        constexpr double kQuadrature = 1e-4;  // relative error of the sum over 32 heights
        const double size = glm::length(radiance);
        QVERIFY(glm::length(valueFor(light.diffuse, {0.0, 1.0, 0.0}) - radiance) < kQuadrature * size);
        QVERIFY(glm::length(valueFor(light.diffuse, {1.0, 0.0, 0.0}) - 0.5 * radiance) < kQuadrature * size);
        for (const double roughness : {0.0, 0.2}) {  // the lobes of rougher surfaces reach the ground
            const Vec3 mirrored = reflected(light.reflections, {0.0, 1.0, 0.0}, roughness);
            QVERIFY(glm::length(mirrored - radiance) < kQuadrature * size);
        }
        QCOMPARE(light.sky.sunLight, Vec3(0.0));
        QVERIFY(glm::length(light.sky.zenith - radiance) + glm::length(light.sky.horizon - radiance) < 1e-6);
    }
    void skiesHaveTheMeanLuminanceOfTheStudio() {
        const double studio = luminance(meanRadiance(skyLightOf(skyOf(SkyPreset::Studio, Theme::Light))));
        for (const double factor : {1e-4, 1.0, 1e4}) {
            for (const SkyPreset preset : {SkyPreset::Overcast, SkyPreset::Evening, SkyPreset::Night}) {
                RadianceImage image = imageOf(skyOf(preset, Theme::Light), 1024);
                for (auto& pixel : image.pixels) {
                    for (float& value : pixel) value *= static_cast<float>(factor);
                }
                const double made = luminance(meanRadiance(skyLightOf(std::move(image))));
                QVERIFY2(std::abs(made / studio - 1.0) < 0.02, qPrintable(QString::number(made / studio)));
            }
        }
    }
    void pictureOfAPresetLooksLikeIt_data() {
        QTest::addColumn<int>("preset");
        QTest::newRow("overcast") << static_cast<int>(SkyPreset::Overcast);
        QTest::newRow("morning") << static_cast<int>(SkyPreset::Morning);
        QTest::newRow("evening") << static_cast<int>(SkyPreset::Evening);
    }
    void pictureOfAPresetLooksLikeIt() {
        QFETCH(int, preset);
        const auto name = static_cast<SkyPreset>(preset);
        const Sky sky = skyOf(name, Theme::Light);
        const SkyLight made = skyLightOf(imageOf(sky, 2048), sky.groundAlbedo);
        const double factor = luminance(meanRadiance(made)) / luminance(meanRadiance(skyLightOf(sky)));
        const QImage ofFile =
            wallIn({.skyFile = shared(made), .exposure = -std::log2(factor), .hasOverlays = false}, 32);
        const QImage ofPreset = wallIn({.sky = name, .hasOverlays = false}, 32);
        int apart = 0, count = 0;
        for (int y = 0; y < ofFile.height(); ++y) {
            for (int x = 0; x < ofFile.width(); ++x, ++count) {
                const QColor one = ofFile.pixelColor(x, y), other = ofPreset.pixelColor(x, y);
                const int most = std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                           std::abs(one.blue() - other.blue())});
                apart += most > 3 ? 1 : 0;
            }
        }
        QVERIFY2(apart == 0, qPrintable(QString("%1 of %2 pixels").arg(apart).arg(count)));
    }
    /// One after another in a renderer, and back to the presets.
    void skiesCanBeExchanged() {
        const auto scene = test::starterScene();
        RenderView view{.size = kPictureSize};
        view.camera = framing(view.camera, boundsOf(*scene), kPictureSize);
        OffscreenRenderer renderer = OffscreenRenderer::create().value();
        const auto drawn = [&](std::shared_ptr<const SkyLight> file) {
            view.settings.skyFile = std::move(file);
            return renderer.renderImage(scene, view, 0)->pixels;
        };
        const auto preset = drawn(nullptr);
        const auto red = drawn(shared(skyLightOf(test::skyImage(16, [](Vec3) { return Vec3(1.0, 0.1, 0.1); }))));
        const auto blue = drawn(shared(skyLightOf(test::skyImage(32, [](Vec3) { return Vec3(0.1, 0.1, 1.0); }))));
        QVERIFY(red[0] > red[2] + 50 && blue[0] + 50 < blue[2]);
        QVERIFY(drawn(nullptr) == preset);
    }
    /// A direction in the picture is behind what is seen in that direction: its left is not exchanged with its right.
    void backgroundIsWhereItIs() {
        const auto scene = test::starterScene();
        RenderView view{.size = kPictureSize, .settings = {.hasOverlays = false}};
        view.camera = framing(view.camera, boundsOf(*scene), kPictureSize);
        view.camera.target.y += 5.0 * view.camera.distance;  // above all bodies
        const Vec3 right = axesOf(view.camera).right;
        view.settings.skyFile = shared(skyLightOf(test::skyImage(
            256, [&](Vec3 d) { return glm::dot(d, right) > 0.0 ? Vec3(1.0, 0.1, 0.1) : Vec3(0.1, 0.1, 1.0); })));
        const Image image = renderImage(scene, view, 0).value();
        const std::uint8_t* first = image.pixels.data();
        const std::uint8_t* last = first + 3 * (kPictureSize.width - 1);
        QVERIFY(first[2] > first[0] + 50);
        QVERIFY(last[0] > last[2] + 50);
    }
    /// The ground fades into the horizon: nothing of what is below it is seen, nor does it light.
    void lowerHalfIsNotUsed() {
        const QImage seen =
            wallIn({.skyFile = shared(skyLightOf(test::skyImage(
                        64, [](Vec3 d) { return d.y > 0.0 ? Vec3(1.0, 0.2, 0.2) : Vec3(0.0, 9.0, 0.0); }))),
                    .hasOverlays = false},
                   4);
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) {
                const QColor pixel = seen.pixelColor(x, y);
                QVERIFY2(pixel.green() <= pixel.red() + 2, qPrintable(QString("%1, %2").arg(x).arg(y)));
            }
        }
    }
    /// Skies of one colour alone, without a sun or with one straight above, leave no pixel undefined.
    void extremeSkies() {
        const auto brightness = [](const QImage& image) {
            double sum = 0.0;
            for (int x = 0; x < image.width(); ++x) sum += image.pixelColor(x, image.height() - 1).value();
            return sum / image.width();
        };
        QVERIFY(brightness(wallIn(
                    {.skyFile = shared(skyLightOf(test::skyImage(16, [](Vec3) { return Vec3(0.0, 1.0, 0.0); })))}, 2)) >
                50.0);
        const QImage noon = wallIn(
            {.skyFile =
                 shared(skyLightOf(test::skyImage(512, [](Vec3 d) { return Vec3(d.y > 0.9995 ? 5000.0 : 0.2); })))},
            2);
        QVERIFY(brightness(noon) > 50.0);
        QVERIFY(noon == noon.copy());
    }
    void exposureBrightens() {
        const auto file = shared(skyLightOf(imageOf(skyOf(SkyPreset::Evening, Theme::Light), 256)));
        const QColor normal = wallIn({.skyFile = file}, 0).pixelColor(5, 5);
        QVERIFY(wallIn({.skyFile = file, .exposure = -1.0}, 0).pixelColor(5, 5).value() < normal.value() - 20);
    }
};

RUBBLE_TEST_WITH(SkyFilePicturesTest, QCoreApplication)
#include "SkyFilePicturesTest.moc"
