#include "tests/support/TestProgram.h"
#include "viewport/video/ContactSheetPage.h"

#include <QTest>

namespace rubble {
namespace {

constexpr int kGap = 8;  // pixels, as on the page

/// An image of one grey.
Image grey(std::uint8_t value) { return {40, 30, std::vector<std::uint8_t>(3 * 40 * 30, value)}; }

std::uint8_t at(const Image& page, int x, int y) {
    return page.pixels[3 * static_cast<std::size_t>(y * page.width + x)];
}

}  // namespace

class ContactSheetPageTest : public QObject {
    Q_OBJECT

private slots:
    void imagesFormAGrid() {
        const Image page = contactSheetPage({{0, grey(10)}, {1, grey(20)}, {2, grey(30)}}, Theme::Light);
        QCOMPARE(page.width, 2 * 40 + 3 * kGap);
        QCOMPARE(page.height, 2 * 30 + 3 * kGap);
        QCOMPARE(at(page, kGap + 39, kGap + 29), std::uint8_t{10});
        QCOMPARE(at(page, 2 * kGap + 40 + 39, kGap + 29), std::uint8_t{20});
        QCOMPARE(at(page, kGap + 39, 2 * kGap + 30 + 29), std::uint8_t{30});
        QCOMPARE(at(page, 2 * kGap + 40 + 39, 2 * kGap + 30 + 29), at(page, 0, 0));  // background
    }
    void numberIsDrawnInDigits() {
        const Image page = contactSheetPage({{1, grey(128)}}, Theme::Light);
        const auto isInk = [&](int column, int row) {
            return at(page, kGap + 3 * (1 + column), kGap + 3 * (1 + row)) < 60;
        };
        const char* one[] = {".#.", "##.", ".#.", ".#.", "###"};
        for (int row = 0; row < 5; ++row) {
            for (int column = 0; column < 3; ++column) QCOMPARE(isInk(column, row), one[row][column] == '#');
        }
        QCOMPARE(at(page, kGap + 39, kGap + 29), std::uint8_t{128});
    }
    void missingImageLeavesANumberedCell() {
        const Image page = contactSheetPage({{0, std::nullopt}, {1, grey(20)}}, Theme::Dark);
        QCOMPARE(page.width, 2 * 40 + 3 * kGap);
        QCOMPARE(at(page, 2 * kGap + 40 + 39, kGap + 29), std::uint8_t{20});
        QCOMPARE(at(page, kGap + 39, kGap + 29), at(page, 0, 0));
    }
};

RUBBLE_TEST(ContactSheetPageTest)

}  // namespace rubble

#include "ContactSheetPageTest.moc"
