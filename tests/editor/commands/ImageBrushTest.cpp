#include "editor/commands/ImageBrush.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

const Box2 kBox{{0.0, 0.0}, {2.0, 1.0}};

std::uint16_t greyAt(const GreyImage& picture, std::uint32_t column, std::uint32_t row) {
    return picture.grey[std::size_t{row} * picture.width + column];
}

}  // namespace

class ImageBrushTest : public QObject {
    Q_OBJECT
private slots:
    void pixelsAreSquares() {
        const GreyImage picture = uniformImage(kBox, 1.0, 64);
        QCOMPARE(picture.width, 64u);
        QCOMPARE(picture.height, 32u);
        QVERIFY(std::ranges::count(picture.grey, 255) == 64 * 32);
        QVERIFY(!verifyGreyImage(picture));
    }
    void dabIsOpaqueAtItsCentreAndEndsAtItsRadius() {
        const GreyImage picture = painted(uniformImage(kBox, 1.0, 200), kBox, {1.0, 0.5}, {1.0, 0.5},
                                          {.radius = 0.2, .strength = 1.0, .value = 0.0});
        QCOMPARE(greyAt(picture, 100, 50), std::uint16_t{0});
        QCOMPARE(greyAt(picture, 92, 50), std::uint16_t{0});  // 8 cm from the centre: in the inner half
        QVERIFY(greyAt(picture, 85, 50) > 0 && greyAt(picture, 85, 50) < 255);
        QCOMPARE(greyAt(picture, 79, 50), std::uint16_t{255});  // 21 cm from the centre
    }
    void rowsRunFromTheTop() {
        const GreyImage picture = painted(uniformImage(kBox, 1.0, 200), kBox, {1.0, 0.9}, {1.0, 0.9},
                                          {.radius = 0.05, .strength = 1.0, .value = 0.0});
        QCOMPARE(greyAt(picture, 100, 10), std::uint16_t{0});
        QCOMPARE(greyAt(picture, 100, 90), std::uint16_t{255});
    }
    void faintBrushReachesItsValue() {
        GreyImage picture = uniformImage(kBox, 0.0, 50);
        for (int k = 0; k < 300; ++k)
            picture = painted(std::move(picture), kBox, {1.0, 0.5}, {1.0, 0.5},
                              {.radius = 0.3, .strength = 0.05, .value = 1.0});
        QCOMPARE(greyAt(picture, 25, 12), std::uint16_t{255});
    }
    void lineHasNoGaps() {
        const GreyImage picture = painted(uniformImage(kBox, 1.0, 200), kBox, {0.1, 0.5}, {1.9, 0.5},
                                          {.radius = 0.05, .strength = 1.0, .value = 0.0});
        for (std::uint32_t column = 12; column < 188; ++column) QVERIFY(greyAt(picture, column, 50) < 40);
    }
    void paintedPixelsBecomeOpaque() {
        GreyImage picture = uniformImage(kBox, 1.0, 20);
        picture.opacity.assign(picture.grey.size(), 0);
        picture =
            painted(std::move(picture), kBox, {1.0, 0.5}, {1.0, 0.5}, {.radius = 0.4, .strength = 1.0, .value = 0.0});
        QCOMPARE(picture.opacity[5 * 20 + 10], std::uint16_t{255});
        QCOMPARE(picture.opacity[0], std::uint16_t{0});
    }
    void paintingOutsideDoesNothing() {
        const GreyImage before = uniformImage(kBox, 1.0, 20);
        QVERIFY(painted(before, kBox, {9.0, 9.0}, {-9.0, 9.0}, {.radius = 0.4}) == before);
    }
};

RUBBLE_TEST(ImageBrushTest)
#include "ImageBrushTest.moc"
