#include "editor/view3d/ScenePicker.h"

#include "editor/workspace/Workspace.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QTemporaryDir>

using namespace rubble;

namespace {

constexpr Id kBox = 2;  // the asset

Project threeBoxes() {
    Project project = boxProject(UniformScatter{.count = 4});
    project.instances.clear();
    for (const Id id : {10u, 11u, 12u})
        project.instances.push_back({.id = id, .name = "box " + std::to_string(id), .asset = kBox});
    project.instances[2].isLocked = true;
    return project;
}

}  // namespace

class ScenePickerTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_workspace = std::make_unique<Workspace>(threeBoxes(), m_folder.path());
        m_viewport = std::make_unique<ViewportWidget>();
        m_picker = new ScenePicker(*m_workspace, *m_viewport);
        selection().setAsset(kBox);
        QTRY_VERIFY(m_workspace->bakes().areCurrent(m_workspace->project()));
    }
    void cleanup() {
        m_viewport.reset();
        m_workspace.reset();
    }
    void clickSelectsTheInstanceAndThenItsFragment() {
        pick(10, 1);
        QCOMPARE(selection().instances(), std::set<Id>{10});
        QVERIFY(selection().fragments().isEmpty());
        pick(10, 1);
        QVERIFY(!selection().fragments().isEmpty());
        QCOMPARE(m_picker->marks().selected.size(), std::size_t{1});
        QCOMPARE(m_picker->marks().selected[0].fragment, 1u);
        pick(11, 0);
        QCOMPARE(selection().instances(), std::set<Id>{11});
        QVERIFY(selection().fragments().isEmpty());
    }
    void modifiersExtendTheSelection() {
        pick(10, 0);
        pick(11, 0, Qt::ShiftModifier);
        QCOMPARE(selection().instances(), (std::set<Id>{10, 11}));
        pick(10, 0, Qt::ControlModifier);
        QCOMPARE(selection().instances(), std::set<Id>{11});
    }
    void backgroundAndLockedInstancesDeselect() {
        pick(10, 0);
        pick(12, 0);
        QVERIFY(selection().instances().empty());
        pick(10, 0);
        emit m_viewport->picked(std::nullopt, Qt::ShiftModifier);
        QCOMPARE(selection().instances(), std::set<Id>{10});
        emit m_viewport->picked(std::nullopt, {});
        QVERIFY(selection().instances().empty());
    }
    void rectangleSelectsUnlockedInstances() {
        emit m_viewport->boxSelected({{kBox, 10, 0}, {kBox, 11, 2}, {kBox, 12, 1}}, {});
        QCOMPARE(selection().instances(), (std::set<Id>{10, 11}));
    }
    void rectangleSelectsFragmentsOfAnAssetByItself() {
        m_picker->setAssetOnly(true);
        emit m_viewport->boxSelected({{kBox, 0, 0}, {kBox, 0, 2}}, {});
        QCOMPARE(m_picker->marks().selected, (std::vector<PickId>{{kBox, 0, 0}, {kBox, 0, 2}}));
    }
    void hiddenInstancesAndFragmentsAreMarked() {
        pick(10, 3);
        pick(10, 3);
        selection().setHidden(selection().fragments());
        QCOMPARE(m_picker->marks().hidden.size(), std::size_t{1});
        QCOMPARE(m_picker->marks().hidden[0].fragment, 3u);
    }

private:
    Selection& selection() { return m_workspace->selection(); }
    void pick(Id instance, std::uint32_t fragment, Qt::KeyboardModifiers modifiers = {}) {
        emit m_viewport->picked(PickId{kBox, instance, fragment}, modifiers);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<ViewportWidget> m_viewport;
    ScenePicker* m_picker = nullptr;  // owned by the viewport
};

RUBBLE_TEST_WITH(ScenePickerTest, QApplication)
#include "ScenePickerTest.moc"
