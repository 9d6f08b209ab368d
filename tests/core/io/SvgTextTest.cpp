#include "core/io/SvgText.h"

#include <QTest>

using namespace rubble;

namespace {

std::string written(double value) {
    SvgText svg;
    svg << value;
    return std::move(svg).text();
}

}  // namespace

class SvgTextTest : public QObject {
    Q_OBJECT
private slots:
    void numbersAreRoundedToHundredths() {
        QCOMPARE(written(1.0), std::string("1"));
        QCOMPARE(written(0.125), std::string("0.13"));
        QCOMPARE(written(-12.3456), std::string("-12.35"));
        QCOMPARE(written(1e6 / 3.0), std::string("333333.33"));
    }
    void nothingIsLeftOfNumbersThatRoundToZero() {
        QCOMPARE(written(0.001), std::string("0"));
        QCOMPARE(written(-0.001), std::string("0"));
    }
    void piecesStandInOrder() {
        SvgText svg;
        svg << 'M' << Vec2(1.5, -2.0) << "h" << 3.0 << 'Z';
        QCOMPARE(std::move(svg).text(), std::string("M1.5 -2h3Z"));
    }
    void whatXmlReservesIsEscaped() {
        QCOMPARE(escapedXml("a<b> & \"c\""), std::string("a&lt;b&gt; &amp; &quot;c&quot;"));
        QCOMPARE(escapedXml("Gl\xc3\xa4ser"), std::string("Gl\xc3\xa4ser"));
    }
    void controlCharactersBecomeSpaces() {
        QCOMPARE(escapedXml(std::string_view("a\0b\nc\x1f", 6)), std::string("a b c "));
    }
};

QTEST_APPLESS_MAIN(SvgTextTest)
#include "SvgTextTest.moc"
