// Tests core/fracture/kinds/DensityImage.cpp and core/fracture/sampling/DensityArea.cpp.
#include "core/base/Random.h"
#include "core/fracture/pattern/Pattern.h"
#include "tests/support/ChiSquare.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr std::uint32_t kSide = 8;

/// Random greys and opacities, some of them black or all transparent.
std::shared_ptr<GreyImage> randomImage(std::uint32_t bits, std::uint64_t randomSeed) {
    auto image = std::make_shared<GreyImage>(GreyImage{.width = kSide, .height = kSide, .bits = bits});
    Random random(randomSeed);
    for (std::uint32_t pixel = 0; pixel < kSide * kSide; ++pixel) {
        const auto value = [&] { return static_cast<std::uint16_t>(random.below(image->white() + 1u)); };
        image->grey.push_back(pixel % 7 == 0 ? std::uint16_t{0} : value());
        image->opacity.push_back(pixel % 11 == 0 ? std::uint16_t{0} : value());
    }
    return image;
}

Seeds seedsOfImage(const DensityImage& layer, const Polygon& outline) { return layerSeeds(layer, outline, 3).value(); }

std::string imageFault(const GreyImage& image) {
    const DensityImage layer{.image = std::make_shared<GreyImage>(image)};
    return verifyPattern({{{.id = 1, .parameters = layer}}}).value_or("");
}

}  // namespace

class DensityImageTest : public QObject {
    Q_OBJECT
private slots:
    void seedDensityMatchesTheImage_data() {
        QTest::addColumn<int>("bits");
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<bool>("isRing");
        for (const int bits : {8, 16}) {
            QTest::addRow("bright, %d bits", bits) << bits << false << false;
            QTest::addRow("dark, %d bits", bits) << bits << true << false;
            QTest::addRow("with a hole, %d bits", bits) << bits << false << true;
        }
    }
    void seedDensityMatchesTheImage() {
        QFETCH(int, bits);
        QFETCH(bool, isDark);
        QFETCH(bool, isRing);
        // Pixels of half a metre: the hole of the ring covers whole pixels.
        const Polygon outline = isRing ? squareRing() : Polygon{rectangle({0.0, 0.0}, {4.0, 4.0}), {}};
        const auto image = randomImage(static_cast<std::uint32_t>(bits), 21);
        constexpr double kCount = 50'000.0;
        const Seeds seeds = seedsOfImage(
            {.count = 50'000, .dense = isDark ? DenseWhere::Dark : DenseWhere::Bright, .image = image}, outline);
        std::vector<double> seen(kSide * kSide, 0.0), expected(kSide * kSide, 0.0);
        for (const Vec2 seed : seeds.positions) {
            const auto column = static_cast<std::uint32_t>(seed.x * 2.0),
                       row = static_cast<std::uint32_t>(8.0 - seed.y * 2.0);
            seen[row * kSide + column] += 1.0;
        }
        double sum = 0.0;
        for (std::uint32_t row = 0; row < kSide; ++row) {
            for (std::uint32_t column = 0; column < kSide; ++column) {
                const std::uint32_t pixel = row * kSide + column;
                const bool isHole = isRing && row >= 2 && row < 6 && column >= 2 && column < 6;
                const double grey = image->grey[pixel], white = image->white();
                expected[pixel] = isHole ? 0.0 : (isDark ? white - grey : grey) * image->opacity[pixel];
                sum += expected[pixel];
            }
        }
        for (double& each : expected) each *= kCount / sum;
        const double ratio = chiSquareByLimit(seen, expected);
        QVERIFY2(ratio < 1.0, qPrintable(QString::number(ratio)));
    }
    void seedsAreUniformInClippedPixels() {
        // One pixel over a triangle: equally many seeds in each of its quarters.
        const Polygon triangle{{{0.0, 0.0}, {2.0, 0.0}, {0.0, 2.0}}, {}};
        const auto white = std::make_shared<GreyImage>(GreyImage{.width = 1, .height = 1, .grey = {255}});
        std::vector<double> seen(4, 0.0);
        for (const Vec2 seed :
             seedsOfImage({.count = 8000, .dense = DenseWhere::Bright, .image = white}, triangle).positions) {
            QVERIFY(containment(triangle, seed) != Containment::Outside);
            seen[seed.x > 1.0 ? 0 : seed.y > 1.0 ? 1 : seed.x + seed.y > 1.0 ? 2 : 3] += 1.0;
        }
        for (const double count : seen) QVERIFY(std::abs(count - 2000.0) < 200.0);  // five standard deviations
    }
    void greaterCountKeepsEarlierSeeds() {
        const auto image = randomImage(8, 5);
        const Seeds few = seedsOfImage({.count = 50, .image = image}, lShape());
        Seeds many = seedsOfImage({.count = 80, .image = image}, lShape());
        many.positions.resize(50);
        QCOMPARE(many.positions, few.positions);
    }
    void noImageGivesNoSeeds() {
        const Seeds seeds = seedsOfImage({.count = 50}, unitSquare());
        QVERIFY(seeds.positions.empty() && seeds.diagnostics.empty());
    }
    void imagesWithoutDensityAreReported() {
        const auto white = std::make_shared<GreyImage>(GreyImage{.width = 1, .height = 1, .grey = {255}});
        const Seeds seeds = seedsOfImage({.count = 50, .dense = DenseWhere::Dark, .image = white}, unitSquare());
        QVERIFY(seeds.positions.empty());
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::NoRoom);
        QCOMPARE(seeds.diagnostics[0].message,
                 std::string("Layer 1 found room for 0 of 50 seeds: its image is white or transparent "
                             "everywhere in the outline."));
    }
    void invalidImagesAreRejected() {
        const GreyImage good{.width = 2, .height = 1, .grey = {0, 255}};
        QCOMPARE(imageFault(good), std::string());
        GreyImage image = good;
        image.width = 3;
        QCOMPARE(imageFault(image), std::string("Layer 1: the image has 2 values for 3 x 1 pixels."));
        image.width = 1025;
        QCOMPARE(imageFault(image),
                 std::string("Layer 1: the image has 1025 x 1 pixels, but from 1 to 1024 a side are allowed."));
        image = good;
        image.bits = 12;
        QCOMPARE(imageFault(image), std::string("Layer 1: the image has 12 bits per pixel, but must have 8 or 16."));
        image = good;
        image.grey[0] = 256;
        QCOMPARE(imageFault(image), std::string("Layer 1: the image has a value of 256, but 255 is white."));
        image = good;
        image.opacity = {255};
        QCOMPARE(imageFault(image), std::string("Layer 1: the image has 1 values for 2 x 1 pixels."));
    }
};

RUBBLE_TEST(DensityImageTest)
#include "DensityImageTest.moc"
