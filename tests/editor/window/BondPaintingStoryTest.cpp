// Tests editor/view3d/tools/BondPaintTool.cpp and the brushes for bonds of editor/actions/ViewActions.cpp in the
// window: a wall is painted, saved and loaded.
#include "core/asset/library/StarterProject.h"
#include "core/structure/capacity/BondCapacities.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QToolBar>

using namespace rubble;

/// A wall that is made to break as bonded and painted, by mouse and keys.
class BondPaintingStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(starterProject());
        selection().setAsset(wall().id);
    }
    void cleanupTestCase() { close(); }

    void brushesAreOffWhereTheAssetBreaksWhole() {
        for (const char* name : {"tool-anchor", "tool-strength", "tool-never-breaks", "canvas-bond-strengths"}) {
            QVERIFY2(!action(name)->isEnabled(), name);
            QVERIFY2(action(name)->toolTip().contains("breaks whole"), name);
        }
        QVERIFY(!window().findChild<QToolBar*>("bar-bonds")->isVisible());
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_A, Qt::AltModifier | Qt::ShiftModifier);
        QCOMPARE(canvas().toolKind(), CanvasToolKind::Seeds);
    }
    void brushesAreOnWhereItBreaksAsBonded() {
        makeBonded();
        for (const char* name : {"tool-anchor", "tool-strength", "tool-never-breaks", "canvas-bond-strengths"}) {
            QVERIFY2(action(name)->isEnabled(), name);
            QVERIFY2(!action(name)->toolTip().contains("breaks whole"), name);
        }
        QVERIFY(window().findChild<QToolBar*>("bar-bonds")->isVisible());
    }
    void aStrokeAlongTheGroundAnchorsTheWall() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_A, Qt::AltModifier | Qt::ShiftModifier);
        QCOMPARE(canvas().toolKind(), CanvasToolKind::AnchorBrush);
        QVERIFY(action("tool-anchor")->isChecked());
        const Box2 box = boundsOf(wall().prism().outline.outer);
        drag(canvas(), pixels(box.min), pixels({box.max.x, box.min.y}));
        QCOMPARE(wall().bonding.strokes.size(), std::size_t{1});
        QVERIFY(anchored() > 1);
        QVERIFY(anchored() < bake().fractures[0].fragments.count());
    }
    void shiftErasesAPart() {
        const std::size_t before = anchored();
        const Box2 box = boundsOf(wall().prism().outline.outer);
        QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::ShiftModifier, pixels(box.min));
        QCOMPARE(wall().bonding.strokes.size(), std::size_t{2});
        QVERIFY(anchored() < before);
    }
    void strengthAndNeverBreaksArePaintedToo() {
        const Vec2 centre = centreOf();
        QTest::keyClick(&canvas(), Qt::Key_S, Qt::AltModifier | Qt::ShiftModifier);
        QTest::keyClick(&canvas(), Qt::Key_Period);
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels(centre));
        QCOMPARE(strengthAt(wall(), centre), 3.0);
        QTest::keyClick(&canvas(), Qt::Key_N, Qt::AltModifier | Qt::ShiftModifier);
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels(centre));
        const std::vector<bool> unbreakable = neverBreaking(wall(), bake(), 0);
        QVERIFY(std::ranges::find(unbreakable, true) != unbreakable.end());
        QCOMPARE(stack().undoText(), QString("Paint Never Breaks"));
    }
    void theOverlayShowsStrengths() {
        action("canvas-bond-strengths")->trigger();
        QVERIFY(canvas().overlays().hasBondStrengths);
        action("canvas-bond-strengths")->trigger();
        QVERIFY(!canvas().overlays().hasBondStrengths);
    }
    void savedStrokesAreLoaded() {
        const std::filesystem::path file = pathOf("painted.rubble").toStdString();
        QVERIFY(saveProject(file, project()));
        const Result<Project> loaded = loadProject(file);
        QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
        QCOMPARE(loaded->assets[0].bonding.strokes.size(), std::size_t{4});
        QVERIFY(loaded->assets == project().assets);
    }
    void undoAndRedoAreOfStrokes() {
        const std::string painted = text();
        for (std::size_t count = 4; count-- > 0;) {
            stack().undo();
            QCOMPARE(wall().bonding.strokes.size(), count);
        }
        stack().undo();
        QCOMPARE(text(), m_before);
        QCOMPARE(canvas().toolKind(), CanvasToolKind::Seeds);  // its brushes are off
        while (stack().canRedo()) stack().redo();
        QCOMPARE(text(), painted);
    }
    void inThe3dViewTheSamePlaneIsPainted() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        QTest::keyClick(&canvas(), Qt::Key_A, Qt::AltModifier | Qt::ShiftModifier);
        QVERIFY(painter().isOn());
        showOneWall();
        const std::size_t before = wall().bonding.strokes.size();
        const Vec2 from = centreOf() - Vec2(0.2, 0.0), to = centreOf() + Vec2(0.2, 0.1);
        for (const double z : {wall().prism().depth / 2.0, -wall().prism().depth / 2.0}) {
            viewport().setCameraAnimation(false);
            QTest::keyClick(&viewport(), Qt::Key_1, z > 0.0 ? Qt::NoModifier : Qt::ControlModifier);
            drag(viewport(), onScreen(from, z), onScreen(to, z));
            QVERIFY(wall().bonding.strokes.size() > before);
            const BondStroke& stroke = wall().bonding.strokes.back();
            QCOMPARE(stroke.points.size(), std::size_t{2});
            QVERIFY2(isNear(stroke.points.front(), from) && isNear(stroke.points.back(), to),
                     z > 0.0 ? "front" : "back");
            QCOMPARE(stroke.brush, BondBrush::Anchor);
        }
        QCOMPARE(wall().bonding.strokes.size(), before + 2);
        stack().undo();
        stack().undo();
        QCOMPARE(wall().bonding.strokes.size(), before);
    }
    void aStrokeIsTheSameEditInBothViews() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        QTest::keyClick(&viewport(), Qt::Key_1);
        const double z = wall().prism().depth / 2.0;
        const Vec2 from = centreOf() - Vec2(0.2, 0.1), to = centreOf() + Vec2(0.2, 0.1);
        const PaintedStroke inCanvas = painted(canvas(), pixels(from), pixels(to));
        // The size is shared in pixels: the same radius in metres is another number of them here. The wall is rotated
        // about the vertical, along which lengths are as they are.
        const QPoint start = onScreen(from, z), above = onScreen(from + Vec2(0.0, 0.2), z);
        painter().setRadiusPixels(inCanvas.stroke.radius * QLineF(start, above).length() / 0.2);
        const PaintedStroke inScene = painted(viewport(), start, onScreen(to, z));
        QCOMPARE(inCanvas.text, inScene.text);
        QCOMPARE(inCanvas.anchored, inScene.anchored);
        QVERIFY(inCanvas.anchored.size() > 1);
        const BondStroke &one = inCanvas.stroke, &other = inScene.stroke;
        QVERIFY2(std::abs(one.radius / other.radius - 1.0) < 0.05, qPrintable(QString::number(other.radius)));
        QCOMPARE(other.points.size(), std::size_t{2});
        QVERIFY(isNear(one.points.front(), other.points.front()) && isNear(one.points.back(), other.points.back()));
        BondStroke same = other;
        same.radius = one.radius;
        same.points = one.points;
        QCOMPARE(same, one);
    }
    /// Its material would show through: the marks are on the faces that the eye sees.
    void marksDoNotShowThroughTheAsset() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        const std::array shown{instance().id};
        const auto marked = [&] {
            QCoreApplication::processEvents();
            const QImage picture = test::shownPicture(viewport());
            int count = 0;
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) count += picture.pixelColor(x, y) == QColor(63, 214, 228);
            }
            return count;
        };
        for (int keep = 1; keep < static_cast<int>(project().instances.size()); ++keep) {
            Instance hidden = project().instances[static_cast<std::size_t>(keep)];
            hidden.isHidden = true;
            window().workspace().document().push(modify("Hide", std::move(hidden)));
        }
        Instance straight = instance();
        straight.pose.orientation = Quat(1.0, 0.0, 0.0, 0.0);
        window().workspace().document().push(modify("Rotate", std::move(straight)));
        window().views().scene().frameInstances(shown);
        QEvent leave(QEvent::Leave);  // the ring of the brush has the same colour
        QApplication::sendEvent(&viewport(), &leave);
        QVERIFY(anchored() > 0);
        for (const Qt::KeyboardModifiers side : {Qt::NoModifier, Qt::ControlModifier}) {
            QTest::keyClick(&viewport(), Qt::Key_1, side);  // front and back
            QVERIFY(marked() > 0);
            QTest::keyClick(&viewport(), Qt::Key_3, side);  // in the plane of the wall
            QCOMPARE(marked(), 0);
        }
    }
    void escapeCancelsAStrokeInThe3dView() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        const std::string before = text();
        const QPoint at = onScreen(centreOf(), wall().prism().depth / 2.0);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at);
        moveTo(viewport(), at + QPoint(30, 0), {}, Qt::LeftButton);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(text(), before);
        QVERIFY(painter().isOn());
    }
    void bothViewsShareTheSettings() {
        QTest::keyClick(&viewport(), Qt::Key_X);
        QVERIFY(painter().settings().isErasing);
        QTest::keyClick(&canvas(), Qt::Key_X);
        QVERIFY(!painter().settings().isErasing);
        const double radius = painter().radiusPixels();
        QTest::keyClick(&viewport(), Qt::Key_BracketRight);
        QVERIFY(painter().radiusPixels() > radius);
        QTest::keyClick(&canvas(), Qt::Key_BracketLeft);
        QCOMPARE(painter().radiusPixels(), radius);
        QTest::keyClick(&canvas(), Qt::Key_Q, Qt::AltModifier);
        QVERIFY(!painter().isOn());
    }

private:
    const Asset& wall() { return project().assets[0]; }
    const Bake& bake() { return *window().workspace().bakes().find(wall().id)->bake; }
    std::size_t anchored() { return anchoredFragments(wall(), bake(), 0).size(); }
    Vec2 centreOf() {
        const Box2 box = boundsOf(wall().prism().outline.outer);
        return canvas().view().metres(pixels((box.min + box.max) / 2.0));
    }
    BondPainter& painter() { return window().workspace().bondPainter(); }
    const Instance& instance() { return *std::ranges::find(project().instances, wall().id, &Instance::asset); }
    struct PaintedStroke {
        BondStroke stroke;
        std::vector<std::uint32_t> anchored;
        QString text;  // of the edit
    };
    /// What a stroke in a view does, which is undone again.
    PaintedStroke painted(QWidget& view, QPoint from, QPoint to) {
        drag(view, from, to);
        const PaintedStroke result{wall().bonding.strokes.back(), anchoredFragments(wall(), bake(), 0),
                                   stack().undoText()};
        stack().undo();
        return result;
    }
    /// Frames one wall, rotated about the vertical.
    void showOneWall() {
        Instance rotated = instance();
        rotated.pose.orientation = glm::angleAxis(0.5, Vec3(0.0, 1.0, 0.0));
        window().workspace().document().push(modify("Rotate", std::move(rotated)));
        const std::array shown{instance().id};
        window().views().scene().frameInstances(shown);
        const Quat expected = instance().pose.orientation;
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(viewport().scene().poses[0].orientation.y - expected.y) < 1e-3, kPatience);
    }
    /// A point of the prism at a depth, in the 3D view.
    QPoint onScreen(Vec2 point, double z) {
        const Pose& pose = instance().pose;
        return viewport().pointOf(pose.position + pose.orientation * Vec3(point, z))->toPoint();
    }
    /// Within about a pixel.
    static bool isNear(Vec2 a, Vec2 b) { return glm::length(a - b) < 0.01; }
    void makeBonded() {
        Asset asset = wall();
        asset.breakAs = BreakAs::Bonded;
        window().workspace().document().push(modify("Set How It Breaks", std::move(asset)));
    }
};

RUBBLE_TEST_WITH(BondPaintingStoryTest, QApplication)
#include "BondPaintingStoryTest.moc"
