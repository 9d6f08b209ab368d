#include "tests/support/TestProgram.h"
#include "viewport/widget/Gizmo.h"

#include <QTest>

#include <numbers>

using namespace rubble;

namespace {

GizmoView isometric(Vec3 middle = {0.0, 0.0, 0.0}) {
    return {alignedTo(Camera{.distance = 10.0}, StandardView::Isometric), {800, 600}, middle};
}

Vec2 seen(Vec3 point, const GizmoView& view) { return *pixelOf(view.camera, point, view.size); }
Ray rayTo(Vec3 point, const GizmoView& view) { return rayThrough(view.camera, seen(point, view), view.size); }

}  // namespace

class GizmoTest : public QObject {
    Q_OBJECT
private slots:
    void handlesAreHitWhereDrawn() {
        const GizmoView view = isometric({1.0, 2.0, -3.0});
        for (const GizmoMode mode : {GizmoMode::Move, GizmoMode::Rotate}) {
            for (const GizmoHandle handle : handlesOf(mode)) {
                const std::vector<Vec2> line = handleLine(handle, view);
                QVERIFY(!line.empty());
                Vec2 grip = isRotationHandle(handle) ? line[5] : line.back();  // away from other handles
                if (isPlaneHandle(handle)) grip = 0.5 * (line[0] + line[2]);
                if (handle == GizmoHandle::MoveInView) grip = seen(view.centre, view);
                QCOMPARE(handleAt(grip, mode, view), std::optional(handle));
            }
        }
        QVERIFY(!handleAt({5.0, 5.0}, GizmoMode::Move, view));
    }
    void screenSizeIsConstant() {
        GizmoView near = isometric(), far = isometric();
        far.camera.distance = 100.0;
        const auto length = [](const GizmoView& view) {
            const std::vector<Vec2> line = handleLine(GizmoHandle::MoveY, view);
            return glm::distance(line.front(), line.back());
        };
        QVERIFY(std::abs(length(near) / length(far) - 1.0) < 0.1);
    }
    void arrowTowardsTheEyeIsHidden() {
        GizmoView view = isometric();
        view.camera = alignedTo(view.camera, StandardView::Front);
        QVERIFY(handleLine(GizmoHandle::MoveZ, view).empty());
        QVERIFY(!handleLine(GizmoHandle::MoveX, view).empty());
        QVERIFY(handleLine(GizmoHandle::RotateY, view).empty());
    }
    void arrowsMoveAlongTheirAxis() {
        const GizmoView view = isometric({1.0, 1.0, 1.0});
        const Ray from = rayTo({1.5, 1.0, 1.0}, view), to = rayTo({2.25, 1.0, 1.0}, view);
        const auto moved = translation(GizmoHandle::MoveX, view, from, to);
        QVERIFY(moved && glm::distance(*moved, Vec3(0.75, 0.0, 0.0)) < 1e-9);
    }
    void squaresMoveInTheirPlane() {
        const GizmoView view = isometric({1.0, 1.0, 1.0});
        const Ray from = rayTo({1.5, 1.0, 1.5}, view), to = rayTo({0.5, 1.0, 2.0}, view);
        const auto moved = translation(GizmoHandle::MoveZx, view, from, to);
        QVERIFY(moved && glm::distance(*moved, Vec3(-1.0, 0.0, 0.5)) < 1e-9);
    }
    void ringsRotateWithThePointer() {
        const GizmoView view = isometric({1.0, 1.0, 1.0});
        const Ray from = rayTo({2.0, 1.0, 1.0}, view), to = rayTo({1.0, 1.0, 0.0}, view);  // x to -z: 90°
        const auto turned = rotationAngle(GizmoHandle::RotateY, view, from, to);
        QVERIFY(turned && std::abs(*turned - std::numbers::pi / 2.0) < 1e-9);
    }
    /// From right to top, half of that angle and back; the ring's axis points up, at right angles to the view.
    void edgeOnRingRotatesWithThePointerOnScreen() {
        GizmoView view = isometric();
        view.camera = alignedTo(view.camera, StandardView::Front);
        const Ray from = rayTo({1.0, 0.0, 0.0}, view);
        const auto turnedTo = [&](Vec3 point) {
            return rotationAngle(GizmoHandle::RotateY, view, from, rayTo(point, view)).value_or(0.0);
        };
        QCOMPARE_LT(std::abs(turnedTo({0.0, 1.0, 0.0}) - std::numbers::pi / 2.0), 1e-9);
        QCOMPARE_LT(std::abs(turnedTo({0.7, 0.7, 0.0}) - std::numbers::pi / 4.0), 1e-9);
        QCOMPARE_LT(std::abs(turnedTo({0.0, -1.0, 0.0}) + std::numbers::pi / 2.0), 1e-9);
    }
    void snapsToMultiples() {
        QCOMPARE(snapped(0.26, 0.1), 0.1 * 3);
        QCOMPARE(snapped(-22.0, 15.0), -15.0);
    }
};

RUBBLE_TEST(GizmoTest)
#include "GizmoTest.moc"
