// Tests editor/panels/docks/ProjectTree.cpp, editor/panels/docks/InstanceIconDelegate.cpp and
// editor/panels/models/ProjectModel.cpp.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/library/StarterProject.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "core/io/project/ProjectFile.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/docks/InstanceIconDelegate.h"
#include "editor/panels/docks/ProjectTree.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomEdits.h"
#include "tests/support/editor/EventLoop.h"

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QTreeView>

using namespace rubble;

namespace {

using Kind = ProjectModel::Kind;

/// A document with its tree in a window.
struct ProjectTreeDesk {
    Document document;
    Selection selection;
    ProjectTree tree{document, selection};
    QTreeView& view = tree.view();
    ProjectModel& model = *tree.findChild<ProjectModel*>();
    QAbstractItemModelTester tester{&model};

    explicit ProjectTreeDesk(Project project = fullProject()) : document(std::move(project)) {
        selection.prune(document.project());
        tree.resize(300, 600);
        tree.show();
        tree.activateWindow();
        if (!QTest::qWaitForWindowActive(&tree, kPatience)) qFatal("The window does not become active.");
        view.expandAll();
        view.setFocus();
    }
    void click(Kind kind, Id id, Qt::KeyboardModifiers modifiers = {}) {
        const QRect place = view.visualRect(model.indexOf({kind, id}));
        QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, place.center());
    }
    /// Clicks an icon at the end of an instance's row.
    void clickIcon(Id instance, int role, Qt::MouseButton button = Qt::LeftButton) {
        const auto* icons = qobject_cast<InstanceIconDelegate*>(view.itemDelegate());
        const QRect place = icons->iconRect(model.indexOf({Kind::Instance, instance}), role);
        QTest::mouseClick(view.viewport(), button, {}, place.center());
    }
    void rename(const QString& name) {
        QTest::keyClick(&view, Qt::Key_F2);
        auto* editor = view.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();  // the editor hands over what was typed, then goes
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QString text(Kind kind, Id id) { return model.data(model.indexOf({kind, id}), Qt::DisplayRole).toString(); }
};

}  // namespace

class ProjectTreeTest : public QObject {
    Q_OBJECT
private slots:
    void anAssetThatIsSelectedBeforeItHasARowIsShown() {
        Document document(emptyProject());
        Selection selection;
        connect(&document, &Document::changed, &selection, [&] { selection.prune(document.project()); });
        ProjectTree tree(document, selection);
        const Addition added = addAsset(document.project(), "wall", {rectangleOutline(1.0, 1.0), 0.5});
        document.push(added.edit);
        QCOMPARE(selection.asset(), added.id);
        const QModelIndex row = tree.findChild<ProjectModel*>()->indexOf({Kind::Asset, added.id});
        QCOMPARE(tree.view().selectionModel()->selectedIndexes(), QModelIndexList{row});
    }
    void treeShowsTheProject() {
        ProjectTreeDesk desk;
        QCOMPARE(desk.text(Kind::Asset, 3), "wall");
        QCOMPARE(desk.text(Kind::Layer, 4), "4 · Uniform, 7 seeds");
        QCOMPARE(desk.text(Kind::Layer, 5), "5 · Blue noise, 0.2\u00a0m apart (disabled)");
        QCOMPARE(desk.text(Kind::Layer, 7), "7 · Lloyd relaxation, 4 rounds");
        QCOMPARE(desk.text(Kind::Layer, 8), "Level 1: 8 · Blue noise, 0.1\u00a0m apart");
        QCOMPARE(desk.text(Kind::Instance, 21), "right");
        desk.tree.setUnits({LengthUnit::Centimetre});
        QCOMPARE(desk.text(Kind::Layer, 5), "5 · Blue noise, 20\u00a0cm apart (disabled)");
    }
    void clicksSelect() {
        ProjectTreeDesk desk;
        desk.click(Kind::Material, 2);
        QCOMPARE(desk.selection.material(), 2u);
        QCOMPARE(desk.selection.subject(), Part::Material);
        desk.click(Kind::Layer, 10);
        QCOMPARE(desk.selection.asset(), 9u);
        QCOMPARE(desk.selection.subject(), Part::Asset);
        desk.click(Kind::Instance, 20);
        desk.click(Kind::Instance, 21, Qt::ControlModifier);
        QCOMPARE(desk.selection.instances(), (std::set<Id>{20, 21}));
        QCOMPARE(desk.selection.subject(), Part::Instance);
        desk.click(Kind::Scene, 0);
        QCOMPARE(desk.selection.subject(), Part::Scene);
    }
    void clickOnOneOfSeveralSelectsIt() {
        ProjectTreeDesk desk;
        desk.click(Kind::Instance, 20);
        desk.click(Kind::Instance, 21, Qt::ControlModifier);
        desk.click(Kind::Instance, 20);
        QCOMPARE(desk.selection.instances(), (std::set<Id>{20}));
        test::runTimersDueWithin(QApplication::doubleClickInterval() + 100);
        QVERIFY(!desk.view.viewport()->findChild<QLineEdit*>());
    }
    void slowSecondClickRenames() {
        ProjectTreeDesk desk;
        desk.click(Kind::Instance, 20);
        test::runTimersDueWithin(QApplication::doubleClickInterval() + 100);
        desk.click(Kind::Instance, 20);
        QTRY_VERIFY(desk.view.viewport()->findChild<QLineEdit*>());
    }
    void firstRowsAreInViewAtFirst() {
        Document document(fullProject());
        Selection selection;
        selection.prune(document.project());
        ProjectTree tree(document, selection);
        tree.resize(300, 120);
        emit selection.assetChanged(selection.asset());
        tree.resize(300, 600);
        tree.show();
        QVERIFY(QTest::qWaitForWindowExposed(&tree, kPatience));
        QCOMPARE(tree.view().indexAt({2, 2}), tree.view().model()->index(0, 0));
    }
    void clickedIconsToggleFlagsWithoutSelecting() {
        Project project = fullProject();
        for (Instance& instance : project.instances) instance.isHidden = instance.isLocked = false;
        ProjectTreeDesk desk(project);
        desk.click(Kind::Asset, 9);
        const auto instance = [&desk] {
            return *std::ranges::find(desk.document.project().instances, 21u, &Instance::id);
        };
        desk.clickIcon(21, ProjectModel::kHiddenRole);
        QVERIFY(instance().isHidden && !instance().isLocked);
        desk.clickIcon(21, ProjectModel::kLockedRole);
        QVERIFY(instance().isHidden && instance().isLocked);
        desk.clickIcon(21, ProjectModel::kHiddenRole);
        QVERIFY(!instance().isHidden && instance().isLocked);
        QCOMPARE(desk.selection.asset(), 9u);
        QCOMPARE(desk.selection.subject(), Part::Asset);
        QCOMPARE(desk.document.undoStack().count(), 3);  // an undo step each
        while (desk.document.undoStack().canUndo()) desk.document.undoStack().undo();
        QCOMPARE(projectText(desk.document.project()), projectText(project));
    }
    void onlyInstancesHaveIcons() {
        ProjectTreeDesk desk;
        const int end = desk.view.viewport()->width() - 6;
        const QRect row = desk.view.visualRect(desk.model.indexOf({Kind::Asset, 9}));
        QTest::mouseClick(desk.view.viewport(), Qt::LeftButton, {}, {end, row.center().y()});
        QCOMPARE(desk.document.undoStack().count(), 0);
        QCOMPARE(desk.selection.asset(), 9u);
    }
    void rightClickOnAnIconTogglesNothing() {
        ProjectTreeDesk desk;
        desk.clickIcon(21, ProjectModel::kHiddenRole, Qt::RightButton);
        QCOMPARE(desk.document.undoStack().count(), 0);
    }
    void rowsFollowTheSelection() {
        ProjectTreeDesk desk;
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QCOMPARE(desk.view.selectionModel()->selectedIndexes().size(), 2);
        desk.selection.setAsset(11);
        const QModelIndexList rows = desk.view.selectionModel()->selectedIndexes();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(desk.model.nodeAt(rows[0]), (ProjectModel::Node{Kind::Asset, 11}));
    }
    void replacedProjectSelectsItsFirstAsset() {
        ProjectTreeDesk desk(emptyProject());
        desk.selection.setAsset(3);  // the workspace hears of a new project before the tree does
        QCOMPARE(desk.selection.subject(), Part::Asset);
        desk.document.replace(fullProject());
        QCOMPARE(desk.selection.subject(), Part::Asset);
        const QModelIndexList rows = desk.view.selectionModel()->selectedIndexes();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(desk.model.nodeAt(rows[0]), (ProjectModel::Node{Kind::Asset, 3}));
    }
    void f2Renames() {
        ProjectTreeDesk desk;
        desk.click(Kind::Asset, 9);
        desk.rename("crate");
        QCOMPARE(desk.text(Kind::Asset, 9), "crate");
        desk.document.undoStack().undo();
        QCOMPARE(desk.text(Kind::Asset, 9), "box");
        QVERIFY(!desk.document.undoStack().canUndo());
    }
    void emptyAndTakenNamesAreRefused() {
        ProjectTreeDesk desk;
        QSignalSpy refusals(&desk.tree, &ProjectTree::refused);
        desk.click(Kind::Asset, 9);
        desk.rename("WALL");
        desk.rename("  ");
        QCOMPARE(refusals.count(), 2);
        QCOMPARE(refusals[0][0], "The name \"wall\" is already taken.");
        QCOMPARE(refusals[1][0], "A name must not be empty.");
        QVERIFY(!desk.document.undoStack().canUndo());
        desk.rename("Box");  // its own name, capitalized
        QCOMPARE(desk.text(Kind::Asset, 9), "Box");
    }
    void refusedNameStaysInItsEditor() {
        ProjectTreeDesk desk;
        desk.click(Kind::Asset, 9);
        desk.rename("wall");
        auto* editor = desk.view.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor && editor->isVisible() && editor->text() == "wall");
        QVERIFY2(QToolTip::text().contains("already taken"), qPrintable(QToolTip::text()));
        desk.tree.findChild<QToolButton*>()->setFocus();  // a click elsewhere
        for (int k = 0; k < 3; ++k) QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        editor = desk.view.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor && editor->isVisible() && editor->text() == "wall");
        QTest::keyClick(editor, Qt::Key_Escape);
        for (int k = 0; k < 3; ++k) QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!desk.view.viewport()->findChild<QLineEdit*>());
        QCOMPARE(desk.text(Kind::Asset, 9), "box");
    }
    void toolTipsHaveTheWholeName() {
        ProjectTreeDesk desk;
        for (const auto& [kind, id] : {std::pair(Kind::Instance, 21u), std::pair(Kind::Layer, 5u)}) {
            const QString tip = desk.model.data(desk.model.indexOf({kind, id}), Qt::ToolTipRole).toString();
            QVERIFY2(tip.contains(desk.text(kind, id)), qPrintable(tip));
        }
    }
    void ctrlDDuplicatesTheSelection() {
        ProjectTreeDesk desk;
        desk.click(Kind::Instance, 20);
        desk.click(Kind::Instance, 21, Qt::ControlModifier);
        QTest::keyClick(&desk.view, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(desk.document.project().instances.size(), 4u);
        QCOMPARE(desk.selection.instances(), (std::set<Id>{40, 41}));
        desk.document.undoStack().undo();
        QCOMPARE(projectText(desk.document.project()), projectText(fullProject()));
    }
    void deleteRemovesTheSelectionInOneStep() {
        ProjectTreeDesk desk;
        desk.click(Kind::Material, 2);
        desk.click(Kind::Asset, 9, Qt::ControlModifier);
        desk.click(Kind::Instance, 20, Qt::ControlModifier);
        QTest::keyClick(&desk.view, Qt::Key_Delete);
        QCOMPARE(desk.document.project().materials.size(), 1u);
        QVERIFY(!findAsset(desk.document.project(), 9));
        QVERIFY(desk.document.project().instances.empty());  // 21 was one of asset 9
        QVERIFY(!verifyProject(desk.document.project()));
        QCOMPARE(desk.document.undoStack().count(), 1);
        desk.document.undoStack().undo();
        QCOMPARE(projectText(desk.document.project()), projectText(fullProject()));
    }
    void lastMaterialCannotBeDeleted() {
        ProjectTreeDesk desk(starterProject());
        QSignalSpy refusals(&desk.tree, &ProjectTree::refused);
        desk.click(Kind::Material, desk.document.project().materials[0].id);
        QTest::keyClick(&desk.view, Qt::Key_Delete);
        QCOMPARE(refusals.count(), 1);
        QCOMPARE(desk.document.undoStack().count(), 0);
    }
    void addedMaterialIsSelected() {
        ProjectTreeDesk desk;
        desk.tree.addMaterial();
        QCOMPARE(desk.selection.material(), 40u);
        QCOMPARE(desk.document.undoStack().count(), 1);
    }
    void collapsedRowsStayCollapsedWhenOthersChange() {
        ProjectTreeDesk desk;
        desk.view.setExpanded(desk.model.indexOf({Kind::Asset, 3}), false);
        desk.document.push(addLayer(desk.document.project(), 9, LloydRelaxation{}).edit);
        desk.document.push(removeAssets(desk.document.project(), std::vector<Id>{11}));
        QVERIFY(!desk.view.isExpanded(desk.model.indexOf({Kind::Asset, 3})));
        QVERIFY(desk.view.isExpanded(desk.model.indexOf({Kind::Asset, 9})));
        QCOMPARE(desk.model.rowCount(desk.model.indexOf({Kind::Asset, 9})), 2);
    }
    void reorderedLayersMove() {
        ProjectTreeDesk desk;
        Asset asset = *findAsset(desk.document.project(), 3);
        std::swap(asset.pattern.layers[0], asset.pattern.layers[3]);
        desk.document.push(modify("Move Layer", std::move(asset)));
        const QModelIndex parent = desk.model.indexOf({Kind::Asset, 3});
        QCOMPARE(desk.model.nodeAt(desk.model.index(0, 0, parent)).id, 7u);
        QCOMPARE(desk.model.nodeAt(desk.model.index(3, 0, parent)).id, 4u);
    }
    void inheritedLayerHasOneRow() {
        ProjectTreeDesk desk;
        Asset wall = desk.document.project().assets[0];
        const int rows = desk.model.rowCount(desk.model.indexOf({Kind::Asset, 3}));
        const QString text = desk.text(Kind::Layer, 8);
        ownPattern(wall, "4.0").layers.push_back({.id = 39, .parameters = PlacedSeeds{}});
        QCOMPARE(wall.fragmentLevels[0].level->pattern.layers.front().id, 8u);
        desk.document.push(modify("Place Seed", std::move(wall)));
        QCOMPARE(desk.model.rowCount(desk.model.indexOf({Kind::Asset, 3})), rows + 1);
        QCOMPARE(desk.text(Kind::Layer, 8), text);
        QVERIFY(desk.text(Kind::Layer, 39).contains("4.0"));
        desk.document.undoStack().undo();
        QCOMPARE(desk.model.rowCount(desk.model.indexOf({Kind::Asset, 3})), rows);
    }
    void modelFollowsRandomEdits() {
        constexpr std::uint64_t kSeed = 1911;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        ProjectTreeDesk desk;
        const std::string before = projectText(desk.document.project());
        for (int k = 0; k < 200; ++k) {
            desk.document.push(randomEdit(desk.document.project(), random, 0));
            if (random.below(5) == 0) desk.document.undoStack().undo();
            desk.selection.prune(desk.document.project());
        }
        while (desk.document.undoStack().canUndo()) desk.document.undoStack().undo();
        QCOMPARE(projectText(desk.document.project()), before);
        // Four layers of the whole, one of the first level, twelve of the second, one of a fragment with its own
        // pattern.
        QCOMPARE(desk.model.rowCount(desk.model.indexOf({Kind::Asset, 3})), 18);
    }
};

RUBBLE_TEST_WITH(ProjectTreeTest, QApplication)
#include "ProjectTreeTest.moc"
