#include "editor/commands/GreyImageLoading.h"
#include "tests/support/TestProgram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include <sys/stat.h>

using namespace rubble;

class GreyImageLoadingTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    /// The image after a round trip through a PNG file.
    GreyImage throughFile(const QImage& picture) {
        const QString path = m_folder.filePath("picture.png");
        if (!picture.save(path)) qFatal("The picture cannot be written.");
        return *loadPicture(path)->image;
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
        const auto missing = loadPicture(m_folder.filePath("none.png"));
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::NotFound);
        QImage wide(8193, 2, QImage::Format_Grayscale8);
        wide.fill(0);
        for (const char* name : {"wide.png", "wide.bmp"}) {
            QVERIFY(wide.save(m_folder.filePath(name)));
            const auto large = loadPicture(m_folder.filePath(name));
            QVERIFY(!large);
            QCOMPARE(large.error().message, '"' + std::string(name) + "\" is too large: 8193 \xc3\x97 2 pixels. " +
                                                "Scale it down to at most 8192 pixels a side.");
        }
    }
    void largePicturesAreReduced() {
        QImage wide(2048, 512, QImage::Format_Grayscale8);
        wide.fill(40);
        for (const char* name : {"wide.png", "wide.bmp"}) {
            QVERIFY(wide.save(m_folder.filePath(name)));
            const auto reduced = loadPicture(m_folder.filePath(name));
            QCOMPARE(reduced->note,
                     '"' + std::string(name) + "\" was reduced from 2048 \xc3\x97 512 to 1024 \xc3\x97 256 pixels.");
            QCOMPARE(reduced->image->width, 1024u);
            QCOMPARE(reduced->image->height, 256u);
            QVERIFY(std::ranges::all_of(reduced->image->grey, [](auto grey) { return grey == 40; }));
        }
    }
    void pipeIsRefusedAtOnce() {
        const QString path = m_folder.filePath("pipe.png");
        QCOMPARE(mkfifo(path.toUtf8().constData(), 0600), 0);
        const auto pipe = loadPicture(path);
        QCOMPARE(pipe.error().message, "Cannot read \"" + path.toStdString() + "\": it is a pipe, not a file.");
    }
    /// The reader of vector pictures would open the file that the picture names.
    void vectorPictureIsRefused() {
        QFile file(m_folder.filePath("picture.png"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"8\" height=\"8\">"
            "<image href=\"/etc/passwd\" width=\"8\" height=\"8\"/></svg>");
        file.close();
        const auto picture = loadPicture(file.fileName());
        QCOMPARE(picture.error().message,
                 std::string("\"picture.png\" is not a PNG, JPEG, BMP or PGM picture. Save it as PNG."));
    }
};

RUBBLE_TEST_WITH(GreyImageLoadingTest, QCoreApplication)
#include "GreyImageLoadingTest.moc"
