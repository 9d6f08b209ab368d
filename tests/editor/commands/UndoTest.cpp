// Tests editor/commands and editor/document/Document.cpp with random edits.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Document.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomEdits.h"

#include <QTest>

using namespace rubble;

/// Random edits can be undone and redone exactly.
class UndoTest : public QObject {
    Q_OBJECT
private slots:
    void undoingEverythingGivesTheSavedBytes_data() {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("a wall") << false;
        QTest::newRow("everything in it") << true;
    }
    void undoingEverythingGivesTheSavedBytes() {
        QFETCH(bool, isFull);
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            Document document(isFull ? fullProject() : starterProject());
            const std::string before = projectText(document.project());
            Random random(seed);
            quint64 mergeKey = 0;
            for (int step = 0; step < 40; ++step) {
                if (random.below(3) == 0) mergeKey = document.newMergeKey();
                document.push(randomEdit(document.project(), random, mergeKey));
                if (random.below(8) == 0) document.undoStack().undo();
                const std::optional<std::string> fault = verifyProject(document.project());
                QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            }
            const std::string after = projectText(document.project());
            const int steps = document.undoStack().index();
            while (document.undoStack().canUndo()) document.undoStack().undo();
            QVERIFY2(projectText(document.project()) == before, qPrintable(QString("seed %1").arg(seed)));
            document.undoStack().setIndex(steps);
            QVERIFY2(projectText(document.project()) == after, qPrintable(QString("seed %1").arg(seed)));
        }
    }
};

RUBBLE_TEST_WITH(UndoTest, QCoreApplication)
#include "UndoTest.moc"
