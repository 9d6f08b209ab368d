#include "editor/widgets/appearance/EventAppearance.h"

#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/Icon.h"
#include "tests/support/TestProgram.h"

#include <QGuiApplication>
#include <QImage>

#include <cmath>

using namespace rubble;

namespace {

/// The ratio of the luminances of two colours, from 1 to 21.
/// Source: WCAG 2.2.
double contrast(const QColor& a, const QColor& b) {
    const auto luminance = [](const QColor& colour) {
        const auto linear = [](double value) {
            return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    };
    const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

}  // namespace

class EventAppearanceTest : public QObject {
    Q_OBJECT
private slots:
    void kindsHaveTitlesIconsAndColours() {
        QStringList titles, plurals, icons;
        QList<QRgb> colours;
        for (const EventKind kind : eventKinds()) {
            titles << titleOf(kind);
            plurals << pluralOf(kind);
            icons << iconNameOf(kind);
            colours << colourOf(kind).rgb();
            QVERIFY(!iconNamed(iconNameOf(kind)).isNull());
        }
        const auto areUnlike = [](auto list) {
            std::ranges::sort(list);
            return std::ranges::adjacent_find(list) == list.end();
        };
        QVERIFY(areUnlike(titles) && areUnlike(plurals) && areUnlike(icons) && areUnlike(colours));
    }
    /// 3:1 is what graphics need.
    void coloursDifferFromBothBackgrounds() {
        for (const EventKind kind : eventKinds()) {
            for (const QPalette& palette : {lightPalette(), darkPalette()}) {
                const double ratio = contrast(colourOf(kind), palette.color(QPalette::Window));
                QVERIFY2(ratio >= 2.5, qPrintable(titleOf(kind) + QString(" %1").arg(ratio)));
            }
        }
    }
    /// Not by colour alone.
    void iconsDifferWithoutColour() {
        QList<QImage> drawn;
        for (const EventKind kind : eventKinds()) {
            const QImage image =
                iconNamed(iconNameOf(kind)).pixmap(32, 32).toImage().convertToFormat(QImage::Format_Alpha8);
            QVERIFY(!drawn.contains(image));
            drawn << image;
        }
    }
};

RUBBLE_TEST_WITH(EventAppearanceTest, QGuiApplication)
#include "EventAppearanceTest.moc"
