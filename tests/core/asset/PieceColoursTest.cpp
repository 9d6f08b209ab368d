#include "core/asset/PieceColours.h"

#include <QTest>

using namespace rubble;

class PieceColoursTest : public QObject {
    Q_OBJECT
private slots:
    void aPieceHasOneColourAndOthersHaveOthers() {
        QVERIFY(pieceColour("3/5.17") == pieceColour("3/5.17"));
        QVERIFY(packed(pieceColour("3/5.17")) != packed(pieceColour("3/5.18")));
    }
    void piecesAreLightEnoughForDarkLines() {
        for (int seed = 0; seed < 500; ++seed) {
            const Colour colour = pieceColour("1/2." + std::to_string(seed));
            QVERIFY(0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue > 0.5);
        }
    }
    void theRampGetsLighterAndEndsWhereItEnds() {
        double last = 0.0;
        for (int step = 0; step <= 20; ++step) {
            const Colour colour = rampColour(step / 20.0);
            const double light = 0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue;
            QVERIFY(light > last);
            last = light;
        }
        QVERIFY(rampColour(-1.0) == rampColour(0.0) && rampColour(2.0) == rampColour(1.0));
    }
    void packedColoursAreRedGreenBlue() { QCOMPARE(packed({1.0, 0.5, 0.0}), 0xff8000u); }
};

QTEST_APPLESS_MAIN(PieceColoursTest)
#include "PieceColoursTest.moc"
