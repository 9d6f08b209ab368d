#include "editor/widgets/ColourScheme.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>
#include <QTest>

#include <cmath>
#include <memory>

using namespace rubble;

namespace {

/// Source: WCAG 2.1, relative luminance and contrast ratio.
double luminance(const QColor& colour) {
    const auto linear = [](double value) {
        return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QPalette& palette, QPalette::ColorRole one, QPalette::ColorRole other) {
    const double a = luminance(palette.color(one)), b = luminance(palette.color(other));
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QPalette highContrast() {
    QPalette palette(Qt::black);
    palette.setColor(QPalette::WindowText, Qt::yellow);
    return palette;
}

}  // namespace

class ColourSchemeTest : public QObject {
    Q_OBJECT
private slots:
    void textsAreReadable() {
        for (const QPalette& palette : {lightPalette(), darkPalette()}) {
            QVERIFY(contrast(palette, QPalette::HighlightedText, QPalette::Highlight) >= 4.5);
            for (const QPalette::ColorRole behind : {QPalette::Base, QPalette::Window, QPalette::AlternateBase}) {
                QVERIFY(contrast(palette, QPalette::Link, behind) >= 4.5);
                QVERIFY(contrast(palette, QPalette::Text, behind) >= 4.5);
            }
        }
    }
    void paletteOfTheDesktopIsKept() {
        const QPalette ofStyle = std::unique_ptr<QStyle>(QStyleFactory::create("Fusion"))->standardPalette();
        QCOMPARE(paletteOf(ColourScheme::System, highContrast(), ofStyle), QPalette());
        QCOMPARE(paletteOf(ColourScheme::System, ofStyle, ofStyle), lightPalette());
        QCOMPARE(paletteOf(ColourScheme::Dark, highContrast(), ofStyle), darkPalette());
        QCOMPARE(paletteOf(ColourScheme::Light, highContrast(), ofStyle), lightPalette());
    }
    /// The platform of the tests has no palette of its own.
    void schemesCanBeChanged() {
        applyTheme(ColourScheme::Dark);
        QVERIFY(isDark(QApplication::palette()));
        applyTheme(ColourScheme::System);
        QCOMPARE(QApplication::palette().color(QPalette::Window), lightPalette().color(QPalette::Window));
    }
};

RUBBLE_TEST_WITH(ColourSchemeTest, QApplication)
#include "ColourSchemeTest.moc"
