// Tests editor/actions/VisibilityActions.cpp and editor/document/FragmentVisibility.cpp.
#include "editor/commands/InstanceEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

using namespace rubble;

namespace {

Project twoBoxes() {
    Project project = boxProject(UniformScatter{.count = 6});
    project.instances.clear();
    for (const Id id : {10u, 11u})
        project.instances.push_back({.id = id, .name = "box " + std::to_string(id), .asset = 2});
    project.instances.back().pose.position = {2.0, 0.0, 0.0};
    return project;
}

}  // namespace

/// H, Shift+H and Alt+H in canvas and 3D view, with fragments and with instances selected.
class VisibilityStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() { openBaked(twoBoxes()); }
    void init() {
        selection().setHidden({});
        selection().setAsset(2);
        selection().setSeeds({});
        selection().setInstances(project(), {});
        while (stack().canUndo()) stack().undo();
        viewport().setFocus();
    }
    void keyHidesTheSubjectOnly() {
        selection().setInstances(project(), {10});
        selection().setSeeds({{3, 1}});
        QTest::keyClick(&viewport(), Qt::Key_H);
        QVERIFY(!selection().hidden().isEmpty());
        QVERIFY(!isHidden(10));
        selection().setHidden({});
        selection().setSeeds({{3, 1}});
        selection().setInstances(project(), {10});
        QTest::keyClick(&viewport(), Qt::Key_H);
        QVERIFY(isHidden(10) && !isHidden(11));
        QVERIFY(selection().hidden().isEmpty());
    }
    void keyIsolatesTheSubjectOnly() {
        selection().setInstances(project(), {10});
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(!isHidden(10) && isHidden(11));
        QVERIFY(selection().hidden().isEmpty());
        selection().setSeeds({{3, 1}});
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::ShiftModifier);
        QCOMPARE(selection().hidden().seeds.size(), std::size_t{5});
    }
    /// The canvas shows no instances.
    void keyShowsAllThatTheViewCanHide() {
        hideOneOfEach();
        QTest::keyClick(&canvas(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
        QVERIFY(isHidden(11));
        hideOneOfEach();
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
        QVERIFY(!isHidden(11));
    }
    void menusShowAllOfTheirKind() {
        hideOneOfEach();
        canvas().setFocus();
        action("instance-show")->trigger();
        QVERIFY(!isHidden(11));
        QVERIFY(!selection().hidden().isEmpty());
        action("show")->trigger();
        QVERIFY(selection().hidden().isEmpty());
        QVERIFY(!action("show")->isEnabled() && !action("instance-show")->isEnabled());
    }
    /// In play the key has no meaning for the scene: nothing is edited.
    void keyShowsNothingInPlay() {
        hideOneOfEach();
        PlayController& controller = window().workspace().play();
        controller.thread().useSteppedClock();
        controller.play();
        QVERIFY(controller.isInPlay());
        QKeyEvent press(QEvent::ShortcutOverride, Qt::Key_H, Qt::AltModifier);
        press.ignore();
        QApplication::sendEvent(&viewport(), &press);
        QVERIFY(!press.isAccepted());
        QVERIFY(isHidden(11));
        controller.stop();
    }
    void cleanupTestCase() { close(); }

private:
    bool isHidden(Id instance) { return findInstance(project(), instance)->isHidden; }
    void hideOneOfEach() {
        selection().setInstances(project(), {11});
        action("instance-hide")->trigger();
        selection().setSeeds({{3, 1}});
        action("hide")->trigger();
        QVERIFY(isHidden(11) && !selection().hidden().isEmpty());
    }
};

RUBBLE_TEST_WITH(VisibilityStoryTest, QApplication)
#include "VisibilityStoryTest.moc"
