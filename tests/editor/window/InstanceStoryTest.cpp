// Tests editor/actions/InstanceActions.cpp, editor/dialogs/ArrayDialogs.cpp, editor/view3d/tools/TransformTool.cpp,
// editor/view3d/tools/PlacementTool.cpp and editor/background/OverlapWatch.cpp.
#include "editor/commands/InstanceEdits.h"
#include "editor/dialogs/ArrayDialogs.h"
#include "editor/document/DraggedAsset.h"
#include "editor/panels/docks/ProjectTree.h"
#include "editor/view3d/tools/PlacementTool.h"
#include "editor/view3d/tools/TransformTool.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"

#include <QCheckBox>
#include <QDropEvent>

using namespace rubble;

namespace {

Project threeBoxes() {
    Project project = boxProject(UniformScatter{.count = 6});
    project.instances.clear();
    for (int k = 0; k < 3; ++k) {
        const Id id = 10 + static_cast<Id>(k);
        project.instances.push_back({.id = id, .name = "box " + std::to_string(k + 1), .asset = 2});
        project.instances.back().pose.position = {2.0 * k, 0.0, 0.0};
    }
    return project;
}

}  // namespace

/// Editing instances in the 3D view, by mouse and keys.
class InstanceStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        open(threeBoxes());
        if (!hasView()) QSKIP("OpenGL is not available.");
        viewport().frameAll();
    }
    void init() {
        window().workspace().document().replace(threeBoxes());
        select({11});
        viewport().setFocus();
        m_before = text();
    }
    void cleanupTestCase() { close(); }

    void handleMovesAlongItsAxisAsOneStep() {
        const QPoint tip = gripOf(GizmoHandle::MoveX);
        drag(tip, tip + QPoint(60, 0), {});
        const Vec3 place = placeOf(11);
        QVERIFY(place.x > 2.05);
        QVERIFY(place.y == 0.0 && place.z == 0.0);
        QVERIFY(placeOf(10) == Vec3(0.0));
        QCOMPARE(stack().count(), 1);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), m_before);
    }
    void ctrlSnapsMovesToTenthsOfAMetre() {
        const QPoint tip = gripOf(GizmoHandle::MoveX);
        drag(tip, tip + QPoint(60, 0), Qt::ControlModifier);
        const double tenths = (placeOf(11).x - 2.0) / TransformTool::kStep;
        QVERIFY(tenths > 0.5 && std::abs(tenths - std::round(tenths)) < 1e-9);
    }
    void escapeCancelsADrag() {
        const QPoint tip = gripOf(GizmoHandle::MoveY);
        press(tip);
        moveTo(tip - QPoint(0, 40), {}, Qt::LeftButton);
        QVERIFY(placeOf(11).y > 0.0);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QCOMPARE(text(), m_before);
        QCOMPARE(stack().count(), 0);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, tip);
        QVERIFY(!gizmo().isDragging());
    }
    void selectedInstancesAreJoinedWithMortar() {
        QAction* join = action("instance-mortar");
        QVERIFY(!join->isEnabled());  // they break whole
        Asset asset = *project().assets.begin();
        asset.breakAs = BreakAs::Bonded;
        window().workspace().document().push(modify("Bond", asset));
        select({10, 11});
        QVERIFY(join->isEnabled());
        join->trigger();
        const std::vector<Mortar>& mortars = project().mortars;
        QCOMPARE(mortars.size(), std::size_t{1});
        QCOMPARE(mortars[0].instances, (std::vector<Id>{10, 11}));
        const Selection& selection = window().workspace().selection();
        QCOMPARE(selection.mortar(), mortars[0].id);
        QVERIFY(selection.subject() == Part::Scene);
        stack().undo();
        QCOMPARE(selection.mortar(), Id{0});
        stack().undo();
        QCOMPARE(text(), m_before);
    }
    void ctrlSnapsRotationsTo15Degrees() {
        QTest::keyClick(&viewport(), Qt::Key_E);
        QCOMPARE(gizmo().mode(), GizmoMode::Rotate);
        const QPoint grip = gripOf(GizmoHandle::RotateY, 5);
        drag(grip, grip + QPoint(40, 20), Qt::ControlModifier);
        const Quat turn = findInstance(project(), 11)->pose.orientation;
        QVERIFY(std::abs(turn.x) < 1e-12 && std::abs(turn.z) < 1e-12);
        const double steps = glm::degrees(2.0 * std::atan2(turn.y, turn.w)) / TransformTool::kStepDegrees;
        QVERIFY(std::abs(steps) > 0.5 && std::abs(steps - std::round(steps)) < 1e-9);
        QTest::keyClick(&viewport(), Qt::Key_W);
        QCOMPARE(gizmo().mode(), GizmoMode::Move);
    }
    void grabKeyMovesAlongAnAxisUntilAClick() {
        const QPoint at = viewport().rect().center();
        moveTo(at);
        QTest::keyClick(&viewport(), Qt::Key_G);
        QVERIFY(gizmo().isDragging());
        QTest::keyClick(&viewport(), Qt::Key_X);
        moveTo(at + QPoint(50, 10));
        QVERIFY(placeOf(11).x > 2.05);
        QVERIFY(placeOf(11).y == 0.0 && placeOf(11).z == 0.0);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at + QPoint(50, 10));
        QVERIFY(!gizmo().isDragging());
        QCOMPARE(stack().count(), 1);
    }
    void handlesThatAreNotSeenAreNotDragged() {
        const QPoint grip = gripOf(GizmoHandle::MoveX);
        for (const bool isShown : {true, false}) {
            viewport().setOverlaysOn(isShown);
            QTest::mousePress(&viewport(), Qt::LeftButton, {}, grip);
            QCOMPARE(gizmo().isDragging(), isShown);
            QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, grip);
        }
        viewport().setOverlaysOn(true);
    }
    void typedNumberIsTheDistanceAlongTheAxis() {
        const QPoint at = viewport().rect().center();
        moveTo(at);
        QTest::keyClick(&viewport(), Qt::Key_G);
        QTest::keyClick(&viewport(), Qt::Key_X);
        QTest::keyClicks(&viewport(), "-1.255");
        QTest::keyClick(&viewport(), Qt::Key_Backspace);
        moveTo(at + QPoint(50, 10));
        QVERIFY(glm::distance(placeOf(11), Vec3(2.0 - 1.25, 0.0, 0.0)) < 1e-12);
        QTest::keyClick(&viewport(), Qt::Key_Return);
        QVERIFY(!gizmo().isDragging());
        QCOMPARE(stack().count(), 1);
        gizmo().setUnits({LengthUnit::Centimetre});
        QTest::keyClick(&viewport(), Qt::Key_G);
        QTest::keyClicks(&viewport(), "25");  // along x
        QTest::keyClick(&viewport(), Qt::Key_Return);
        QVERIFY(glm::distance(placeOf(11), Vec3(1.0, 0.0, 0.0)) < 1e-12);
        gizmo().setUnits({});
        QTest::keyClick(&viewport(), Qt::Key_R);
        QTest::keyClicks(&viewport(), "90");
        QTest::keyClick(&viewport(), Qt::Key_Return);
        QVERIFY(std::abs(findInstance(project(), 11)->pose.orientation.y - std::sqrt(0.5)) < 1e-12);
    }
    void otherSelectionEndsADrag_data() {
        QTest::addColumn<bool>("isOtherKind");
        QTest::newRow("another instance") << false;
        QTest::newRow("an asset") << true;
    }
    void otherSelectionEndsADrag() {
        QFETCH(const bool, isOtherKind);
        select({11});
        const Vec3 before = placeOf(11);
        const QPoint at = viewport().rect().center();
        moveTo(at);
        QTest::keyClick(&viewport(), Qt::Key_G);
        QVERIFY(gizmo().isDragging());
        if (isOtherKind)
            window().workspace().selection().setSubject(Part::Asset);
        else
            select({12});
        QVERIFY(!gizmo().isDragging());
        moveTo(at + QPoint(50, 10));
        QCOMPARE(placeOf(11), before);
    }
    void keysGoToTheViewUnderThePointer() {
        auto* tree = window().findChild<ProjectTree*>();
        tree->view().setFocus();
        moveTo(viewport().rect().center() + QPoint(3, 3));
        QVERIFY(viewport().hasFocus());
        EditorStory::moveTo(canvas(), canvas().rect().center());
        QVERIFY(canvas().hasFocus());
        auto* field = window().findChild<NumberField*>();
        field->window()->activateWindow();
        for (NumberField* each : window().findChildren<NumberField*>()) {
            if (each->isVisible() && each->isEnabled()) field = each;
        }
        field->setFocus();
        QVERIFY(field->hasFocus());
        moveTo(viewport().rect().center() + QPoint(7, 3));
        QVERIFY(field->hasFocus());  // what is typed stays in the field
    }
    void xDeletesNothing() {
        QTest::keyClick(&viewport(), Qt::Key_X);
        QCOMPARE(text(), m_before);
    }
    void lockedAndHiddenInstancesAreNotMoved() {
        QTest::keyClick(&viewport(), Qt::Key_L);
        QVERIFY(findInstance(project(), 11)->isLocked);
        QVERIFY(gizmo().movable().empty() && !gizmo().gizmoView());
        QTest::keyClick(&viewport(), Qt::Key_L, Qt::AltModifier);
        QVERIFY(!findInstance(project(), 11)->isLocked);
        QTest::keyClick(&viewport(), Qt::Key_H);
        QVERIFY(findInstance(project(), 11)->isHidden && gizmo().movable().empty());
        QTRY_VERIFY(isMarkedHidden(11));
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::AltModifier);
        QTRY_VERIFY(!isMarkedHidden(11));
    }
    void duplicatesFollowThePointerAndAreDeleted() {
        moveTo(viewport().rect().center());
        QTest::keyClick(&viewport(), Qt::Key_D, Qt::ShiftModifier);
        QCOMPARE(project().instances.size(), std::size_t{4});
        QVERIFY(gizmo().isDragging());
        QTest::keyClick(&viewport(), Qt::Key_Return);
        QTest::keyClick(&viewport(), Qt::Key_Delete);
        QCOMPARE(project().instances.size(), std::size_t{3});
    }
    void endDropsInstances() {
        Instance raised = *findInstance(project(), 11);
        raised.pose.position.y = 3.0;
        window().workspace().document().push(modify("Raise", raised));
        QTest::keyClick(&viewport(), Qt::Key_End);
        QCOMPARE(placeOf(11).y, 0.0);
    }
    void anchorsSelectedBondedInstances() {
        QAction& anchored = *action("instance-anchored");
        select({10, 11});
        QVERIFY(!anchored.isEnabled() && !anchored.isChecked());
        Project bonded = threeBoxes();
        bonded.assets[0].breakAs = BreakAs::Bonded;
        window().workspace().document().replace(bonded);
        const std::string before = text();
        select({10, 11});
        QVERIFY(anchored.isEnabled() && !anchored.isChecked());
        anchored.trigger();
        QVERIFY(findInstance(project(), 10)->isAnchored && findInstance(project(), 11)->isAnchored);
        QVERIFY(!findInstance(project(), 12)->isAnchored);
        QVERIFY(anchored.isChecked());
        select({11, 12});
        QVERIFY(!anchored.isChecked());
        select({10, 11});
        anchored.trigger();
        QVERIFY(!anchored.isChecked() && text() == before);
        stack().undo();
        QVERIFY(anchored.isChecked());
        stack().undo();
        QCOMPARE(text(), before);
        QCOMPARE(stack().count(), 2);
    }
    void assignedVariantsAreBakedAndShown() {
        select({10, 11, 12});
        QTest::keyClick(&viewport(), Qt::Key_V);
        QCOMPARE(findInstance(project(), 12)->variant, 2u);
        const Bakes& bakes = window().workspace().bakes();
        QTRY_VERIFY_WITH_TIMEOUT(bakes.areCurrent(project()), kPatience);
        QTRY_COMPARE(viewport().scene().batches.size(), std::size_t{3});
        QVERIFY(viewport().scene().batches[0].geometry != viewport().scene().batches[2].geometry);
    }
    void draggedAssetIsPlacedOnTheBoxBelow() {
        const Vec3 top = placeOf(10) + Vec3(0.5, 1.0, 0.0);
        drop(*viewport().pointOf(top));
        QCOMPARE(project().instances.size(), std::size_t{4});
        const Vec3 place = project().instances.back().pose.position;
        QVERIFY(std::abs(place.y - 1.0) < 1e-9);
        QVERIFY(glm::distance(place, Vec3(0.0, 1.0, 0.0)) < 0.05);  // the middle over the point, up to a pixel
        QVERIFY(window().workspace().selection().instances().contains(project().instances.back().id));
    }
    void clicksPlaceInstancesUntilEscape() {
        startPlacing();
        const QPoint top = viewport().pointOf(placeOf(10) + Vec3(0.5, 1.0, 0.0))->toPoint();
        moveTo(top);
        QVERIFY(!placing().preview().empty());  // the outline of the next instance
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, top);
        QCOMPARE(project().instances.size(), std::size_t{4});
        QVERIFY(std::abs(project().instances.back().pose.position.y - 1.0) < 1e-9);
        const QPoint ground = viewport().pointOf(Vec3(1.0, 0.0, 2.0))->toPoint();
        moveTo(ground, Qt::ControlModifier);
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ControlModifier, ground);
        const Vec3 place = project().instances.back().pose.position;
        QCOMPARE(place.y, 0.0);
        QCOMPARE(place, Vec3(0.1 * std::round(10.0 * place.x), 0.0, 0.1 * std::round(10.0 * place.z)));
        QCOMPARE(stack().count(), 2);  // one step each
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(!placing().isPlacing() && placing().preview().empty());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, top);
        QCOMPARE(project().instances.size(), std::size_t{5});
        stack().undo();
        stack().undo();
        QCOMPARE(text(), m_before);
    }
    void placedInstanceIsRotatedAndRightButtonEndsPlacing() {
        startPlacing();
        for (int k = 0; k < 3; ++k) QTest::keyClick(&viewport(), Qt::Key_R);
        QTest::keyClick(&viewport(), Qt::Key_R, Qt::ShiftModifier);
        const QPoint ground = viewport().pointOf(Vec3(1.0, 0.0, 2.0))->toPoint();
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, ground);
        const Quat turn = project().instances.back().pose.orientation;
        QVERIFY(std::abs(glm::degrees(2.0 * std::atan2(turn.y, turn.w)) - 30.0) < 1e-9);
        QTest::mouseClick(&viewport(), Qt::RightButton, {}, ground);
        QVERIFY(!placing().isPlacing());
        QCOMPARE(stack().count(), 1);
    }
    void clickIntoTheVoidPlacesNothing() {
        Project floating = threeBoxes();
        floating.ground.isOn = false;
        window().workspace().document().replace(floating);
        startPlacing();
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(3, 3));
        QCOMPARE(project().instances.size(), std::size_t{3});
        QVERIFY(placing().isPlacing());
        window().workspace().document().replace(Project());  // there is no asset to place
        QVERIFY(!placing().isPlacing());
    }
    void gridArrayIsOneStep() {
        test::onNextDialog<GridArrayDialog>([](GridArrayDialog& dialog) {
            QCOMPARE(dialog.array().steps, Vec3(1.0, 1.0, 0.5));  // side by side
            const QList<NumberField*> fields = dialog.findChildren<NumberField*>();
            QCOMPARE(fields.size(), 6);  // a count and a spacing for each axis
            fields[0]->setValue(2);
            fields[4]->setValue(3);
            fields[5]->setValue(1.5);
            QTest::keyClick(&dialog, Qt::Key_Return);
        });
        action("instance-grid-array")->trigger();
        QCOMPARE(project().instances.size(), std::size_t{3 + 5});
        std::set<std::uint32_t> variants;
        for (std::size_t k = 3; k < 8; ++k) {
            variants.insert(project().instances[k].variant);
            const Vec3 place = project().instances[k].pose.position;
            QVERIFY((place.x == 2.0 || place.x == 3.0) && (place.z == 0.0 || place.z == 1.5 || place.z == 3.0));
        }
        QCOMPARE(variants.size(), std::size_t{5});
        QCOMPARE(stack().count(), 1);
        stack().undo();
        QCOMPARE(text(), m_before);
    }
    void radialArrayCopiesWithoutVariants() {
        test::onNextDialog<RingArrayDialog>([](RingArrayDialog& dialog) {
            auto& count = *dialog.findChild<NumberField*>();
            count.selectAll();
            QTest::keyClicks(&count, "4");
            QVERIFY(count.commit());
            QVERIFY(std::abs(glm::degrees(dialog.array().angle) - 90.0) < 1e-9);  // a full circle
            dialog.findChild<QCheckBox*>()->setChecked(false);
            QTest::keyClick(&dialog, Qt::Key_Return);
        });
        action("instance-radial-array")->trigger();
        QCOMPARE(project().instances.size(), std::size_t{3 + 3});
        QVERIFY(glm::distance(project().instances[4].pose.position, Vec3(-2.0, 0.0, 0.0)) < 1e-9);
        for (const Instance& instance : project().instances) QCOMPARE(instance.variant, 0u);
        QCOMPARE(stack().count(), 1);
    }
    void cancelledArrayCopiesNothing() {
        test::onNextDialog<GridArrayDialog>([](GridArrayDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
        action("instance-grid-array")->trigger();
        QCOMPARE(text(), m_before);
        QCOMPARE(stack().count(), 0);
    }
    void overlapIsReportedWithItsInstances() {
        Instance moved = *findInstance(project(), 11);
        moved.pose.position.x = 0.75;
        window().workspace().document().push(modify("Move", moved));
        const std::vector<Message>& list = window().views().messages().list();
        const auto reported = [&] {
            return std::ranges::find(list, QString("\"box 1\" and \"box 2\" overlap by 0.25 m."), &Message::text);
        };
        QTRY_VERIFY_WITH_TIMEOUT(reported() != list.end(), kPatience);
        QVERIFY((reported()->instances == std::vector<Id>{10, 11}));
        stack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(reported() == list.end(), kPatience);
    }

private:
    PlacementTool& placing() { return window().views().scene().placementTool(); }
    void startPlacing() {
        QTest::keyClick(&viewport(), Qt::Key_A, Qt::ShiftModifier);
        QVERIFY(placing().isPlacing());
    }
    TransformTool& gizmo() { return window().views().scene().transformTool(); }
    Vec3 placeOf(Id id) { return findInstance(project(), id)->pose.position; }
    void select(std::set<Id> instances) {
        window().workspace().selection().setSeeds({});
        window().workspace().selection().setInstances(project(), std::move(instances));
    }
    bool isMarkedHidden(Id instance) {
        const RenderScene& scene = viewport().scene();
        for (std::size_t k = 0; k < scene.picks.size(); ++k) {
            if (scene.picks[k].instance == instance) return (scene.appearances[k].marks & kHidden) != 0;
        }
        return true;
    }

    /// A pixel on a handle: near the end of its line, or at one of its points.
    QPoint gripOf(GizmoHandle handle, int point = -1) {
        const std::vector<Vec2> line = handleLine(handle, *gizmo().gizmoView());
        const Vec2 grip = point < 0 ? 0.1 * line.front() + 0.9 * line.back() : line[static_cast<std::size_t>(point)];
        return {static_cast<int>(grip.x), static_cast<int>(grip.y)};
    }
    void press(QPoint at) {
        moveTo(at);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at);
        QVERIFY(gizmo().isDragging());
    }
    void moveTo(QPoint at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButtons buttons = Qt::NoButton) {
        EditorStory::moveTo(viewport(), at, modifiers, buttons);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers) {
        EditorStory::drag(viewport(), from, to, modifiers);
    }
    void drop(QPointF at) {
        const std::unique_ptr<QMimeData> data(mimeDataOf(2));
        QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(at, Qt::CopyAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport(), &event);
    }
};

RUBBLE_TEST_WITH(InstanceStoryTest, QApplication)
#include "InstanceStoryTest.moc"
