#include "editor/commands/GreyImageLoading.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class GreyImageLoadingTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    /// The image after a round trip through a PNG file.
    GreyImage throughFile(const QImage& picture) {
        const QString path = m_folder.filePath("picture.png");
        if (!picture.save(path)) qFatal("The picture cannot be written.");
        return **loadGreyImage(path);
    }

private slots:
    void greysOf8BitsAreExact() {
        QImage picture(16, 16, QImage::Format_Grayscale8);
        for (int k = 0; k < 256; ++k) picture.scanLine(k / 16)[k % 16] = static_cast<uchar>(k);
        const GreyImage image = throughFile(picture);
        QCOMPARE(image.bits, 8u);
        QVERIFY(image.opacity.empty());
        for (std::uint16_t k = 0; k < 256; ++k) QCOMPARE(image.grey[k], k);
    }
    void greysOf16BitsAreExact() {
        QImage picture(256, 256, QImage::Format_Grayscale16);
        for (int k = 0; k < 65536; ++k) {
            reinterpret_cast<quint16*>(picture.scanLine(k / 256))[k % 256] = static_cast<quint16>(k);
        }
        const GreyImage image = throughFile(picture);
        QCOMPARE(image.bits, 16u);
        QVERIFY(image.opacity.empty());
        for (std::size_t k = 0; k < 65536; ++k) QCOMPARE(image.grey[k], static_cast<std::uint16_t>(k));
    }
    void keepsOpacityAndConvertsColours() {
        QImage picture(3, 1, QImage::Format_ARGB32);
        picture.setPixel(0, 0, qRgba(100, 100, 100, 255));
        picture.setPixel(1, 0, qRgba(200, 200, 200, 128));
        picture.setPixel(2, 0, qRgba(255, 0, 0, 1));
        const GreyImage image = throughFile(picture);
        QCOMPARE(image.bits, 8u);
        QCOMPARE(image.grey, (std::vector<std::uint16_t>{100, 200, 87}));  // 255 * 11 / 32
        QCOMPARE(image.opacity, (std::vector<std::uint16_t>{255, 128, 1}));
        QCOMPARE(greyImageOf(pictureOf(image)), image);
    }
    void opacityOf16BitsIsKept() {
        QImage picture(1, 1, QImage::Format_RGBA64);
        picture.setPixelColor(0, 0, QColor::fromRgba64(4660, 4660, 4660, 30000));
        const GreyImage image = throughFile(picture);
        QCOMPARE(image.bits, 16u);
        QCOMPARE(image.grey[0], std::uint16_t{4660});
        QCOMPARE(image.opacity[0], std::uint16_t{30000});
    }
    void rejectsOtherFilesAndLargeImages() {
        const auto missing = loadGreyImage(m_folder.filePath("none.png"));
        QVERIFY(!missing);
        QVERIFY2(missing.error().message.starts_with("none.png cannot be read as a picture: "),
                 missing.error().message.c_str());
        QImage wide(1025, 2, QImage::Format_Grayscale8);
        wide.fill(0);
        QVERIFY(wide.save(m_folder.filePath("wide.png")));
        const auto large = loadGreyImage(m_folder.filePath("wide.png"));
        QVERIFY(!large);
        QCOMPARE(large.error().message, std::string("wide.png is too large: 1025 \xc3\x97 2 pixels. "
                                                    "Scale it down to at most 1024 pixels a side."));
    }
};

RUBBLE_TEST_WITH(GreyImageLoadingTest, QCoreApplication)
#include "GreyImageLoadingTest.moc"
