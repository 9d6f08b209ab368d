// Tests how PlayThread shows steps; others test it by the controller.
#include "editor/play/PlayThread.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class PlayThreadTest : public QObject {
    Q_OBJECT
private slots:
    void slowStepsAreShownAsSlowly() {
        QCOMPARE(shownDuration(0.001, 1.0 / 60.0), 1.0 / 60.0);
        QCOMPARE(shownDuration(0.2, 1.0 / 60.0), 0.2);
        QCOMPARE(shownDuration(7.0, 1.0 / 60.0), 1.0);
        QCOMPARE(shownDuration(0.2, 2.0), 2.0);  // in slow motion
    }
};

RUBBLE_TEST(PlayThreadTest)
#include "PlayThreadTest.moc"
