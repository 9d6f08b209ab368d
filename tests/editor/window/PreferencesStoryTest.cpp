// Tests editor/dialogs/PreferencesDialog.cpp, Views::applyPreferences() and MainWindow::closeEvent().
#include "editor/dialogs/PreferencesDialog.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QAction>
#include <QComboBox>
#include <QTimer>

using namespace rubble;

/// Preferences take effect at once in the 3D view of an open window.
class PreferencesStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() { openBaked(boxProject(UniformScatter{.count = 4})); }
    void cleanup() { preferences().setPreferences({}); }
    void cleanupTestCase() { close(); }

    void dialogSetsAntiAliasingAndCancelRestoresIt() {
        const int before = viewport().settings().msaa;
        int during = -1;
        test::onNextDialog<PreferencesDialog>([&](PreferencesDialog& dialog) {
            for (auto* box : dialog.findChildren<QComboBox*>()) {
                if (box->findText("4×") >= 0) box->setCurrentText("4×");
            }
            during = viewport().settings().msaa;
            dialog.reject();
        });
        action("edit-preferences")->trigger();
        QCOMPARE(during, 4);
        QCOMPARE(viewport().settings().msaa, before);
    }
    void windowWithDialogStaysOpen() {
        bool isClosed = true;
        test::onNextDialog<PreferencesDialog>([&](PreferencesDialog& dialog) {
            isClosed = window().close();  // as quitting from another window does
            dialog.reject();
        });
        action("edit-preferences")->trigger();
        QVERIFY(!isClosed);
        QVERIFY(window().isVisible());
    }
    void navigationStyleChangesMouseButtons() {
        const Camera before = viewport().camera();
        preferences().setPreferences({.navigation = NavigationStyle::Maya});
        dragWithMiddleButton();
        QCOMPARE(viewport().camera().azimuth, before.azimuth);
        preferences().setPreferences({.navigation = NavigationStyle::Blender});
        dragWithMiddleButton();
        QVERIFY(viewport().camera().azimuth != before.azimuth);
    }
    void cameraJumpsUnlessViewChangesAreSmooth() {
        viewport().alignTo(StandardView::Isometric);
        QTRY_COMPARE(viewport().shownCamera().azimuth, viewport().camera().azimuth);
        preferences().setPreferences({.isSmooth = false});
        viewport().alignTo(StandardView::Right);
        QCOMPARE(viewport().shownCamera().azimuth, viewport().camera().azimuth);
        preferences().setPreferences({.isSmooth = true});
        viewport().alignTo(StandardView::Front);
        QVERIFY(viewport().shownCamera().azimuth != viewport().camera().azimuth);
    }
    void softLightIsRefined() {
        if (!hasView()) QSKIP("OpenGL is not available.");
        preferences().setPreferences({.refining = ProgressiveRendering::Never});
        const QImage plain = test::finishedPicture(viewport());
        preferences().setPreferences({.refining = ProgressiveRendering::Always});
        QVERIFY(test::finishedPicture(viewport()) != plain);
    }

private:
    void dragWithMiddleButton() {
        const QPoint middle = viewport().rect().center();
        QTest::mousePress(&viewport(), Qt::MiddleButton, {}, middle);
        QTest::mouseMove(&viewport(), middle + QPoint(80, 20));
        QTest::mouseRelease(&viewport(), Qt::MiddleButton, {}, middle + QPoint(80, 20));
    }
};

RUBBLE_TEST_WITH(PreferencesStoryTest, QApplication)
#include "PreferencesStoryTest.moc"
