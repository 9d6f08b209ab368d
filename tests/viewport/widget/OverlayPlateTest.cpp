// Tests viewport/widget/OverlayPlate.cpp.
#include "viewport/widget/OverlayPlate.h"

#include "tests/support/TestProgram.h"

#include <QImage>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace rubble;

namespace {

/// Source: WCAG 2.1, relative luminance and contrast ratio.
double luminanceOf(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrastOf(const QColor& a, const QColor& b) {
    const double first = luminanceOf(a), second = luminanceOf(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// What a colour gives over another.
QColor over(const QColor& colour, const QColor& below) {
    QImage image(1, 1, QImage::Format_RGB32);
    image.fill(below);
    QPainter(&image).fillRect(0, 0, 1, 1, colour);
    return image.pixelColor(0, 0);
}

const std::array kBackgrounds{QColor(Qt::white), QColor(Qt::black), QColor(128, 128, 128), QColor(207, 224, 240),
                              QColor(240, 180, 120)};
constexpr double kReadable = 4.5;

}  // namespace

class OverlayPlateTest : public QObject {
    Q_OBJECT
private slots:
    void textIsReadableOverAnyBackground() {
        for (const QColor& background : kBackgrounds) {
            const QColor plate = over(kPlateColour, background);
            for (const QColor& text : {kPlateText, kPlateSecondaryText}) {
                const double contrast = contrastOf(over(text, plate), plate);
                QVERIFY2(contrast >= kReadable, qPrintable(QString::number(contrast)));
            }
            for (const Theme theme : {Theme::Light, Theme::Dark}) {
                const auto& [ink, halo] = overlayInk(theme);
                const double contrast = contrastOf(ink, over(halo, background));
                QVERIFY2(contrast >= kReadable, qPrintable(QString::number(contrast)));
            }
        }
    }
    void plateFillsItsRectangle() {
        QImage image(60, 40, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        const QRect inside = paintPlate(painter, {10, 5, 40, 30});
        QVERIFY(QRect(10, 5, 40, 30).contains(inside) && inside.width() == 40 - 2 * kPlatePadding);
        QCOMPARE(image.pixelColor(30, 20), over(kPlateColour, Qt::white));
        QCOMPARE(image.pixelColor(5, 20), QColor(Qt::white));
    }
};

RUBBLE_TEST(OverlayPlateTest)
#include "OverlayPlateTest.moc"
