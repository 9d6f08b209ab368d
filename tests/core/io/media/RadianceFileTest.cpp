#include "core/io/media/RadianceFile.h"

#include "core/base/Random.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FuzzedReaders.h"
#include "tests/support/files/RadianceWriting.h"

#include <QTemporaryDir>
#include <QTest>

using namespace rubble;
using Encoding = test::RadianceText::Encoding;

namespace {

constexpr Encoding kEncodings[] = {Encoding::Plain, Encoding::Older, Encoding::Newer};

/// Different in each pixel of the upper half, and of long runs in the lower one.
test::RgbePixel somePixel(std::uint32_t x, std::uint32_t y) {
    if (y >= 8) return {200, 7, 9, static_cast<std::uint8_t>(120 + y)};
    return {static_cast<std::uint8_t>(10 + x), static_cast<std::uint8_t>(20 + y), static_cast<std::uint8_t>(3 * x + y),
            static_cast<std::uint8_t>(120 + x % 16)};
}
test::RadianceText someSky() { return {.width = 32, .height = 16, .pixel = somePixel}; }

Result<RadianceImage> read(const std::string& bytes) { return radianceOfFile(bytes, "sky.hdr"); }
QString faultOf(const std::string& bytes) {
    const Result<RadianceImage> image = read(bytes);
    return image ? "" : QString::fromStdString(image.error().message);
}
std::string replaced(std::string text, std::string_view from, std::string_view to) {
    return text.replace(text.find(from), from.size(), to);
}

/// The picture that somePixel() makes.
RadianceImage someImage() {
    RadianceImage image{32, 16, {}};
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 32; ++x) {
            const test::RgbePixel pixel = somePixel(x, y);
            const auto value = [&](std::size_t k) {
                return static_cast<float>(std::ldexp(pixel[k] + 0.5, pixel[3] - 136));
            };
            image.pixels.push_back({value(0), value(1), value(2)});
        }
    }
    return image;
}

}  // namespace

class RadianceFileTest : public QObject {
    Q_OBJECT
private slots:
    void everyEncodingInEveryOrientation() {
        for (const Encoding encoding : kEncodings) {
            for (const char* order : {"-Y+X", "-Y-X", "+Y-X", "+Y+X", "+X-Y", "+X+Y", "-X-Y", "-X+Y"}) {
                test::RadianceText text = someSky();
                text.encoding = encoding;
                text.order = order;
                const Result<RadianceImage> image = read(test::radianceFile(text));
                QVERIFY2(image, image ? "" : image.error().message.c_str());
                QVERIFY2(*image == someImage(), order);
            }
        }
    }
    void longRunsOfTheOlderEncoding() {
        const test::RadianceText text{.width = 1024,
                                      .height = 512,
                                      .pixel =
                                          [](auto, auto) {
                                              return test::RgbePixel{9, 9, 9, 128};
                                          },
                                      .encoding = Encoding::Older};
        const std::string bytes = test::radianceFile(text);
        QVERIFY(bytes.size() < 512 * 16);
        QCOMPARE(read(bytes)->pixels.back()[0], static_cast<float>(9.5 / 256.0));
    }
    void exposureIsUndone() {
        test::RadianceText text = someSky();
        text.variables = "# made by hand\nEXPOSURE=2\nEXPOSURE= 2.0\nCOLORCORR=1 0.5 1\n";
        const RadianceImage image = *read(test::radianceFile(text)), plain = someImage();
        QCOMPARE(image.pixels[5][0], plain.pixels[5][0] / 4.0f);
        QCOMPARE(image.pixels[5][1], plain.pixels[5][1] / 2.0f);
    }
    /// Pixels of 4096 columns are averaged by fours, so that no light is lost.
    void largePicturesAreReduced() {
        const test::RadianceText text{.width = 4096, .height = 2048, .pixel = [](auto x, auto y) {
                                          const auto value = static_cast<std::uint8_t>(10 * (x % 2) + 20 * (y % 2));
                                          return test::RgbePixel{value, 5, 5, 136};
                                      }};
        const RadianceImage image = *read(test::radianceFile(text));
        QCOMPARE(image.width, RadianceImage::kMaxWidth);
        QCOMPARE(image.height, RadianceImage::kMaxWidth / 2);
        for (const auto& pixel : image.pixels) QCOMPARE(pixel[0], 15.5f);
    }
    void faultsNameThePlaceAndWhatToDo() {
        const std::string sky = test::radianceFile(someSky());
        const std::size_t pixels = sky.find("+X 32\n") + 6;
        QCOMPARE(faultOf("\x89PNG"),
                 QString("\"sky.hdr\" is no Radiance picture. Select an .hdr file, or convert the picture to one."));
        QCOMPARE(faultOf(replaced(sky, "rle_rgbe", "rle_xyze")),
                 QString("\"sky.hdr\" has pixels in the format \"32-bit_rle_xyze\". Export it with RGB colours, "
                         "32-bit_rle_rgbe."));
        QCOMPARE(faultOf(replaced(sky, "FORMAT", "FORMUT")),
                 QString("\"sky.hdr\" does not name its format: it needs the line \"FORMAT=32-bit_rle_rgbe\"."));
        QCOMPARE(faultOf(replaced(sky, "-Y 16 +X 32", "-Y 16 +Y 32")),
                 QString("\"sky.hdr\" has \"-Y 16 +Y 32\" in place of its size, such as \"-Y 512 +X 1024\". Export it "
                         "again."));
        QCOMPARE(faultOf(replaced(sky, "-Y 16", "-Y 15")),
                 QString::fromUtf8("\"sky.hdr\" has 32 × 15 pixels, but a whole sky is twice as wide as high. Export "
                                   "it as an equirectangular panorama."));
        QCOMPARE(faultOf(replaced(sky, "-Y 16 +X 32", "-Y 8193 +X 16386")),
                 QString::fromUtf8("\"sky.hdr\" is too large: 16386 × 8193 pixels. Scale it down to at most 16384 × "
                                   "8192."));
        QCOMPARE(faultOf(sky.substr(0, sky.size() - 1)),
                 QString("\"sky.hdr\" ends too early, in line 16 of its 16 lines of pixels: it is damaged. Copy or "
                         "export it again."));
        QCOMPARE(faultOf(sky + "\n"), QString("\"sky.hdr\" goes on after its last pixel: it is damaged. Copy or export "
                                              "it again."));
        std::string wrong = sky;
        wrong[pixels + 3] = 31;
        QVERIFY(faultOf(wrong).contains("has 31 pixels in place of 32 in line 1 of"));
        wrong = sky;
        wrong[pixels + 4] = 0;
        QVERIFY(faultOf(wrong).contains("has an empty run in line 1 of"));
        wrong[pixels + 4] = static_cast<char>(128 + 33);
        QVERIFY(faultOf(wrong).contains("has a run that is too long in line 1 of"));
    }
    void faultsOfTheHeader() {
        for (const char* variable : {"EXPOSURE=0", "EXPOSURE=nan", "EXPOSURE=1 2", "COLORCORR=1 1", "EXPOSURE=-1",
                                     "EXPOSURE=1e8\nEXPOSURE=1e8"}) {
            test::RadianceText text = someSky();
            text.variables = std::string(variable) + "\n";
            QVERIFY2(faultOf(test::radianceFile(text)).contains("in its header, whose numbers must be from"), variable);
        }
        QVERIFY(faultOf("#?" + std::string(100000, 'a')).contains("has no end of its header"));
        QVERIFY(faultOf("#?" + std::string(100000, '\n')).contains("does not name its format"));
        for (const char* size : {"-Y 16 +X 0", "-Y 16 +X", "Y 16 X 32", "-Y 16  +X 32", "-Y 16 +X 32 ", "-Y -16 +X 32",
                                 "-Y 16 +X 99999999999", "+Z 16 +X 32", ""}) {
            QVERIFY2(faultOf(replaced(test::radianceFile(someSky()), "-Y 16 +X 32", size)).contains("place of its"),
                     size);
        }
    }
    void olderRunsStayInTheirLine() {
        test::RadianceText text = someSky();
        text.encoding = Encoding::Older;
        const std::string sky = test::radianceFile(text);
        const std::size_t pixels = sky.find("+X 32\n") + 6;
        std::string wrong = sky;
        wrong.replace(pixels, 4, "\1\1\1\2");
        QVERIFY(faultOf(wrong).contains("repeats a pixel before the first one in line 1 of"));
        wrong = sky;
        wrong.replace(pixels + 4, 4, "\1\1\1\40");
        QVERIFY(faultOf(wrong).contains("has a run that is too long in line 1 of"));
        wrong.replace(pixels + 4, 20, std::string("\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\1", 20));
        QVERIFY(faultOf(wrong).contains("has a run that is too long in line 1 of"));
    }
    void withoutLight() {
        test::RadianceText text = someSky();
        text.pixel = [](auto, auto y) { return y < 8 ? test::RgbePixel{} : test::RgbePixel{9, 9, 9, 128}; };
        QCOMPARE(faultOf(test::radianceFile(text)),
                 QString("\"sky.hdr\" is black above the horizon: it gives no light. Select another picture."));
        text.pixel = [](auto, auto) { return test::RgbePixel{9, 9, 9, 255}; };
        QVERIFY(faultOf(test::radianceFile(text)).contains("has a pixel brighter than 1e30 in line 1 of"));
    }
    void cancelled() {
        TaskContext task;
        task.cancel.cancel();
        const auto image = radianceOfFile(test::radianceFile(someSky()), "sky.hdr", task);
        QVERIFY(!image && image.error().code == ErrorCode::Cancelled);
    }
    void filesAreLoaded() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("day.hdr").toStdString();
        QVERIFY(writeFileAtomically(path, test::radianceFile(someSky())));
        QVERIFY(*loadRadiance(path) == someImage());
        QVERIFY(!loadRadiance(folder.filePath("none.hdr").toStdString()));
        QVERIFY(writeFileAtomically(path, "photo"));
        QVERIFY(loadRadiance(path).error().message.starts_with("\"day.hdr\" is no Radiance picture."));
    }
    void everyTruncationIsRefused() {
        for (const Encoding encoding : kEncodings) {
            test::RadianceText text = someSky();
            text.encoding = encoding;
            const std::string sky = test::radianceFile(text);
            for (std::size_t size = 0; size < sky.size(); ++size) {
                const std::string part = sky.substr(0, size);
                QVERIFY2(!read(part), qPrintable(QString::number(size)));
                QCOMPARE(QString::fromStdString(test::radianceFault(part).value_or("")), QString());
            }
        }
    }
    /// Bytes of valid files are replaced, removed and added at random.
    void randomBytesAreReadOrRefused() {
        for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
            Random random(seed);
            test::RadianceText text = someSky();
            text.encoding = kEncodings[seed % 3];
            std::string sky = test::radianceFile(text);
            const std::size_t first = random.below(2) == 0 ? 0 : sky.find("+X 32\n") + 6;
            for (std::uint64_t k = random.below(6) + 1; k > 0; --k) {
                const std::size_t at = first + random.below(sky.size() - first);
                if (const std::uint64_t kind = random.below(4); kind == 0)
                    sky.erase(at, random.below(9));
                else if (kind == 1)
                    sky.insert(at, random.below(9), static_cast<char>(random.below(256)));
                else
                    sky[at] = static_cast<char>(random.below(256));
            }
            const QString fault = QString::fromStdString(test::radianceFault(sky).value_or(""));
            QVERIFY2(fault.isEmpty(), qPrintable(QString("random seed %1: %2").arg(seed).arg(fault)));
        }
    }
};

RUBBLE_TEST_WITH(RadianceFileTest, QCoreApplication)
#include "RadianceFileTest.moc"
