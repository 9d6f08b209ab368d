// Tests editor/actions/SelectActions.cpp, editor/views/Views.cpp and editor/view3d/tools/SurfaceMeasureTool.cpp.
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/docks/FragmentTable.h"
#include "editor/panels/docks/ProblemPanel.h"
#include "editor/panels/docks/VolumeHistogram.h"
#include "editor/view3d/tools/SurfaceMeasureTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QTableView>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <cmath>

using namespace rubble;

namespace {

/// A box of 1 m in four columns, the last of them a sliver of 5 cm, and a seed that equals the first.
Project columns() {
    const PlacedSeeds seeds{{{0, {0.15, 0.5}}, {1, {0.45, 0.5}}, {2, {0.75, 0.5}}, {3, {1.15, 0.5}}, {4, {0.15, 0.5}}}};
    return boxProject(seeds);
}

}  // namespace

/// Inspecting fragments, by mouse and keys: selecting, hiding, isolating, measuring, and fixing a problem.
class InspectionStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(columns());
        QVERIFY(isBaked(2, 4));
    }
    void cleanupTestCase() { close(); }

    void boxAndLassoSelect() {
        canvas().setFocus();
        drag(canvas(), pixels({0.05, 0.9}), pixels({0.5, 0.1}));
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 0}, {3, 1}}));  // the fifth has no fragment
        lasso({{0.6, 0.9}, {0.6, 0.1}, {0.95, 0.1}, {0.95, 0.9}});
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 2}}));
    }
    void shortcutsSelectNeighboursAndInvert() {
        QTest::keyClick(&window(), Qt::Key_G, Qt::ControlModifier);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 1}, {3, 2}, {3, 3}}));
        QTest::keyClick(&window(), Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 0}, {3, 4}}));
        QTest::keyClick(&window(), Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(selection().seeds().size(), std::size_t{4});  // a seed without a fragment has no siblings
    }
    void fragmentsAreHiddenIsolatedAndShown() {
        selection().setSeeds({{3, 1}});
        QTest::keyClick(&canvas(), Qt::Key_H);
        QVERIFY((selection().hidden() == FragmentSelection{{{3, 1}}, std::nullopt}));
        QVERIFY(selection().seeds().empty());
        QTest::keyClick(&canvas(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
        selection().setSeeds({{3, 2}});
        QTest::keyClick(&canvas(), Qt::Key_Slash);
        QVERIFY((selection().hidden().seeds == Selection::Seeds{{3, 0}, {3, 1}, {3, 3}}));
        if (hasView()) QTRY_COMPARE(bodiesMarked(kHidden), 3);
        QTest::keyClick(&canvas(), Qt::Key_H, Qt::AltModifier);
        QCOMPARE(text(), m_before);  // visibility is not saved
        QCOMPARE(stack().count(), 0);
    }
    void tableFramesTheSelection() {
        auto& table = *window().findChild<FragmentTable*>();
        window().views().frameAsset();
        const double scale = canvas().view().scale, distance = viewport().camera().distance;
        selection().setSeeds({{3, 1}});
        QTest::keyClick(&table.view(), Qt::Key_F);
        QVERIFY(canvas().view().scale > scale);
        selection().setSeeds({{3, 0}, {3, 1}, {3, 2}, {3, 3}});
        QTest::keyClick(&table.view(), Qt::Key_F);
        if (hasView()) QVERIFY(viewport().camera().distance < 1.01 * distance);  // not farther than all of it
        window().views().frameAsset();
    }
    void tableHidesAndShowsByTheSameActions() {
        auto& table = *window().findChild<FragmentTable*>();
        selection().setSeeds({{3, 1}});
        QTest::keyClick(&table.view(), Qt::Key_H);
        QVERIFY((selection().hidden() == FragmentSelection{{{3, 1}}, std::nullopt}));
        QTest::keyClick(&table.view(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
        selection().setSeeds({{3, 2}});
        QTest::keyClick(&table.view(), Qt::Key_H, Qt::ShiftModifier);
        QVERIFY((selection().hidden().seeds == Selection::Seeds{{3, 0}, {3, 1}, {3, 3}}));
        const QList<QToolButton*> buttons = table.findChildren<QToolButton*>();
        const auto show = std::ranges::find(buttons, action("show"), &QToolButton::defaultAction);
        QVERIFY(show != buttons.end());
        QTest::mouseClick(*show, Qt::LeftButton);
        QVERIFY(selection().hidden().isEmpty());
    }
    void shortcutsInTheViewApplyToTheClickedFragment() {
        if (!hasView()) QSKIP("OpenGL is not available.");
        showFrontView();
        const QPoint second = viewport().pointOf({0.45, 0.12, 0.25})->toPoint();  // off the handles
        selection().setSeeds({});
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, second);
        QCOMPARE(selection().instances(), std::set<Id>{10});
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, second);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 1}}));
        QTest::keyClick(&viewport(), Qt::Key_H);
        QTRY_COMPARE(bodiesMarked(kHidden), 1);
        QVERIFY(!project().instances[0].isHidden);
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::AltModifier);
        QTRY_COMPARE(bodiesMarked(kHidden), 0);
    }
    void twoClicksMeasureADistance() {
        if (!hasView()) QSKIP("OpenGL is not available.");
        showFrontView();
        QTest::keyClick(&viewport(), Qt::Key_M);
        SurfaceMeasureTool& measure = window().views().scene().measureTool();
        QVERIFY(measure.isOn());
        const QPoint from = viewport().pointOf({0.0, 0.0, 0.25})->toPoint(),
                     to = viewport().pointOf({1.0, 1.0, 0.25})->toPoint();
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, from + QPoint(4, -4));
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, to + QPoint(-5, 3));
        QVERIFY(measure.distance());
        QVERIFY(std::abs(*measure.distance() - std::sqrt(2.0)) < 1e-5);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(measure.isOn() && !measure.distance());
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(!measure.isOn());
    }
    void viewShowsContextMenuOfFragments() {
        if (!hasView()) QSKIP("OpenGL is not available.");
        auto* scope = window().findChild<QComboBox*>("scope");
        scope->setCurrentIndex(1);
        showFrontView();
        selection().setSeeds({});
        const QPoint second = viewport().pointOf({0.45, 0.12, 0.25})->toPoint();
        QStringList names = menuAt(second);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 1}}));
        for (const char* name : {"fragment-enter", "fragment-fracture", "fragment-merge", "fragment-split",
                                 "select-neighbours", "hide", "isolate", "show"}) {
            QVERIFY2(names.contains(name), name);
        }
        scope->setCurrentIndex(0);
        selection().setSeeds({});
        showFrontView();
        names = menuAt(second);
        QVERIFY(names.contains("instance-hide"));  // the whole scene is edited by instances
        QVERIFY(!names.contains("fragment-split"));
    }
    void toolShortcutOpensNoMenu() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_R, Qt::AltModifier);
        QCOMPARE(canvas().toolKind(), CanvasToolKind::Measure);
        QTest::keyClick(&canvas(), Qt::Key_Q, Qt::AltModifier);
        QCOMPARE(canvas().toolKind(), CanvasToolKind::Seeds);
    }
    void toolBarsFitTheDefaultWindow() {
        window().resize(1440, 900);
        for (QToolBar* bar : window().findChildren<QToolBar*>()) {
            if (!bar->isVisible()) continue;
            auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
            QTRY_VERIFY2(!more || !more->isVisible(), bar->windowTitle().toUtf8());
        }
        auto* tools = window().findChild<QToolBar*>("bar-tools");
        QCOMPARE(tools->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
        window().resize(1000, 700);
        QTRY_COMPARE(tools->toolButtonStyle(), Qt::ToolButtonIconOnly);
        window().resize(1440, 900);
        QTRY_COMPARE(tools->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    }
    void histogramBarSelectsItsFragments() {
        auto& histogram = *window().findChild<VolumeHistogram*>();
        selection().setSeeds({});
        QTest::mouseClick(&histogram, Qt::LeftButton, {}, histogram.barRect(0).center().toPoint());
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 3}}));
        QCOMPARE(histogram.bars().front().selected, 1u);
    }
    void enterRevealsProblem() {
        auto* dock = window().findChild<QDockWidget*>("dock-problems");
        QVERIFY(dock->visibleRegion().isEmpty());  // behind another dock
        QAction* action = nullptr;
        for (QAction* one : window().views().docks().actions()) {
            if (one->text() == "Problems") action = one;
        }
        action->trigger();
        QTRY_VERIFY(!dock->visibleRegion().isEmpty());
        action->trigger();
        QVERIFY(dock->isHidden() && !action->isChecked());
        action->trigger();
        QTRY_VERIFY(!dock->visibleRegion().isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(problems().view().model()->rowCount(), 2, kPatience);
        QCOMPARE(dock->windowTitle(), QString("Problems (2)"));
        QCOMPARE(problems().problem(problems().view().model()->index(0, 0)).code,
                 DiagnosticCode::Sliver);  // the most severe comes first
        selection().setSeeds({});
        selection().setHidden({{{3, 3}}, std::nullopt});
        QTreeView& view = problems().view();
        view.setFocus();
        view.setCurrentIndex(view.model()->index(0, 0));
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 3}}));
        QVERIFY(selection().hidden().isEmpty());  // the revealed fragment is shown
        QVERIFY(glm::distance(canvas().view().centre, Vec2(0.975, 0.5)) < 0.2);
    }
    void fixIsOneUndoStep() {
        QTreeView& view = problems().view();
        view.selectAll();
        QTest::mouseClick(button("Delete Seed"), Qt::LeftButton);
        QCOMPARE(stack().count(), 1);
        const auto& seeds = std::get<PlacedSeeds>(project().assets[0].pattern.layers[0].parameters).seeds;
        QCOMPARE(seeds.size(), std::size_t{3});
        QTRY_COMPARE_WITH_TIMEOUT(problems().view().model()->rowCount(), 0, kPatience);
        QVERIFY(!button("Delete Seed")->isVisible());
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), m_before);
        QTRY_COMPARE_WITH_TIMEOUT(problems().view().model()->rowCount(), 2, kPatience);
    }
    /// Also in the 3D view, where instances are selected.
    void allInstancesAreSelectedWhereOneIs() {
        const Id first = project().instances.front().id;
        window().workspace().document().push(duplicateInstances(project(), std::vector{first}, {2.0, 0.0, 0.0}));
        selection().setInstances(project(), {first});
        QTest::keyClick(&window(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selection().instances().size(), project().instances.size());
        QVERIFY(selection().subject() == Part::Instance);
        window().findChild<QAction*>("select-none")->trigger();
        QVERIFY(selection().instances().empty());
        stack().undo();
    }

private:
    ProblemPanel& problems() { return *window().findChild<ProblemPanel*>(); }
    QToolButton* button(const QString& text) {
        for (QToolButton* button : problems().findChildren<QToolButton*>()) {
            if (button->text() == text) return button;
        }
        return nullptr;
    }
    /// The object names of the actions in the 3D view's context menu at a point.
    QStringList menuAt(QPoint point) {
        QStringList names;
        QTimer::singleShot(0, this, [&names] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (!menu) return;
            for (const QAction* action : menu->findChildren<QMenu*>().value(0, menu)->actions() + menu->actions()) {
                names.append(action->objectName());
            }
            menu->close();
        });
        emit viewport().customContextMenuRequested(point);
        return names;
    }
    void showFrontView() {
        QTRY_COMPARE(bodiesMarked(kHidden), 0);  // the scene is made when the events before are done
        viewport().alignTo(StandardView::Front);
        viewport().setProjection(Projection::Orthographic);
        viewport().frameAll();
    }
};

RUBBLE_TEST_WITH(InspectionStoryTest, QApplication)
#include "InspectionStoryTest.moc"
