// Tests viewport/render/ImageDecoding.cpp and how textures are drawn.
#include "core/asset/library/StarterProject.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/TestImages.h"
#include "tests/support/viewport/Pictures.h"
#include "viewport/render/ImageDecoding.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/SceneBuilder.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

constexpr ImageSize kSize{200, 200};
constexpr std::uint32_t kLongest = 4096;

/// The starter project with a chessboard of red and blue squares of 0.5 m on its wall.
Project textured(const std::string& image = checkerPng()) {
    Project project = starterProject();
    project.materials[0].finish = Finish::Plain;
    project.materials[0].outside = {1.0, 1.0, 1.0};
    project.materials[0].inside = {0.0, 1.0, 0.0};
    project.assets[0].texture =
        Texture{.name = "checker.png", .image = std::make_shared<const EncodedImage>(imageOf(image)), .materials = {0}};
    return project;
}

RenderScene sceneWith(const Project& project, SceneOptions options = {}) {
    options.asset = project.assets[0].id;
    return sceneOf(project, bakesOf(project).value(), options);
}

QImage texturedPicture(const RenderScene& scene, int samples = 0) {
    RenderView view{.size = kSize};
    view.camera = framing(view.camera, boundsOf(scene), kSize);
    view.settings.hasShadows = view.settings.hasAxes = view.settings.hasEdges = false;
    view.settings.msaa = 1;
    const Image image = renderImage(std::make_shared<RenderScene>(scene), view, samples).value();
    return QImage(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

/// The number of pixels of a hue: where one channel is far above the others.
struct Hues {
    int red = 0, green = 0, blue = 0;
};
Hues huesOf(const QImage& image) {
    Hues hues;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const int r = pixel.red(), g = pixel.green(), b = pixel.blue();
            hues.red += r > 60 && r > 2 * g && r > 2 * b;
            hues.green += g > 60 && g > 2 * r && g > 2 * b;
            hues.blue += b > 60 && b > 2 * r && b > 2 * g;
        }
    }
    return hues;
}

QColor pixelOf(const DecodedImage& image, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* at = &image.pixels[3 * (std::size_t{y} * image.width + x)];
    return {at[0], at[1], at[2]};
}

}  // namespace

class TextureTest : public QObject {
    Q_OBJECT
private slots:
    void imagesAreDecoded() {
        const DecodedImage png = *decoded(imageOf(checkerPng()), kLongest);
        QCOMPARE(png.pixels.size(), std::size_t{3 * 16 * 16});
        QCOMPARE(pixelOf(png, 0, 0), QColor(255, 0, 0));
        QCOMPARE(pixelOf(png, 15, 0), QColor(0, 0, 255));
        const QColor orange = pixelOf(*decoded(imageOf(orangeJpeg()), kLongest), 4, 4);
        QVERIFY(std::abs(orange.red() - 255) < 4 && std::abs(orange.green() - 128) < 4 && orange.blue() < 4);
    }
    void largeImagesAreHalved() {
        const DecodedImage half = *decoded(imageOf(checkerPng(4)), 16);
        QCOMPARE(half.width, 16u);
        QCOMPARE(pixelOf(half, 5, 0), QColor(0, 0, 255));
        const DecodedImage dot = *decoded(imageOf(checkerPng(2, 0x0000ff, 0x000001)), 1);
        QCOMPARE(pixelOf(dot, 0, 0), QColor(0, 0, 128));
    }
    void damagedImagesAreNotDecoded() {
        QVERIFY(!decoded(imageOf(pngFile(8192, 8192, "x")), kLongest));
        std::string jpeg = orangeJpeg();
        const std::size_t table = jpeg.find("\xff\xc4");
        for (std::size_t k = table + 4; k < table + 21; ++k) jpeg[k] = '\xff';
        QVERIFY(!decoded(imageOf(jpeg), kLongest));
    }
    /// Every image that is accepted is decoded in the size that it states, or not at all.
    void mutatedImagesAreDecodedOrRefused() {
        Random random(41);
        int accepted = 0, shown = 0;
        for (int k = 0; k < 4000; ++k) {
            std::string bytes = k % 2 == 0 ? checkerPng(1) : orangeJpeg();
            for (std::uint64_t changes = 1 + random.below(4); changes > 0; --changes)
                bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
            if (k % 4 == 0) bytes = test::withPngChecksums(bytes);
            const Result<EncodedImage> image = EncodedImage::of(bytes);
            if (!image || image->width() > 512 || image->height() > 512) continue;
            ++accepted;
            const std::optional<DecodedImage> pixels = decoded(*image, kLongest);
            if (!pixels) continue;
            ++shown;
            QCOMPARE(pixels->pixels.size(), std::size_t{3} * image->width() * image->height());
        }
        QVERIFY(accepted > 500 && shown > 100);
    }
    void outsideHasTheImageAndCutsHaveTheMaterial() {
        const Project project = textured();
        const QImage whole = texturedPicture(sceneWith(project));
        const Hues assembled = huesOf(whole);
        QVERIFY2(assembled.red > 2000 && assembled.blue > 2000, qPrintable(QString::number(assembled.red)));
        QVERIFY(assembled.green < 20);
        // u goes to the right and v up: the square at the top left of the image is to the lower right of the middle.
        const Hues lowerRight = huesOf(whole.copy(100, 100, 100, 100)),
                   upperRight = huesOf(whole.copy(100, 0, 100, 100));
        QVERIFY(lowerRight.red > 2 * lowerRight.blue && upperRight.blue > 2 * upperRight.red);
        const QImage exploded = texturedPicture(sceneWith(project, {.explodeFactor = 1.5}));
        const Hues apart = huesOf(exploded);
        QVERIFY(apart.red > 100 && apart.blue > 100 && apart.green > 100);
        // The inside material alone gives the cuts as many pixels.
        Project plain = project;
        plain.assets[0].texture.reset();
        const int cuts = huesOf(texturedPicture(sceneWith(plain, {.explodeFactor = 1.5}))).green;
        QVERIFY(std::abs(cuts - apart.green) <= cuts / 50);
    }
    void imageIsMultipliedByTheColour() {
        Project project = textured(checkerPng(2, 0xffffff, 0xffffff));
        project.materials[0].outside = {1.0, 0.0, 0.0};
        const QImage multiplied = texturedPicture(sceneWith(project));
        project.assets[0].texture.reset();
        const QImage red = texturedPicture(sceneWith(project));
        const double difference = test::meanDifference(multiplied, red);
        QVERIFY2(difference < 6.0, qPrintable(QString::number(difference)));  // edges with an image are worn
    }
    void otherColouringsIgnoreTheImage() {
        Project project = textured();
        for (const SceneColouring colouring :
             {SceneColouring::Fragment, SceneColouring::Level, SceneColouring::Volume}) {
            const QImage with = texturedPicture(sceneWith(project, {.colouring = colouring}));
            Project plain = project;
            plain.assets[0].texture.reset();
            QCOMPARE(with, texturedPicture(sceneWith(plain, {.colouring = colouring})));
        }
    }
    void imageThatCannotBeDecodedShowsTheMaterial() {
        Project project = textured(pngFile(16, 16, "x"));
        const QImage damaged = texturedPicture(sceneWith(project));
        project.assets[0].texture.reset();
        QCOMPARE(damaged, texturedPicture(sceneWith(project)));
    }
    void transparentAssetsAreTextured() {
        Project project = textured();
        project.materials[0].opacity = 0.8;
        const Hues hues = huesOf(texturedPicture(sceneWith(project)));
        QVERIFY(hues.red > 500 && hues.blue > 500);
    }
    void pictureIsTheSameEachTime() {
        const RenderScene scene = sceneWith(textured());
        QCOMPARE(texturedPicture(scene, 2), texturedPicture(scene, 2));
    }
};

RUBBLE_TEST_WITH(TextureTest, QCoreApplication)
#include "TextureTest.moc"
