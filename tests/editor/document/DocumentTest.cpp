#include "core/asset/library/StarterProject.h"
#include "editor/document/Document.h"
#include "tests/support/TestProgram.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// Gives the first asset another threshold.
Edit thresholdEdit(const Document& document, double threshold, quint64 mergeKey = 0) {
    Asset asset = document.project().assets[0];
    asset.threshold = threshold;
    const Id id = asset.id;
    return {.text = "Set Threshold", .replacements = {Replacement<Asset>{id, std::move(asset)}}, .mergeKey = mergeKey};
}

double threshold(const Document& document) { return document.project().assets[0].threshold; }

}  // namespace

class DocumentTest : public QObject {
    Q_OBJECT
private slots:
    void editIsOneStepWithChanges() {
        Document document(starterProject());
        const Id asset = document.project().assets[0].id;
        QList<Changes> reported;
        connect(&document, &Document::changed, this, [&](const Changes& changes) { reported.append(changes); });
        document.push(thresholdEdit(document, 7.0));
        QCOMPARE(threshold(document), 7.0);
        QCOMPARE(document.undoStack().undoText(), "Set Threshold");
        document.undoStack().undo();
        QCOMPARE(threshold(document), 100.0);
        document.undoStack().redo();
        QCOMPARE(threshold(document), 7.0);
        QCOMPARE(reported.size(), 3);
        for (const Changes& changes : reported) {
            QVERIFY((changes.list == std::vector{Change{Part::Asset, asset, ChangeKind::Modified}}));
            QVERIFY(changes.touches(Part::Asset, asset) && !changes.touches(Part::Material));
        }
    }
    void destructionReportsNoChange() {
        int reports = 0;
        {
            Document document(starterProject());
            document.push(thresholdEdit(document, 7.0));
            connect(&document, &Document::changed, this, [&] { ++reports; });
            connect(&document, &Document::modifiedChanged, this, [&] { ++reports; });
        }
        QCOMPARE(reports, 0);
    }
    void editWithoutChangeAddsNoStep() {
        Document document(starterProject());
        document.push(thresholdEdit(document, 100.0));
        document.push({});
        QVERIFY(!document.undoStack().canUndo() && !document.isModified());
    }
    void editsWithTheSameKeyMerge() {
        Document document(starterProject());
        const quint64 mergeKey = document.newMergeKey();
        for (const double value : {1.0, 2.0, 3.0}) document.push(thresholdEdit(document, value, mergeKey));
        document.push(thresholdEdit(document, 4.0, document.newMergeKey()));
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QCOMPARE(threshold(document), 3.0);
        document.undoStack().undo();
        QCOMPARE(threshold(document), 100.0);
    }
    void mergedEditsThatCancelLeaveNoStep() {
        Document document(starterProject());
        const quint64 mergeKey = document.newMergeKey();
        for (const double value : {1.0, 100.0}) document.push(thresholdEdit(document, value, mergeKey));
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
    }
    /// As by a field that loses the focus, with a value typed into it, because an undo hides it.
    void nothingIsPushedWhileAChangeIsNotified() {
        Document document(starterProject());
        document.push(thresholdEdit(document, 7.0));
        document.push(thresholdEdit(document, 8.0));
        bool isPushed = true;
        connect(&document, &Document::changed, this, [&] { isPushed = document.push(thresholdEdit(document, 9.0)); });
        document.undoStack().undo();
        QVERIFY(!isPushed);
        QCOMPARE(threshold(document), 7.0);
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().redo();
        QCOMPARE(threshold(document), 8.0);
        document.push(thresholdEdit(document, 10.0));
        QCOMPARE(threshold(document), 10.0);
        document.undoStack().undo();
        QCOMPARE(threshold(document), 8.0);
        document.replace(starterProject());
        QCOMPARE(document.undoStack().count(), 0);
    }
    void sceneSettingsAreSetAndUndone() {
        Document document(starterProject());
        const Project before = document.project();
        Project after = before;
        after.ground.height = 0.5;
        after.gravity.y = -3.7;
        after.damage.rule = DamageRule::Momentum;
        after.debris.lifetime = 8.0;
        document.push({.text = "Set scene", .replacements = {sceneSettings(after)}});
        QVERIFY(document.project() == after);
        document.undoStack().undo();
        QVERIFY(document.project() == before);
    }
    void isModifiedUntilSavedOrUndone() {
        Document document(starterProject());
        QSignalSpy spy(&document, &Document::modifiedChanged);
        document.push(thresholdEdit(document, 7.0));
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(!document.isModified());
        document.undoStack().redo();
        document.setSaved();
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        QVERIFY(document.isModified());
        QCOMPARE(spy.count(), 5);
    }
    void editsDoNotMergeAcrossASave() {
        Document document(starterProject());
        const quint64 mergeKey = document.newMergeKey();
        document.push(thresholdEdit(document, 1.0, mergeKey));
        document.setSaved();
        document.push(thresholdEdit(document, 2.0, mergeKey));
        document.undoStack().undo();
        QCOMPARE(threshold(document), 1.0);
        QVERIFY(!document.isModified());
    }
    void replacingClearsTheUndoStack() {
        Document document(starterProject());
        document.push(thresholdEdit(document, 7.0));
        bool isEverything = false;
        connect(&document, &Document::changed, this,
                [&](const Changes& changes) { isEverything = changes.isEverything; });
        document.replace(emptyProject());
        QVERIFY(isEverything && !document.isModified() && !document.undoStack().canUndo());
        document.setUnsaved();
        QVERIFY(document.isModified());
    }
};

RUBBLE_TEST_WITH(DocumentTest, QCoreApplication)
#include "DocumentTest.moc"
