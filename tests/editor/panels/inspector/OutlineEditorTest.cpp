// Tests editor/panels/inspector/OutlineEditor.cpp, editor/panels/inspector/NumberTable.cpp and
// editor/panels/models/OutlineModel.cpp.
#include "editor/panels/inspector/OutlineEditor.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QTableView>

using namespace rubble;
using test::InspectorDesk;

class OutlineEditorTest : public QObject {
    Q_OBJECT
private slots:
    void typedPointsAreValidated() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<OutlineEditor*>();
        const QModelIndex cell = editor.model().index(2, 0);
        editor.view().setCurrentIndex(cell);
        editor.view().edit(cell);
        auto* field = editor.view().viewport()->findChild<NumberField*>();
        QVERIFY(field);
        field->selectAll();
        QTest::keyClicks(field, "1.25");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(desk.asset().prism().outline.outer[2].x, 1.25);
        QVERIFY(!editor.model().setData(editor.model().index(2, 1), -5.0, Qt::EditRole));
        QCOMPARE(desk.refusals.count(), 1);
        QVERIFY2(desk.refusals[0][0].toString().contains("outline"), qPrintable(desk.refusals[0][0].toString()));
        editor.model().insertAfter(0);
        QCOMPARE(desk.asset().prism().outline.outer.size(), 5u);
        QVERIFY(editor.model().addHole());
        QCOMPARE(desk.asset().prism().outline.holes.size(), 1u);
        editor.model().removePoints({0, 1, 2});
        QCOMPARE(desk.refusals.last()[0], "An outline needs at least three points. Delete fewer.");
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(OutlineEditorTest, QApplication)
#include "OutlineEditorTest.moc"
