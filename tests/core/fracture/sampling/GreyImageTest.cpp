#include "core/fracture/sampling/GreyImage.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <numeric>

using namespace rubble;

class GreyImageTest : public QObject {
    Q_OBJECT
private slots:
    void smallImagesStay() {
        const GreyImage image{.width = 2, .height = 1, .grey = {3, 4}, .opacity = {0, 9}};
        QCOMPARE(reduced(image, 2), image);
    }
    void pixelsAreMeansOfAreas() {
        // 3 pixels become 2: each takes one and a half.
        const GreyImage row{.width = 3, .height = 1, .grey = {0, 90, 30}};
        QCOMPARE(reduced(row, 2), (GreyImage{.width = 2, .height = 1, .grey = {30, 50}}));
        const GreyImage square{.width = 4, .height = 2, .bits = 16, .grey = {0, 4, 8, 8, 4, 8, 65535, 8}};
        QCOMPARE(reduced(square, 2), (GreyImage{.width = 2, .height = 1, .bits = 16, .grey = {4, 16390}}));
    }
    void greyIsWeightedByOpacity() {
        const GreyImage image{.width = 4, .height = 1, .grey = {200, 100, 7, 7}, .opacity = {255, 0, 0, 0}};
        QCOMPARE(reduced(image, 2), (GreyImage{.width = 2, .height = 1, .grey = {200, 0}, .opacity = {128, 0}}));
    }
    void meanDensityStays() {
        GreyImage image{.width = 1537, .height = 31};
        for (std::uint32_t k = 0; k < image.width * image.height; ++k) {
            image.grey.push_back(static_cast<std::uint16_t>(k * 7919 % 256));
            image.opacity.push_back(static_cast<std::uint16_t>(k * 104729 % 256));
        }
        const auto density = [](const GreyImage& of) {
            double sum = 0.0;
            for (std::size_t k = 0; k < of.grey.size(); ++k) sum += of.grey[k] / 255.0 * of.opacity[k] / 255.0;
            return sum / static_cast<double>(of.grey.size());
        };
        const GreyImage small = reduced(image);
        QCOMPARE(small.width, 1024u);
        QCOMPARE(small.height, 20u);
        QVERIFY(!verifyGreyImage(small));
        QVERIFY(std::abs(density(small) - density(image)) < 0.002);  // of rounding to 8 bits
    }
    void thinImagesKeepAPixel() {
        const GreyImage line{.width = 3000, .height = 1, .grey = std::vector<std::uint16_t>(3000, 17)};
        const GreyImage small = reduced(line);
        QVERIFY(small.width == 1024 && small.height == 1);
        QVERIFY(std::ranges::all_of(small.grey, [](auto grey) { return grey == 17; }));
    }
};

RUBBLE_TEST(GreyImageTest)
#include "GreyImageTest.moc"
