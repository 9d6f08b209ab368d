#include "editor/play/PlayEngine.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/play/MortarPortal.h"

#include <QSignalSpy>

using namespace rubble;

/// More of it is tested through its controller: see PlayControllerTest.
class PlayEngineTest : public QObject {
    Q_OBJECT
private slots:
    void mortarThatHoldsNothingIsTold_data() {
        QTest::addColumn<bool>("isAnchored");
        QTest::newRow("anchored") << true;
        QTest::newRow("not anchored") << false;
    }
    void mortarThatHoldsNothingIsTold() {
        QFETCH(const bool, isAnchored);
        Project project = test::mortarPortal();
        if (!isAnchored) {
            for (Instance& instance : project.instances) instance.isAnchored = false;
        }
        test::Stage stage(project);
        const QSignalSpy messages(&stage.controller, &PlayController::statusMessage);
        stage.start();
        stage.advance(1);
        QCOMPARE(messages.size(), isAnchored ? 0 : 1);
        if (!isAnchored) QVERIFY(messages[0][0].toString().contains("joints"));
    }
};

RUBBLE_TEST_WITH(PlayEngineTest, QCoreApplication)
#include "PlayEngineTest.moc"
