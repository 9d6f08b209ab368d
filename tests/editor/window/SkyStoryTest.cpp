// Tests the skies of editor/view3d/SceneView.cpp and editor/window/MainWindow.cpp.
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/files/RadianceWriting.h"
#include "tests/support/viewport/ShownPicture.h"
#include "viewport/render/light/SkyLight.h"

#include <QMenu>

using namespace rubble;

/// A sky file lights the 3D view of an open window, and of those that are opened later.
class SkyStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(writeFileAtomically(pathOf("dusk.hdr").toStdString(),
                                    test::radianceFile({.width = 64, .height = 32, .pixel = [](auto, auto) {
                                                            return test::RgbePixel{220, 60, 20, 128};
                                                        }})));
        openBaked(boxProject(UniformScatter{.count = 4}));
    }
    void cleanupTestCase() { close(); }

    void selectedFileLightsTheScene() {
        const QImage before = hasView() ? test::shownPicture(viewport()) : QImage();
        emit window().views().scene().lightSelected(SkyPreset::Studio, pathOf("dusk.hdr"), 0.0);
        QTRY_VERIFY(viewport().settings().skyFile);
        QCOMPARE(readPreferences(QSettings()).skyFile, pathOf("dusk.hdr"));
        auto* menu = window().findChild<QMenu*>("view-light");
        QVERIFY(menu);
        QVERIFY(std::ranges::any_of(menu->actions(), [](const QAction* action) {
            return action->text() == "dusk.hdr" && action->isChecked();
        }));
        if (!hasView()) QSKIP("OpenGL is not available.");
        QVERIFY(test::shownPicture(viewport()) != before);
    }
    void presetsReplaceIt() {
        emit window().views().scene().lightSelected(SkyPreset::Evening, {}, 0.0);
        QVERIFY(!viewport().settings().skyFile);
        QCOMPARE(viewport().settings().sky, SkyPreset::Evening);
        emit window().views().scene().lightSelected(SkyPreset::Studio, pathOf("dusk.hdr"), 0.0);
        QTRY_VERIFY(viewport().settings().skyFile);
    }
    /// The studio lights the scene instead, and the messages say so once.
    void missingFileIsReportedOnce() {
        close();
        QVERIFY(QFile::remove(pathOf("dusk.hdr")));
        QSettings settings;
        writePreferences(withLight({}, SkyPreset::Studio, pathOf("dusk.hdr"), 0.0), settings);
        open(boxProject(UniformScatter{.count = 4}));
        const auto count = [this] {
            return std::ranges::count_if(window().views().messages().list(), [](const Message& message) {
                return message.text.contains("dusk.hdr") && message.text.endsWith("The studio lights the scene.");
            });
        };
        QTRY_COMPARE(count(), 1);
        QVERIFY(!viewport().settings().skyFile);
        QCOMPARE(viewport().settings().sky, SkyPreset::Studio);
        emit window().views().scene().lightSelected(SkyPreset::Studio, pathOf("dusk.hdr"), 0.5);  // the same file
        QCoreApplication::processEvents();
        QCOMPARE(count(), 1);
    }
};

RUBBLE_TEST_WITH(SkyStoryTest, QApplication)
#include "SkyStoryTest.moc"
