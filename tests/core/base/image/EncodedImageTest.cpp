#include "core/base/image/EncodedImage.h"
#include "core/base/limits/ImageLimits.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/TestImages.h"

#include <QTest>

using namespace rubble;

namespace {

QString faultOf(const std::string& bytes) { return QString::fromStdString(errorText(EncodedImage::of(bytes))); }

}  // namespace

class EncodedImageTest : public QObject {
    Q_OBJECT
private slots:
    void framesAreRead() {
        const EncodedImage png = imageOf(checkerPng(3)), jpeg = imageOf(orangeJpeg());
        QCOMPARE(png.width(), 24u);
        QCOMPARE(png.height(), 24u);
        QVERIFY(png.type() == ImageType::Png && jpeg.type() == ImageType::Jpeg);
        QCOMPARE(jpeg.width(), 8u);
        QCOMPARE(jpeg.sizeText(), std::string("8 × 8"));
        QCOMPARE(jpeg.mediaType(), std::string_view("image/jpeg"));
        QVERIFY(png.bytes() == checkerPng(3));
    }
    void everyTruncatedFileIsRejected() {
        for (const std::string& whole : {checkerPng(1), orangeJpeg()})
            for (std::size_t size = 0; size < whole.size(); ++size)
                QVERIFY2(!EncodedImage::of(whole.substr(0, size)), std::to_string(size).c_str());
    }
    void everyChangedByteOfAPngIsRejected() {
        const std::string whole = checkerPng(1);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ 1);
            QVERIFY2(!EncodedImage::of(changed), std::to_string(at).c_str());
        }
        QCOMPARE(faultOf(whole.substr(0, 60) + '?' + whole.substr(61)),
                 QString("is damaged or ends too early; save it again"));
    }
    void claimsOfManyPixelsAreRejected() {
        QCOMPARE(faultOf(pngFile(50000, 50000, "")),
                 QString("has 50000 × 50000 pixels; scale it down to 8192 a side at most"));
        QVERIFY(EncodedImage::of(pngFile(kMaxImageSide, kMaxImageSide, "")).hasValue());
        QCOMPARE(faultOf(pngFile(0, 8, "")), QString("has no pixels; save it again"));
    }
    void imagesForPrintAreRejected() {
        std::string jpeg = orangeJpeg();
        jpeg[jpeg.find("\xff\xc0") + 9] = '\4';
        QCOMPARE(faultOf(jpeg), QString("has colours for print, such as CMYK; save it with RGB colours of 8 bits"));
    }
    void otherFormatsAndLargeFilesAreRejected() {
        QCOMPARE(faultOf("GIF89a"), QString("is neither PNG nor JPEG; save it as one of them"));
        QCOMPARE(faultOf(checkerPng() + std::string(kMaxImageBytes, ' ')),
                 QString("is larger than 32 MiB; scale it down, or save it as JPEG"));
    }
};

RUBBLE_TEST(EncodedImageTest)
#include "EncodedImageTest.moc"
