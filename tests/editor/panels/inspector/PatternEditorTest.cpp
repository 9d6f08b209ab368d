// Tests editor/panels/inspector/PatternEditor.cpp and editor/panels/models/LayerModel.cpp.
#include "editor/panels/inspector/PatternEditor.h"

#include "core/asset/checks/VerifyProject.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QListView>
#include <QToolButton>

using namespace rubble;
using test::InspectorDesk;

class PatternEditorTest : public QObject {
    Q_OBJECT
private slots:
    void layersAreAddedMovedDisabledAndDeleted() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.addLayer(LloydRelaxation{});
        QCOMPARE(desk.asset(3).pattern.layers.size(), 5u);
        const Id added = desk.asset(3).pattern.layers.back().id;
        QTest::mouseClick(&desk.control<QToolButton>("Move Up"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).pattern.layers[3].id, added);
        const QRect row = editor.view().visualRect(editor.view().currentIndex());
        editor.view().setFocus();
        QTest::keyClick(&editor.view(), Qt::Key_Space);
        QVERIFY2(!desk.asset(3).pattern.layers[3].isOn, qPrintable(QString::number(row.height())));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Layer"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).pattern.layers.size(), 4u);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void aLayerThatTheMenuAddsBecomesCurrent() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        const QListView& view = desk.inspector.page().findChild<PatternEditor*>()->view();
        desk.document.push(addLayer(desk.document.project(), 3, LloydRelaxation{}).edit);
        QCOMPARE(view.currentIndex().row(), 4);
        desk.document.undoStack().undo();
        QCOMPARE(view.currentIndex().row(), 0);
    }
    void layersAreMovedByKeysAndDragging() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        const auto order = [&] {
            std::vector<Id> ids;
            for (const PatternLayer& layer : desk.asset(3).pattern.layers) ids.push_back(layer.id);
            return ids;
        };
        const std::vector<Id> first = order();
        editor.showLayer(first[2]);
        editor.view().setFocus();
        QTest::keyClick(&editor.view(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(order(), (std::vector{first[0], first[2], first[1], first[3]}));
        QTest::keyClick(&editor.view(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(order(), first);
        const int steps = desk.document.undoStack().count();
        // What a view does when a row is dropped before another one, or after the last.
        QAbstractItemModel& rows = *editor.view().model();
        QVERIFY(rows.moveRow({}, 0, {}, 4));
        QCOMPARE(order(), (std::vector{first[1], first[2], first[3], first[0]}));
        QVERIFY(rows.moveRow({}, 3, {}, 1));
        QCOMPARE(order(), (std::vector{first[1], first[0], first[2], first[3]}));
        QVERIFY(!rows.moveRow({}, 1, {}, 2));
        QCOMPARE(desk.document.undoStack().count(), steps + 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void levelsAreAddedAndDeleted() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QTest::mouseClick(&desk.control<QToolButton>("Add Level"), Qt::LeftButton);
        QCOMPARE(desk.asset().levels.size(), 1u);
        desk.type("Minimum volume", "0.001");
        QCOMPARE(desk.asset().levels[0].minimumVolume, 0.001);
        desk.type("Count", "6");
        QCOMPARE(std::get<UniformScatter>(desk.asset().levels[0].pattern.layers[0].parameters).count, SeedCount(6));
        QVERIFY(!verifyProject(desk.document.project()));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Level"), Qt::LeftButton);
        QVERIFY(desk.asset().levels.empty());
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void levelsOfBondedAssetsHaveABondStrength() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QTest::mouseClick(&desk.control<QToolButton>("Add Level"), Qt::LeftButton);
        auto& strength = desk.control<SliderField>("Bond strength of level");
        auto& hasThreshold = *desk.inspector.page().findChild<QCheckBox*>("override-level-threshold");
        QVERIFY(!strength.isVisible() && hasThreshold.isVisible());
        Asset bonded = desk.asset();
        bonded.breakAs = BreakAs::Bonded;
        desk.document.push(modify("Break", std::move(bonded)));
        QVERIFY(strength.isVisible() && !hasThreshold.isVisible());
        strength.field().setFocus();
        strength.field().selectAll();
        QTest::keyClicks(&strength.field(), "3");
        QTest::keyClick(&strength.field(), Qt::Key_Return);
        QCOMPARE(desk.asset().levels[0].bondStrength, 3.0);
        test::drag(strength.slider());
        QCOMPARE(desk.asset().levels[0].bondStrength, 10.0);
        QCOMPARE(desk.document.undoStack().count(), 4);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void fragmentPatternsAreEditedLikeLevels() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& levels = desk.control<QComboBox>("Pattern");
        QCOMPARE(levels.count(), 5);
        QCOMPARE(levels.itemText(3), QString("Fragment 4.3.1, kept intact"));
        emit levels.activated(4);
        QCOMPARE(levels.currentText(), QString("Fragment 6.0"));
        desk.type("Minimum volume", "0.25");
        QCOMPARE(desk.asset(3).fragmentLevels[1].level->minimumVolume, 0.25);
        desk.type("Count", "9");
        QCOMPARE(std::get<UniformScatter>(desk.asset(3).fragmentLevels[1].level->pattern.layers[0].parameters).count,
                 SeedCount(9));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Level"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).fragmentLevels.size(), std::size_t{1});
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(PatternEditorTest, QApplication)
#include "PatternEditorTest.moc"
