#include "viewport/render/Image.h"

#include "tests/support/TestProgram.h"

#include <QImage>

#include <array>
#include <cmath>

using namespace rubble;

namespace {

/// A grey image with a red pixel in its lower right corner.
Image corner(int width, int height) {
    Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 100)};
    image.pixels[image.pixels.size() - 3] = 255;
    return image;
}

}  // namespace

class ImageTest : public QObject {
    Q_OBJECT
private slots:
    void pngHasTheSamePixels() {
        for (const PngEffort effort : {PngEffort::Thorough, PngEffort::Quick}) {
            const Result<std::string> png = pngOf(corner(5, 3), effort);
            QVERIFY(png);
            const QImage read = QImage::fromData(QByteArray::fromStdString(*png));
            QCOMPARE(read.size(), QSize(5, 3));
            QCOMPARE(read.pixelColor(4, 2), QColor(255, 100, 100));
            QCOMPARE(read.pixelColor(0, 0), QColor(100, 100, 100));
        }
    }
    /// Colours and opacities come back from pictures of them in front of black and white, also in the PNG.
    void cutOutsHaveOpacities() {
        const std::vector<std::array<int, 4>> seen = {
            {200, 100, 50, 255}, {30, 60, 90, 128}, {250, 5, 128, 51}, {0, 0, 0, 0}};
        Image black{2, 2, {}}, white{2, 2, {}};
        for (const auto& [r, g, b, a] : seen) {
            for (const int colour : {r, g, b}) {
                black.pixels.push_back(static_cast<std::uint8_t>((colour * a + 127) / 255));
                white.pixels.push_back(static_cast<std::uint8_t>((colour * a + 127) / 255 + 255 - a));
            }
        }
        const Image image = cutOut(black, white);
        const QImage read = QImage::fromData(QByteArray::fromStdString(*pngOf(image)));
        QVERIFY(read.hasAlphaChannel());
        for (int k = 0; k < 4; ++k) {
            const auto& [r, g, b, a] = seen[static_cast<std::size_t>(k)];
            const QColor colour = read.pixelColor(k % 2, k / 2);
            QCOMPARE(colour.alpha(), a);
            const int tolerance = a == 0 ? 0 : 255 / a;  // of what rounding leaves of faint colours
            QVERIFY(std::abs(colour.red() - r) <= tolerance && std::abs(colour.green() - g) <= tolerance);
            QVERIFY(std::abs(colour.blue() - b) <= tolerance);
        }
    }
    void imagesLieBesideEachOther() {
        const Image both = besideEachOther(corner(2, 2), corner(3, 2), 4);
        QCOMPARE(both.width, 9);
        QCOMPARE(both.height, 2);
        const auto red = [&](int x, int y) { return both.pixels[static_cast<std::size_t>(3 * (y * both.width + x))]; };
        QCOMPARE(red(1, 1), std::uint8_t{255});
        QCOMPARE(red(1, 0), std::uint8_t{100});
        for (int x = 2; x < 6; ++x) QCOMPARE(red(x, 0), std::uint8_t{255});  // white
        QCOMPARE(red(6, 1), std::uint8_t{100});
        QCOMPARE(red(8, 1), std::uint8_t{255});
    }
};

RUBBLE_TEST(ImageTest)
#include "ImageTest.moc"
