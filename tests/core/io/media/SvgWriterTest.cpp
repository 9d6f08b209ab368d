#include "core/io/media/SvgWriter.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

std::string written(double value) {
    SvgWriter svg;
    svg << value;
    return std::move(svg).text();
}

}  // namespace

class SvgWriterTest : public QObject {
    Q_OBJECT
private slots:
    void numbersAreRoundedToHundredths() {
        QCOMPARE(written(1.0), std::string("1"));
        QCOMPARE(written(0.125), std::string("0.13"));
        QCOMPARE(written(-12.3456), std::string("-12.35"));
        QCOMPARE(written(1e6 / 3.0), std::string("333333.33"));
    }
    void numbersThatRoundToZeroHaveNoSign() {
        QCOMPARE(written(0.001), std::string("0"));
        QCOMPARE(written(-0.001), std::string("0"));
    }
    void outputKeepsTheOrder() {
        SvgWriter svg;
        svg << 'M' << Vec2(1.5, -2.0) << "h" << 3.0 << 'Z';
        QCOMPARE(std::move(svg).text(), std::string("M1.5 -2h3Z"));
    }
};

RUBBLE_TEST(SvgWriterTest)
#include "SvgWriterTest.moc"
