#include "core/io/media/GreyImageFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace rubble;

namespace {

const std::filesystem::path kDensities = RUBBLE_SOURCE_DIR "/tests/data/densities";

/// An image of the size of the small pictures, from the value of each pixel.
std::vector<std::uint16_t> valuesOf(const std::function<std::uint32_t(std::uint32_t x, std::uint32_t n)>& value) {
    std::vector<std::uint16_t> values;
    for (std::uint32_t n = 0; n < 20; ++n) values.push_back(static_cast<std::uint16_t>(value(n % 5, n)));
    return values;
}

GreyImage loaded(const char* name) {
    const Result<DensityPicture> picture = loadDensityPicture(kDensities / name);
    if (!picture) qFatal("%s", picture.error().message.c_str());
    if (verifyGreyImage(*picture->image)) qFatal("%s", verifyGreyImage(*picture->image)->c_str());
    return *picture->image;
}

std::string pictureFault(const Result<GreyImage>& image) { return image ? "" : image.error().message; }

}  // namespace

class GreyImageFileTest : public QObject {
    Q_OBJECT
private slots:
    void everyKindOfPngIsRead() {
        const GreyImage one = loaded("grey-1.png");
        QCOMPARE(one.bits, 8u);
        QCOMPARE(one.grey, valuesOf([](auto x, auto n) { return (x + n / 5) % 2 * 255; }));
        const GreyImage grey = loaded("grey-16.png");
        QCOMPARE(grey.bits, 16u);
        QCOMPARE(grey.grey, valuesOf([](auto, auto n) { return 3000 * n; }));
        const GreyImage colour = loaded("colour-8.png");
        QCOMPARE(colour.grey, valuesOf([](auto, auto n) { return (11 * n + 16 * 40 + 5 * 80) / 32; }));
        QVERIFY(colour.opacity.empty());
        const GreyImage interlaced = loaded("colour-16-interlaced.png");
        QCOMPARE(interlaced.bits, 16u);
        QCOMPARE(interlaced.grey, valuesOf([](auto, auto n) { return 1000 * n; }));
        QCOMPARE(interlaced.opacity, valuesOf([](auto x, auto) { return 65535 - x; }));
        const GreyImage palette = loaded("palette.png");
        QCOMPARE(palette.grey, valuesOf([](auto, auto n) { return 10 * n; }));
        QCOMPARE(palette.opacity, valuesOf([](auto, auto n) { return n == 0 ? 0u : n == 1 ? 128u : 255u; }));
    }
    void largePictureIsReduced() {
        const Result<DensityPicture> picture = loadDensityPicture(kDensities / "large.png");
        QCOMPARE(picture->note,
                 std::string("\"large.png\" was reduced from 2050 \xc3\x97 1025 to 1024 \xc3\x97 512 pixels."));
        const GreyImage& image = *picture->image;
        QCOMPARE(image.width, 1024u);
        QCOMPARE(image.height, 512u);
        for (std::size_t k = 0; k < image.grey.size(); ++k) QCOMPARE(image.grey[k], k % 1024 < 512 ? 0 : 255);
    }
    void damagedFilesAreRejected() {
        const std::string png = *readFile(kDensities / "crack.png");
        QVERIFY(greyImageOfPng(png, "crack.png"));
        for (std::size_t size = 0; size + 13 < png.size(); ++size) {  // without the end of the last two chunks
            const std::string fault = pictureFault(greyImageOfPng(png.substr(0, size), "crack.png"));
            QVERIFY2(fault.starts_with("\"crack.png\" cannot be read as a picture: ") && fault.ends_with('.'),
                     qPrintable(QString("%1: %2").arg(size).arg(QString::fromStdString(fault))));
        }
        std::string wrong = png;
        wrong[60] ^= 1;
        QVERIFY(!greyImageOfPng(wrong, "crack.png"));
    }
    void otherFilesAreRejected() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("photo.jpg").toStdString();
        QVERIFY(writeFileAtomically(path, "\xff\xd8\xff"));
        const Result<DensityPicture> picture = loadDensityPicture(path);
        QCOMPARE(picture.error().message, std::string("\"photo.jpg\" is not a PNG picture. Save it as PNG."));
        QCOMPARE(loadDensityPicture(path.parent_path() / "none.png").error().code, ErrorCode::NotFound);
    }
    void sizeIsLimited() {
        QVERIFY(checkPictureSize("wide.png", kMaxPictureSide, kMaxPictureSide));
        std::string png = *readFile(kDensities / "grey-16.png");
        QCOMPARE(checkPictureSize("wide.png", 8193, 2).error().message,
                 std::string("\"wide.png\" is too large: 8193 \xc3\x97 2 pixels. "
                             "Scale it down to at most 8192 pixels a side."));
    }
};

RUBBLE_TEST(GreyImageFileTest)
#include "GreyImageFileTest.moc"
