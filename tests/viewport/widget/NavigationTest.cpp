#include "tests/support/TestProgram.h"
#include "viewport/widget/Navigation.h"

#include <QTest>

#include <numbers>

using namespace rubble;

namespace {

constexpr ImageSize kWindowSize{400, 300};
constexpr auto kBlender = NavigationStyle::Blender, kMaya = NavigationStyle::Maya;

std::optional<StandardView> viewOf(int key, Qt::KeyboardModifiers modifiers = {}) {
    return viewKeyOf(kBlender, key, modifiers).value_or(ViewKey{}).view;
}

}  // namespace

class NavigationTest : public QObject {
    Q_OBJECT
private slots:
    void dragsFollowBlender() {
        QCOMPARE(dragOf(kBlender, Qt::MiddleButton, {}), Drag::Orbit);
        QCOMPARE(dragOf(kBlender, Qt::MiddleButton, Qt::ShiftModifier), Drag::Pan);
        QCOMPARE(dragOf(kBlender, Qt::MiddleButton, Qt::ControlModifier), Drag::Zoom);
        QCOMPARE(dragOf(kBlender, Qt::LeftButton, Qt::AltModifier), Drag::Orbit);
        QVERIFY(!dragOf(kBlender, Qt::LeftButton, {}));
        QVERIFY(!dragOf(kBlender, Qt::RightButton, Qt::AltModifier));
    }
    void dragsFollowMaya() {
        QCOMPARE(dragOf(kMaya, Qt::LeftButton, Qt::AltModifier), Drag::Orbit);
        QCOMPARE(dragOf(kMaya, Qt::MiddleButton, Qt::AltModifier), Drag::Pan);
        QCOMPARE(dragOf(kMaya, Qt::RightButton, Qt::AltModifier), Drag::Zoom);
        QVERIFY(!dragOf(kMaya, Qt::MiddleButton, {}));
    }
    void orbitingFollowsThePointer() {
        const Camera camera = dragged({}, Drag::Orbit, {-150.0, 75.0}, kWindowSize);
        QCOMPARE(camera.azimuth, std::numbers::pi / 2.0);
        QCOMPARE(camera.elevation, std::numbers::pi / 4.0);
    }
    void draggingUpAndWheelForwardZoomIn() {
        QVERIFY(dragged({}, Drag::Zoom, {0.0, -30.0}, kWindowSize).distance < Camera{}.distance);
        QVERIFY(dragged({}, Drag::Zoom, {0.0, 30.0}, kWindowSize).distance > Camera{}.distance);
        QVERIFY(std::abs(wheelFactor(120.0) * 1.2 - 1.0) < 1e-15);
        QVERIFY(std::abs(wheelFactor(-240.0) - 1.44) < 1e-15);
    }
    void keysAlignToViewsAndWithCtrlToOpposites() {
        QCOMPARE(viewOf(Qt::Key_1), StandardView::Front);
        QCOMPARE(viewOf(Qt::Key_3), StandardView::Right);
        QCOMPARE(viewOf(Qt::Key_7), StandardView::Top);
        QCOMPARE(viewOf(Qt::Key_1, Qt::ControlModifier), StandardView::Back);
        QCOMPARE(viewOf(Qt::Key_3, Qt::ControlModifier | Qt::KeypadModifier), StandardView::Left);
        QCOMPARE(viewOf(Qt::Key_7, Qt::ControlModifier), StandardView::Bottom);
    }
    void ignoresOtherShortcuts() {
        QVERIFY(!viewKeyOf(kBlender, Qt::Key_F, Qt::ControlModifier));
        QVERIFY(!viewKeyOf(kBlender, Qt::Key_A, {}));
        QVERIFY(!viewKeyOf(kBlender, Qt::Key_Tab, {}));
        QVERIFY(!viewKeyOf(kBlender, Qt::Key_1, Qt::AltModifier));
        QVERIFY(!viewKeyOf(kBlender, Qt::Key_1, Qt::ControlModifier | Qt::ShiftModifier));
        QCOMPARE(viewKeyOf(kMaya, Qt::Key_A, {})->action, ViewAction::FrameAll);
    }
};

RUBBLE_TEST_WITH(NavigationTest, QCoreApplication)
#include "NavigationTest.moc"
