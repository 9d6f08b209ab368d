#include "viewport/render/ScaleBar.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

namespace {

const ScaleUnit kFeet{0.3048, "ft"}, kCentimetres{0.01, "cm"};

}  // namespace

class ScaleBarTest : public QObject {
    Q_OBJECT
private slots:
    void lengthIsRoundInItsUnit_data() {
        QTest::addColumn<double>("max");
        QTest::addColumn<bool>("isFeet");
        QTest::addColumn<QString>("text");
        QTest::newRow("metres") << 3.0 << false << "2 m";
        QTest::newRow("centimetres") << 0.7 << false << "50 cm";
        QTest::newRow("millimetres") << 0.004 << false << "2 mm";
        QTest::newRow("kilometres") << 1300.0 << false << "1 km";
        QTest::newRow("feet") << 1.6 << true << "5 ft";
        QTest::newRow("exactly five feet") << 5.0 * 0.3048 << true << "5 ft";
        QTest::newRow("tenths of a foot") << 0.1 << true << "0.2 ft";
    }
    void lengthIsRoundInItsUnit() {
        QFETCH(const double, max);
        QFETCH(const bool, isFeet);
        QFETCH(const QString, text);
        const RoundLength length = roundLength(max, isFeet ? kFeet : ScaleUnit{});
        QCOMPARE(QString::fromStdString(length.text), text);
        QVERIFY(length.metres <= max * (1.0 + 1e-9) && length.metres > 0.39 * max);
    }
    void unitOfTheProgramIsKept() {
        QCOMPARE(QString::fromStdString(roundLength(3.0, kCentimetres).text), QString("200 cm"));
    }
};

RUBBLE_TEST(ScaleBarTest)
#include "ScaleBarTest.moc"
