// Tests viewport/render/light/Lighting.cpp and viewport/render/light/SkyLight.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/ToneMapping.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

constexpr ImageSize kSkyPicture{240, 160};
constexpr SkyPreset kAllSkies[] = {SkyPreset::Studio, SkyPreset::Overcast, SkyPreset::Morning, SkyPreset::Evening,
                                   SkyPreset::Night};

QImage wallIn(const RenderSettings& settings) {
    const auto scene = test::starterScene();
    RenderView view{.camera = orbited({}, 0.6, 0.1), .size = kSkyPicture, .settings = settings};
    view.camera = framing(view.camera, boundsOf(*scene), kSkyPicture);
    const Image image = renderImage(scene, view, 0).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

/// In [0, 255].
double meanLightness(const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) sum += image.pixelColor(x, y).lightness();
    }
    return sum / (image.width() * image.height());
}

}  // namespace

class SkyPicturesTest : public QObject {
    Q_OBJECT
private slots:
    void picturesOfPresetsDiffer() {
        for (const SkyPreset one : kAllSkies) {
            for (const SkyPreset other : kAllSkies) {
                if (one >= other) continue;
                const double apart = test::meanDifference(wallIn({.sky = one}), wallIn({.sky = other}));
                QVERIFY2(apart > 10.0, qPrintable(QString::number(apart)));
            }
        }
        QVERIFY(meanLightness(wallIn({.sky = SkyPreset::Night})) <
                0.75 * meanLightness(wallIn({.sky = SkyPreset::Evening})));
    }
    void picturesOutdoorsDoNotDependOnTheTheme() {
        for (const SkyPreset sky : kAllSkies) {
            const bool isSame =
                wallIn({.theme = Theme::Light, .sky = sky}) == wallIn({.theme = Theme::Dark, .sky = sky});
            QCOMPARE(isSame, sky != SkyPreset::Studio);
        }
    }
    void exposureBrightens() {
        for (const SkyPreset sky : kAllSkies) {
            const double normal = meanLightness(wallIn({.sky = sky}));
            QVERIFY(meanLightness(wallIn({.sky = sky, .exposure = 0.5})) > normal + 2.0);
            QVERIFY(meanLightness(wallIn({.sky = sky, .exposure = -0.5})) < normal - 5.0);
        }
    }
    void neitherBlackNorWhite() {
        for (const SkyPreset sky : kAllSkies) {
            const QImage seen = wallIn({.sky = sky, .hasEdges = false, .hasOverlays = false});
            int least = 255, most = 0;
            for (int y = 0; y < seen.height(); ++y) {
                for (int x = 0; x < seen.width(); ++x) {
                    least = std::min(least, seen.pixelColor(x, y).value());
                    most = std::max(most, seen.pixelColor(x, y).value());
                }
            }
            QVERIFY2(least > 4 && most < 255,
                     qPrintable(QString("%1 to %2 in sky %3").arg(least).arg(most).arg(static_cast<int>(sky))));
        }
    }
    /// The lines of grids and scale bars are dark on bright ground, and bright on dark ground.
    void linesContrastWithTheGround() {
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            for (const SkyPreset sky : kAllSkies) {
                const Environment environment = environmentOf(sky, theme, skyLightOf(skyOf(sky, theme)));
                const double ground = srgbOf(toneMapped(environment.soil)).y;
                QCOMPARE(environment.isDark, ground < 0.4);
                const double contrast = std::abs(static_cast<double>(environment.grid.y) - ground);
                QVERIFY2(contrast > 0.25, qPrintable(QString::number(contrast)));
            }
        }
    }
    /// The backdrop of the studio is shown in the colours that the window's themes are made for.
    void studioHasTheBackdropOfItsTheme() {
        const auto shown = [](Theme theme) {
            const Environment made =
                environmentOf(SkyPreset::Studio, theme, skyLightOf(skyOf(SkyPreset::Studio, theme)));
            return srgbOf(toneMapped(made.horizon));
        };
        QVERIFY(std::abs(shown(Theme::Dark).z - 0.335) < 1e-3);
        QVERIFY(std::abs(shown(Theme::Light).z - 0.955) < 1e-3);
    }
};

RUBBLE_TEST_WITH(SkyPicturesTest, QCoreApplication)
#include "SkyPicturesTest.moc"
