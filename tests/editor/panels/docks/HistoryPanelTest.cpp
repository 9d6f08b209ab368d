#include "editor/panels/docks/HistoryPanel.h"

#include "core/asset/library/StarterProject.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/Document.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QApplication>

using namespace rubble;

class HistoryPanelTest : public QObject {
    Q_OBJECT
private slots:
    void clickGoesToAStep() {
        Document document(boxProject(UniformScatter{.count = 4}));
        HistoryPanel panel(document.undoStack());
        for (const double depth : {0.5, 0.75}) {
            Asset asset = document.project().assets[0];
            asset.prism().depth = depth + 1.0;
            QVERIFY(document.push(modify("Set Depth", asset)));
        }
        QCOMPARE(panel.model()->rowCount(), 3);
        QCOMPARE(panel.model()->index(0, 0).data().toString(), "Initial State");
        QCOMPARE(panel.model()->index(2, 0).data().toString(), "Set Depth");
        panel.setCurrentIndex(panel.model()->index(1, 0));
        QCOMPARE(document.project().assets[0].prism().depth, 1.5);
        QVERIFY(!panel.cleanIcon().isNull());
    }
    /// A restored backup is in no file yet.
    void onlyASavedStateIsMarked() {
        Document document(emptyProject());
        document.replaceUnsaved(boxProject(UniformScatter{.count = 4}));
        HistoryPanel panel(document.undoStack());
        const auto isMarked = [&] { return panel.model()->index(0, 0).data(Qt::DecorationRole).isValid(); };
        QVERIFY(document.isModified() && !isMarked());
        document.setSaved();
        QVERIFY(!document.isModified() && isMarked());
        document.setUnsaved();
        QVERIFY(document.isModified() && !isMarked());
        document.replace(emptyProject());
        QVERIFY(!document.isModified() && isMarked());
    }
};

RUBBLE_TEST_WITH(HistoryPanelTest, QApplication)
#include "HistoryPanelTest.moc"
