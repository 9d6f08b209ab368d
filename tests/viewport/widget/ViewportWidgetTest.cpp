// Tests viewport/widget/ViewportWidget.cpp, viewport/widget/ViewportCanvas.cpp, viewport/widget/RenderThread.cpp and
// viewport/scene/BodiesWithin.cpp.
#include "core/asset/library/StarterProject.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EventLoop.h"
#include "tests/support/viewport/ShownPicture.h"
#include "tests/support/viewport/StarterScene.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/widget/ViewportWidget.h"

#include <QGuiApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <numbers>

using namespace rubble;

namespace {

constexpr QSize kWidgetSize(480, 360);
const QPoint kMiddle(240, 180), kCorner(5, 5);

/// Longer than the time after which changes are no motion, ms.
constexpr int kRest = 250;

/// The wall from the front at rest, in its own window, without animation.
std::unique_ptr<ViewportWidget> shownWall() {
    auto viewport = std::make_unique<ViewportWidget>();
    viewport->setCameraAnimation(false);
    viewport->resize(kWidgetSize);
    viewport->show();
    if (!QTest::qWaitForWindowExposed(viewport.get(), kPatience)) return nullptr;
    viewport->setScene(test::starterScene());
    viewport->alignTo(StandardView::Front);
    viewport->frameAll();
    viewport->setFocus();
    QTest::mouseMove(viewport.get(), kCorner);  // no fragment is under the pointer
    test::runTimersDueWithin(kRest);
    return viewport;
}

void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint from, QPoint to) {
    QTest::mousePress(&widget, button, modifiers, from);
    for (const QPoint point : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, point, widget.mapToGlobal(point), Qt::NoButton, button, modifiers);
        QCoreApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, button, modifiers, to);
}

void turnWheel(QWidget& widget, QPointF at, int eighths) {
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&widget, &event);
}

/// Runs the event loop until no frame has come while the window system and short timers were served twice.
void waitForTheLastOf(const QSignalSpy& frames) {
    for (qsizetype quiet = 0, last = -1; quiet < 2; last = frames.count()) {
        QGuiApplication::sync();
        test::runTimersDueWithin(50);
        quiet = frames.count() == last ? quiet + 1 : 0;
    }
}

/// The saturation of a pixel: the background is grey.
int colourfulness(const QImage& picture, QPoint at) {
    const QColor colour = picture.pixelColor(at);
    return std::max({colour.red(), colour.green(), colour.blue()}) -
           std::min({colour.red(), colour.green(), colour.blue()});
}

}  // namespace

class ViewportWidgetTest : public QObject {
    Q_OBJECT
private slots:
    void firstSceneIsFramed() {
        ViewportWidget viewport;
        viewport.resize(kWidgetSize);
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport, kPatience));
        QCOMPARE(viewport.errorText(), QString());
        viewport.setScene(std::make_shared<RenderScene>());
        const Camera before = viewport.camera();
        viewport.setScene(test::starterScene());
        QVERIFY(glm::length(viewport.camera().target - boundsOf(viewport.scene()).centre()) < 1e-9);
        QVERIFY(viewport.camera().distance != before.distance);
        const Camera framed = viewport.camera();
        viewport.setScene(test::starterScene({.selected = {{2, 0, 3}}}));
        QVERIFY(viewport.camera() == framed);
    }
    void middleButtonOrbitsPansAndZooms() {
        const auto viewport = shownWall();
        const Camera front = viewport->camera();
        drag(*viewport, Qt::MiddleButton, {}, kMiddle, kMiddle + QPoint(-90, 45));
        QVERIFY(std::abs(viewport->camera().azimuth - std::numbers::pi / 4.0) < 1e-12);
        QVERIFY(std::abs(viewport->camera().elevation - std::numbers::pi / 8.0) < 1e-12);
        QVERIFY(viewport->camera().target == front.target);
        viewport->setCamera(front);
        drag(*viewport, Qt::MiddleButton, Qt::ShiftModifier, kMiddle, kMiddle + QPoint(50, 0));
        const double metres = 50.0 * metresPerPixel(front, {kWidgetSize.width(), kWidgetSize.height()});
        QVERIFY(std::abs(viewport->camera().target.x - (front.target.x - metres)) < 1e-12);
        viewport->setCamera(front);
        drag(*viewport, Qt::MiddleButton, Qt::ControlModifier, kMiddle, kMiddle + QPoint(0, -50));
        QVERIFY(viewport->camera().distance < front.distance);
    }
    void leftButtonNavigatesInMayaStyleOnly() {
        const auto viewport = shownWall();
        const Camera front = viewport->camera();
        QSignalSpy picks(viewport.get(), &ViewportWidget::picked);
        drag(*viewport, Qt::LeftButton, {}, kMiddle, kMiddle + QPoint(60, 0));
        QVERIFY(viewport->camera() == front);
        QCOMPARE(picks.count(), 0);
        viewport->setNavigation(NavigationStyle::Maya);
        drag(*viewport, Qt::LeftButton, Qt::AltModifier, kMiddle, kMiddle + QPoint(60, 0));
        QVERIFY(viewport->camera().azimuth < 0.0);
    }
    void wheelZoomsTowardsThePointer() {
        const auto viewport = shownWall();
        const Camera front = viewport->camera();
        turnWheel(*viewport, QPointF(360.0, 180.0), 120);
        QVERIFY(std::abs(viewport->camera().distance * 1.2 - front.distance) < 1e-12);
        QVERIFY(viewport->camera().target.x > front.target.x);
        QVERIFY(std::abs(viewport->camera().target.y - front.target.y) < 1e-12);
    }
    void keysAlignViewsAndToggleProjection() {
        const auto viewport = shownWall();
        QTest::keyClick(viewport.get(), Qt::Key_3);
        QCOMPARE(viewport->camera().azimuth, std::numbers::pi / 2.0);
        QTest::keyClick(viewport.get(), Qt::Key_7, Qt::ControlModifier | Qt::KeypadModifier);
        QCOMPARE(viewport->camera().elevation, -std::numbers::pi / 2.0);
        QTest::keyClick(viewport.get(), Qt::Key_5);
        QVERIFY(viewport->camera().projection == Projection::Orthographic);
        QTest::keyClick(viewport.get(), Qt::Key_Right);
        QVERIFY(std::abs(viewport->camera().azimuth - std::numbers::pi / 12.0) < 1e-12);
    }
    void fFramesSelectionAndHomeFramesAll() {
        const auto viewport = shownWall();
        const Camera all = viewport->camera();
        viewport->setScene(test::starterScene({.selected = {viewport->scene().picks[4]}}));
        QTest::keyClick(viewport.get(), Qt::Key_F);
        QVERIFY(viewport->camera().distance < all.distance);
        QVERIFY(glm::length(viewport->camera().target - boundsOf(viewport->scene(), kSelected).centre()) < 1e-9);
        QTest::keyClick(viewport.get(), Qt::Key_Home);
        QVERIFY(glm::length(viewport->camera().target - all.target) < 1e-9);
    }
    void clickPicksTheBody() {
        const auto viewport = shownWall();
        QSignalSpy picks(viewport.get(), &ViewportWidget::picked);
        QTest::mouseClick(viewport.get(), Qt::LeftButton, Qt::ShiftModifier, kMiddle);
        QTest::mouseClick(viewport.get(), Qt::LeftButton, {}, kCorner);
        QCOMPARE(picks.count(), 2);
        const auto pick = picks[0][0].value<std::optional<PickId>>();
        QVERIFY(pick && pick->asset == starterProject().assets[0].id && pick->fragment < 20);
        QCOMPARE(picks[0][1].value<Qt::KeyboardModifiers>(), Qt::ShiftModifier);
        QVERIFY(!picks[1][0].value<std::optional<PickId>>());
    }
    void hoveredBodyIsBrighter() {
        const auto viewport = shownWall();
        QTest::mouseMove(viewport.get(), kCorner);
        QSignalSpy hovers(viewport.get(), &ViewportWidget::hovered);
        const QImage before = test::shownPicture(*viewport);
        QTest::mouseMove(viewport.get(), kMiddle);
        QTRY_COMPARE(hovers.count(), 1);
        QVERIFY(test::shownPicture(*viewport).pixelColor(kMiddle) != before.pixelColor(kMiddle));
        QTest::mouseMove(viewport.get(), kCorner);
        QTRY_COMPARE(hovers.count(), 2);
        QCOMPARE(test::shownPicture(*viewport).pixelColor(kMiddle), before.pixelColor(kMiddle));
    }
    void drawsTheWallAndItsSelection() {
        const auto viewport = shownWall();
        const QImage before = test::shownPicture(*viewport);
        QVERIFY(before.pixelColor(kMiddle) != before.pixelColor(kMiddle.x(), 2));
        const auto pick = viewport->scene().picks;
        viewport->setScene(test::starterScene({.selected = {{pick[0].asset, 0, kNone}}}));
        const QImage after = test::shownPicture(*viewport);
        QCOMPARE(after.pixelColor(kMiddle), before.pixelColor(kMiddle));
        int most = 0;  // on the way down across the upper edge
        for (int y = 0; y < kMiddle.y(); ++y) most = std::max(most, colourfulness(after, {kMiddle.x(), y}));
        QVERIFY2(most > 150, qPrintable(QString::number(most)));
    }
    void repaintsOnlyAfterChanges() {
        const auto viewport = shownWall();
        QSignalSpy frames(viewport.get(), &ViewportWidget::drawn);
        QTRY_VERIFY(viewport->isPictureFinished());
        waitForTheLastOf(frames);  // of showing the window
        frames.clear();
        test::runTimersDueWithin(300);
        viewport->setCamera(viewport->camera());
        test::runTimersDueWithin(100);
        QCOMPARE(frames.count(), 0);
        viewport->setCamera(orbited(viewport->camera(), 0.1, 0.0));
        QTRY_COMPARE(frames.count(), 1);
    }
    void animationReachesTheViewExactly() {
        const auto viewport = shownWall();
        viewport->setCameraAnimation(true);
        QSignalSpy frames(viewport.get(), &ViewportWidget::drawn);
        viewport->alignTo(StandardView::Top);
        QVERIFY(viewport->camera() == alignedTo(viewport->camera(), StandardView::Top));
        QTRY_VERIFY(frames.count() >= 3);
        const QPoint top(kMiddle);
        QSignalSpy picks(viewport.get(), &ViewportWidget::picked);
        QTRY_VERIFY(viewport->shownCamera() == viewport->camera());
        QTest::mouseClick(viewport.get(), Qt::LeftButton, {}, top);
        QVERIFY(picks[0][0].value<std::optional<PickId>>());
    }
    void boxSelectsBodiesByTheirCentres() {
        const auto viewport = shownWall();
        QSignalSpy boxes(viewport.get(), &ViewportWidget::boxSelected), picks(viewport.get(), &ViewportWidget::picked);
        drag(*viewport, Qt::LeftButton, Qt::ShiftModifier, {2, 2}, {478, 358});
        QCOMPARE(boxes.count(), 1);
        QCOMPARE(boxes[0][0].value<std::vector<PickId>>(), viewport->scene().picks);
        QCOMPARE(boxes[0][1].value<Qt::KeyboardModifiers>(), Qt::ShiftModifier);
        drag(*viewport, Qt::LeftButton, {}, {2, 2}, kMiddle);
        const auto upperLeft = boxes[1][0].value<std::vector<PickId>>();
        QVERIFY(!upperLeft.empty() && upperLeft.size() < viewport->scene().picks.size() / 2);
        const Vec3 centre = boundsOf(viewport->scene()).centre();
        RenderScene only = viewport->scene();
        for (BodyAppearance& look : only.appearances) look.marks = 0;
        setMarks(only, {.selected = upperLeft});
        const Vec3 middle = boundsOf(only, kSelected).centre();
        QVERIFY(middle.x < centre.x && middle.y > centre.y);
        drag(*viewport, Qt::LeftButton, {}, {2, 2}, {20, 20});
        QVERIFY(boxes[2][0].value<std::vector<PickId>>().empty());
        QCOMPARE(picks.count(), 0);
    }
    void escapeCancelsBoxSelection() {
        const auto viewport = shownWall();
        QSignalSpy boxes(viewport.get(), &ViewportWidget::boxSelected);
        QTest::mousePress(viewport.get(), Qt::LeftButton, {}, kCorner);
        QMouseEvent move(QEvent::MouseMove, QPointF(kMiddle), viewport->mapToGlobal(QPointF(kMiddle)), Qt::NoButton,
                         Qt::LeftButton, {});
        QCoreApplication::sendEvent(viewport.get(), &move);
        QTest::keyClick(viewport.get(), Qt::Key_Escape);
        QTest::mouseRelease(viewport.get(), Qt::LeftButton, {}, kMiddle);
        QCOMPARE(boxes.count(), 0);
    }
    void progressiveRenderingEnds() {
        const auto viewport = shownWall();
        viewport->resize(160, 120);
        const QImage before = test::shownPicture(*viewport);
        viewport->setProgressiveRendering(ProgressiveRendering::Always);
        const QImage refined = test::finishedPicture(*viewport);
        QSignalSpy frames(viewport.get(), &ViewportWidget::drawn);
        test::runTimersDueWithin(300);
        QCOMPARE(frames.count(), 0);
        QVERIFY(refined != before);
    }
    void pictureIsRefinedToItsQuality() {
        const auto viewport = shownWall();
        viewport->resize(160, 120);
        viewport->setProgressiveRendering(ProgressiveRendering::Always);
        const QImage good = test::finishedPicture(*viewport);
        viewport->setQuality(RenderQuality::Draft);
        const QImage draft = test::finishedPicture(*viewport);
        viewport->setQuality(RenderQuality::Best);
        const QImage best = test::finishedPicture(*viewport);
        QVERIFY(draft != good && best != good && best != draft);
        viewport->setProgressiveRendering(ProgressiveRendering::Never);
        QCOMPARE(test::finishedPicture(*viewport), draft);
    }
    void hoveringKeepsTheRefinedPicture() {
        const auto viewport = shownWall();
        viewport->resize(160, 120);
        viewport->setProgressiveRendering(ProgressiveRendering::Always);
        const QImage refined = test::finishedPicture(*viewport);
        QSignalSpy hovers(viewport.get(), &ViewportWidget::hovered);
        QTest::mouseMove(viewport.get(), {80, 60});
        QTRY_COMPARE(hovers.count(), 1);
        QVERIFY(test::shownPicture(*viewport) != refined);
        QVERIFY(viewport->isPictureFinished());
        QTest::mouseMove(viewport.get(), kCorner);
        QTRY_COMPARE(hovers.count(), 2);
        QCOMPARE(test::shownPicture(*viewport), refined);
        QVERIFY(viewport->isPictureFinished());
    }
    void pictureIsSharpAfterAMotion() {
        const auto viewport = shownWall();
        const Camera end = orbited(viewport->camera(), 0.3, 0.2);
        viewport->setCamera(end);
        const QImage sharp = test::shownPicture(*viewport);
        QSignalSpy frames(viewport.get(), &ViewportWidget::drawn);
        for (int image = 1; image <= 30; ++image) {
            const qsizetype before = frames.count();
            viewport->setCamera(image < 30 ? orbited(end, 0.01 * image, 0.0) : end);
            QTRY_VERIFY(frames.count() > before);
        }
        QCOMPARE(test::finishedPicture(*viewport), sharp);
    }
    void resizedViewIsDrawnAnew() {
        const auto viewport = shownWall();
        viewport->resize(160, 120);
        viewport->setProgressiveRendering(ProgressiveRendering::Always);
        const QImage before = test::finishedPicture(*viewport);
        viewport->resize(200, 120);
        const QImage resized = test::finishedPicture(*viewport);
        QCOMPARE(resized.size(), QSize(200, 120));
        QVERIFY(resized.pixelColor(100, 60) != resized.pixelColor(100, 2));
        viewport->resize(160, 120);
        QCOMPARE(test::finishedPicture(*viewport), before);
    }
    void survivesAMoveToAnotherWindow() {
        auto viewport = shownWall();
        QWidget other;
        auto* layout = new QVBoxLayout(&other);
        layout->addWidget(viewport.release());
        other.resize(600, 500);
        other.show();
        QVERIFY(QTest::qWaitForWindowExposed(&other, kPatience));
        auto* moved = other.findChild<ViewportWidget*>();
        moved->frameAll();
        const QImage picture = test::shownPicture(*moved);
        const QPoint middle = moved->rect().center();
        QVERIFY(picture.pixelColor(middle) != picture.pixelColor(middle.x(), 2));
    }
};

RUBBLE_TEST_WITH(ViewportWidgetTest, QApplication)
#include "ViewportWidgetTest.moc"
