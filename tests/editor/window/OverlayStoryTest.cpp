// Tests the overlays of viewport/widget/ViewportWidget.cpp in a window, and presenting the scene without them.
#include "editor/view3d/PlayView.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>

#include <utility>

using namespace rubble;

namespace {

constexpr QSize kSmallScreen{1280, 720};

}  // namespace

/// The house in the 3D view and in play, on a small screen.
class OverlayStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/house.rubble", pathOf("house.rubble")));
        openFile(pathOf("house.rubble"));
        if (!hasView()) QSKIP("There is no OpenGL here.");
        Preferences still = preferences().preferences();
        still.isSmooth = false;
        preferences().setPreferences(still);
        play().thread().useSteppedClock();
        window().resize(kSmallScreen);
        QTRY_COMPARE(window().size(), kSmallScreen);
    }

    void legendKeepsClearOfTheScene() {
        window().views().scene().frameAll();
        QVERIFY(viewport().plates().empty());
        auto* colouring = window().findChild<QComboBox*>("colouring");
        colouring->setCurrentIndex(3);  // by volume
        QTRY_COMPARE_WITH_TIMEOUT(viewport().plates().size(), 1u, kPatience);
        QVERIFY2(areClear(), qPrintable(m_fault));
        colouring->setCurrentIndex(0);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().plates().empty(), kPatience);
    }
    /// The view was framed before: it follows the room that play leaves.
    void platesOfPlayKeepClearOfTheSceneAndOfEachOther() {
        QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        advance(2);
        QCOMPARE(viewport().plates().size(), 3u);  // the state, the hint, the scale bar
        QVERIFY2(areClear(), qPrintable(m_fault));
        action("play-statistics")->trigger();
        QVERIFY2(areClear(), qPrintable(m_fault));
        PlayOverlays overlays = play().overlays();
        overlays.hasHeat = true;
        play().setOverlays(overlays);
        advance(2);
        QCOMPARE(viewport().plates().size(), 4u);
        QVERIFY2(areClear(), qPrintable(m_fault));
        for (const QSize size : {QSize(1100, 720), QSize(1500, 860), kSmallScreen}) {
            window().resize(size);
            QTRY_COMPARE(window().size(), size);
            advance(1);
            QVERIFY2(areClear(), qPrintable(m_fault));
        }
    }
    void cameraThatWasMovedStays() {
        const Camera moved = orbited(viewport().camera(), 0.2, 0.0);
        viewport().setCamera(moved);
        action("play-statistics")->trigger();
        window().resize(1200, 700);
        QTRY_COMPARE(window().size(), QSize(1200, 700));
        advance(1);
        QVERIFY(viewport().camera() == moved);
        window().resize(kSmallScreen);
        QTRY_COMPARE(window().size(), kSmallScreen);
    }
    void presentingShowsTheSceneAlone() {
        QAction* present = action("view-present");
        const QImage before = picture();
        for (const Qt::Key end : {Qt::Key_F5, Qt::Key_Escape}) {
            QTest::keyClick(&viewport(), Qt::Key_F5);
            QVERIFY(present->isChecked() && viewport().plates().empty());
            QTRY_VERIFY(!header().isVisible());
            QVERIFY(test::meanDifference(before.copy(0, 0, 60, 30), picture().copy(0, 0, 60, 30)) > 5.0);
            QTest::keyClick(&viewport(), end);
            QVERIFY(!present->isChecked() && !viewport().plates().empty());
            QVERIFY(play().isInPlay());
            QTRY_VERIFY(header().isVisible());
            QTRY_VERIFY(picture().size() == before.size());
            QVERIFY(test::meanDifference(before, picture()) < 0.5);
        }
    }
    /// Neither contacts nor colours by heat, which are no part of the scene.
    void presentingHidesTheOverlaysOfPlay() {
        const auto seen = [&] {
            advance(1);
            return viewport().scene();
        };
        PlayOverlays overlays{.hasContacts = true, .hasBoxes = true, .hasBodies = true};
        play().setOverlays({});
        const RenderScene bare = seen();
        play().setOverlays(overlays);
        const RenderScene before = seen();
        QVERIFY(!before.boxes.empty() && before.appearances != bare.appearances);
        for (const auto& key : {QKeySequence("F5"), QKeySequence("Alt+Shift+Z")}) {
            QTest::keySequence(&viewport(), key);
            QVERIFY(!viewport().hasOverlays() && viewport().plates().empty());
            const RenderScene presented = seen();
            QVERIFY(presented.boxes.empty() && presented.appearances == bare.appearances);
            QTest::keySequence(&viewport(), key);
            QVERIFY(viewport().hasOverlays());
            QCOMPARE(seen().boxes.size(), before.boxes.size());
        }
        play().setOverlays({});
    }
    /// The layout of the window stays, and presenting keeps what was switched off.
    void overlaysAreSwitchedOffByAKey() {
        QTest::keySequence(&viewport(), QKeySequence("Alt+Shift+Z"));
        QVERIFY(!viewport().hasOverlays() && !viewport().isPresenting() && header().isVisible());
        QVERIFY(!action("view-overlays")->isChecked());
        QTest::keyClick(&viewport(), Qt::Key_F5);
        QTest::keyClick(&viewport(), Qt::Key_F5);
        QVERIFY(!viewport().hasOverlays());
        QTest::keySequence(&viewport(), QKeySequence("Alt+Shift+Z"));
        QVERIFY(viewport().hasOverlays() && !viewport().plates().empty());
    }
    void escapeEndsPresentingWhereverTheFocusIs() {
        QTest::keyClick(&viewport(), Qt::Key_F5);
        auto* field = window().findChild<QLineEdit*>();
        QVERIFY(field);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!viewport().isPresenting());
    }
    void presentingHidesOutlinesAndHandlesInTheEditor() {
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!play().isInPlay() && canvas().isVisible(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
        QCoreApplication::sendPostedEvents();  // lays out the views
        window().views().scene().frameAll();
        const QImage bare = picture();
        selection().setInstances(project(), {project().instances.front().id});
        QTRY_VERIFY_WITH_TIMEOUT(bodiesMarked(kSelected) > 0, kPatience);
        const double outlines = test::meanDifference(bare, picture());
        QVERIFY2(outlines > 0.1, qPrintable(QString::number(outlines)));
        const int before = viewport().height();
        viewport().setPresenting(true);
        QTRY_VERIFY(viewport().height() > before);
        const QImage selected = picture();
        selection().setInstances(project(), {});
        QTRY_COMPARE_WITH_TIMEOUT(bodiesMarked(kSelected), 0, kPatience);
        const double left = test::meanDifference(picture(), selected);
        QVERIFY2(left < 0.1 * outlines, qPrintable(QString("%1 of %2").arg(left).arg(outlines)));
        viewport().setPresenting(false);
    }
    void statisticsAreRemembered() {
        QVERIFY(!preferences().preferences().hasStatistics);
        action("play-statistics")->trigger();
        QVERIFY(readPreferences(QSettings()).hasStatistics);
    }
    /// Again with two pixels a point.
    void theSameOnAFineScreen() {
        if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) return;
        QProcess fine;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_SCALE_FACTOR", "2");
        fine.setProcessEnvironment(environment);
        fine.setProcessChannelMode(QProcess::MergedChannels);
        fine.start(QCoreApplication::applicationFilePath(), {"OverlayStoryTest"});
        QVERIFY(fine.waitForFinished(kPatience));
        QVERIFY2(fine.exitStatus() == QProcess::NormalExit && fine.exitCode() == 0, fine.readAll());
    }
    void cleanupTestCase() { close(); }

private:
    PlayController& play() { return window().workspace().play(); }
    QWidget& header() { return *window().findChild<QComboBox*>("scope"); }
    void advance(int steps) {
        for (int k = 0; k < steps; ++k) play().thread().advance(kStep);
        play().applyUpdate();
        window().views().scene().playView().refresh();
    }
    QImage picture() { return test::shownPicture(viewport()).convertToFormat(QImage::Format_RGB888); }
    QRectF subject() {
        const Box3 bounds = boundsOf(viewport().scene());
        QRectF around;
        for (int corner = 0; corner < 8; ++corner) {
            const QPointF point = viewport().pointOf(bounds.corner(corner)).value();
            around = around.united({point, QSizeF(1e-3, 1e-3)});
        }
        return around;
    }
    /// Whether no plate meets another or the scene's bounds; m_fault says which do.
    bool areClear() {
        std::vector<QRectF> all{subject()};
        for (const QRect& plate : viewport().plates()) all.push_back(plate);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!QRectF(viewport().rect()).contains(all[k])) return fail(k, k, all);
            for (std::size_t other = 0; other < k; ++other) {
                if (all[k].intersects(all[other])) return fail(other, k, all);
            }
        }
        return true;
    }
    bool fail(std::size_t one, std::size_t other, const std::vector<QRectF>& all) {
        QDebug(&m_fault) << one << all[one] << other << all[other] << viewport().size();
        return false;
    }

    QString m_fault;
};

RUBBLE_TEST_WITH(OverlayStoryTest, QApplication)
#include "OverlayStoryTest.moc"
