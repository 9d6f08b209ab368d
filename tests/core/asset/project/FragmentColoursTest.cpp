#include "core/asset/project/FragmentColours.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class FragmentColoursTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentColourDependsOnTheId() {
        QVERIFY(fragmentColour("3/5.17") == fragmentColour("3/5.17"));
        QVERIFY(packed(fragmentColour("3/5.17")) != packed(fragmentColour("3/5.18")));
    }
    void fragmentColoursContrastWithDarkLines() {
        for (int seed = 0; seed < 500; ++seed) {
            const Colour colour = fragmentColour("1/2." + std::to_string(seed));
            QVERIFY(0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue > 0.5);
        }
    }
    void rampGetsLighterAndIsClamped() {
        double last = 0.0;
        for (int step = 0; step <= 20; ++step) {
            const Colour colour = rampColour(step / 20.0);
            const double light = 0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue;
            QVERIFY(light > last);
            last = light;
        }
        QVERIFY(rampColour(-1.0) == rampColour(0.0) && rampColour(2.0) == rampColour(1.0));
    }
    void packedColourIsRedGreenBlue() { QCOMPARE(packed({1.0, 0.5, 0.0}), 0xff8000u); }
};

RUBBLE_TEST(FragmentColoursTest)
#include "FragmentColoursTest.moc"
