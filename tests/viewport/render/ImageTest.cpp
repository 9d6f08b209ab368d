#include "viewport/render/Image.h"

#include "tests/support/TestProgram.h"

#include <QImage>

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
