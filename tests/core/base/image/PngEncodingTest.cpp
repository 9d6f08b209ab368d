#include "core/base/image/PngEncoding.h"

#include "core/base/image/EncodedImage.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <vector>

using namespace rubble;

class PngEncodingTest : public QObject {
    Q_OBJECT
private slots:
    /// ImageTest reads the pixels back.
    void filesAreValid() {
        const std::vector<std::uint8_t> colours(3 * 7 * 5, 40), opacities(7 * 5, 128);
        for (const PngEffort effort : {PngEffort::Thorough, PngEffort::Quick}) {
            const Result<std::string> opaque = encodedPng({7, 5, colours}, effort);
            const Result<std::string> clear = encodedPng({7, 5, colours, opacities}, effort);
            QVERIFY(opaque && clear);
            QVERIFY(*opaque != *clear);
            for (const std::string& file : {*opaque, *clear}) {
                const Result<EncodedImage> image = EncodedImage::of(file);
                QVERIFY(image);
                QCOMPARE(image->sizeText(), std::string("7 × 5"));
            }
        }
    }
    void effortMakesFilesSmaller() {
        std::vector<std::uint8_t> colours;
        for (int k = 0; k < 3 * 64 * 64; ++k) colours.push_back(static_cast<std::uint8_t>(k / 192 + k % 192 / 3));
        const PngPixels pixels{64, 64, colours};
        QVERIFY(encodedPng(pixels, PngEffort::Thorough)->size() < encodedPng(pixels, PngEffort::Quick)->size());
    }
};

RUBBLE_TEST(PngEncodingTest)
#include "PngEncodingTest.moc"
