#include "editor/widgets/ColourConversion.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class ColourConversionTest : public QObject {
    Q_OBJECT
private slots:
    void coloursAreThoseOfThe3dView() {
        const Colour colour{0.1, 0.3, 0.9};
        QCOMPARE(toQColor(colour).rgb() & 0xffffffu, packed(colour));
    }
    void coloursOfEightBitsAreKept() {
        for (int byte = 0; byte <= 255; ++byte) {
            const QColor colour(byte, 255 - byte, byte / 2);
            QCOMPARE(toQColor(fromQColor(colour)), colour);
        }
    }
};

RUBBLE_TEST(ColourConversionTest)
#include "ColourConversionTest.moc"
