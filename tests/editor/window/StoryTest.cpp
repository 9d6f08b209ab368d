// Tests editor/window/MainWindow.cpp, editor/window/Program.cpp, editor/actions/FileActions.cpp,
// editor/view3d/SceneView.cpp and editor/workspace/Workspace.cpp.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Section.h"
#include "editor/widgets/SliderField.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/TestSettings.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/viewport/ShownPicture.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <filesystem>
#include <utility>

using namespace rubble;

namespace {

int differentPixels(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    }
    return count;
}

}  // namespace

/// The workflow of a new user, by mouse and keys: add a prism, scatter forty seeds, drag one, delete three, explode the
/// fragments, undo and redo everything, save, reopen and export.
class StoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QApplication::setQuitOnLastWindowClosed(false);  // one is closed and another opened
        m_program = std::make_unique<Program>();
        m_window = m_program->showStartPage();
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        QVERIFY(isActive());
    }

    void newProjectReplacesStartPage() {
        QTest::keyClick(m_window, Qt::Key_N, Qt::ControlModifier);
        QVERIFY(!m_window->isPristine());
        QVERIFY(canvas().isVisible());
        m_newBytes = projectText(project());
    }
    void actionSearchAddsRectangle() {
        test::onNextDialog<QDialog>([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
        QTest::keyClick(m_window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QWidget* search = nullptr;
        QTRY_VERIFY((search = QApplication::activePopupWidget()));
        auto* query = search->findChild<QLineEdit*>();
        QTest::keyClicks(query, "add rect");
        QTest::keyClick(query, Qt::Key_Return);
        QTRY_COMPARE(project().assets.size(), std::size_t{1});
        QCOMPARE(project().instances.size(), std::size_t{1});
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(20), kPatience);
    }
    void countFieldScattersFortySeeds() {
        SliderField* count = nullptr;
        for (SliderField* field : m_window->findChildren<SliderField*>()) {
            if (field->isVisible() && field->field().accessibleName() == "Count") count = field;
        }
        QVERIFY(count);
        QTest::mouseClick(&count->field(), Qt::LeftButton);
        count->field().selectAll();
        QTest::keyClicks(&count->field(), "40");
        QTest::keyClick(&count->field(), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(40), kPatience);
    }
    void draggingASeedMovesItsCell() {
        const QPoint from = pixelOfSeed(0);
        const QImage before = canvas().grab().toImage();
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 10; ++step) QTest::mouseMove(&canvas(), from + QPoint(3 * step, 2 * step));
        QTRY_VERIFY_WITH_TIMEOUT(differentPixels(before, canvas().grab().toImage()) > 500, kPatience);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + QPoint(30, 20));
        QCOMPARE(asset().pattern.layers[0].overrides.size(), std::size_t{1});
        QCOMPARE(undoStack().undoText(), "Move Seed");
    }
    void deleteRemovesThreeSelectedSeeds() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixelOfSeed(5));
        for (const std::uint32_t seed : {9u, 13u}) {
            QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::ControlModifier, pixelOfSeed(seed));
        }
        QCOMPARE(m_window->workspace().selection().seeds().size(), std::size_t{3});
        QTest::keyClick(&canvas(), Qt::Key_Delete);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(37), kPatience);
    }
    void sliderExplodesFragments() {
        if (!m_window->views().scene().viewport().errorText().isEmpty()) QSKIP("OpenGL is not available.");
        ViewportWidget& viewport = m_window->views().scene().viewport();
        QTRY_COMPARE(viewport.scene().picks.size(), std::size_t{37});  // it follows the bake
        const QImage assembled = test::shownPicture(viewport);
        auto* slider = m_window->findChild<QSlider*>("exploded");
        slider->setFocus();
        for (int step = 0; step < 10; ++step) QTest::keyClick(slider, Qt::Key_PageUp);
        QTRY_VERIFY_WITH_TIMEOUT(differentPixels(assembled, test::shownPicture(viewport)) > 2000, kPatience);
    }
    void undoRestoresTheNewProject() {
        m_editedBytes = projectText(project());
        while (undoStack().canUndo()) QTest::keyClick(m_window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(projectText(project()), m_newBytes);
        while (undoStack().canRedo()) QTest::keyClick(m_window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(projectText(project()), m_editedBytes);
    }
    void reopenedProjectEqualsSavedOne() {
        const std::string unsaved = m_editedBytes;
        const QString path = m_folder.filePath("story.rubble");
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        QTest::keyClick(m_window, Qt::Key_S, Qt::ControlModifier);
        Project saved = project();
        m_editedBytes = projectText(saved);  // with the identity that the first save gives
        QCOMPARE(bytesOfFile(path).toStdString(), m_editedBytes);
        QVERIFY(!std::exchange(saved.identity, {}).empty());
        QCOMPARE(projectText(saved), unsaved);
        QVERIFY(!m_window->isWindowModified());
        m_window->findChild<Section*>("shape")->setCollapsed(true);
        QVERIFY(m_window->close());
        delete m_window;
        m_window = m_program->open(path);
        QVERIFY(m_window);
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        QVERIFY(isActive());
        QCOMPARE(projectText(project()), m_editedBytes);
        QVERIFY(m_window->findChild<Section*>("shape")->isCollapsed());
        QVERIFY(!m_window->findChild<Section*>("pattern")->isCollapsed());
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(37), kPatience);
    }
    void exportWritesAnObjectPerFragment() {
        test::onNextDialog<QDialog>([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
        QTest::keyClick(m_window, Qt::Key_E, Qt::ControlModifier);
        const std::filesystem::path folder = m_folder.filePath("packs/rectangle").toStdString();
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(folder / "pack.json"), kPatience);
        int objects = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            if (file.path().extension() != ".obj") continue;
            for (const QByteArray& line : bytesOfFile(QString::fromStdString(file.path().string())).split('\n')) {
                objects += line.startsWith("o ");
            }
        }
        QCOMPARE(objects, 38);  // the fragments and the whole
        QTest::keyClick(m_window, Qt::Key_E,
                        Qt::ControlModifier | Qt::ShiftModifier);  // exports again without a dialog
    }
    void cleanupTestCase() {
        QVERIFY(m_window->close());
        delete m_window;
    }

private:
    /// Shows the window and gives it the keyboard focus, also without a window manager.
    bool isActive() {
        QApplication::setActiveWindow(m_window);
        return QTest::qWaitForWindowExposed(m_window, kPatience);
    }
    const Project& project() { return m_window->workspace().project(); }
    const Asset& asset() { return project().assets.front(); }
    PatternCanvas& canvas() { return m_window->views().canvas(); }
    QUndoStack& undoStack() { return m_window->workspace().document().undoStack(); }
    bool isBaked(std::uint32_t fragments) {
        const auto baked = m_window->workspace().bakes().find(asset().id);
        return baked && baked->bake && baked->bake->fragmentCount() == fragments &&
               !m_window->workspace().baker().isBusy();
    }
    /// The position of a seed of the first layer on the canvas.
    QPoint pixelOfSeed(std::uint32_t index) {
        const auto pattern = m_window->workspace().bakes().findPattern(asset().id);
        for (std::size_t k = 0; k < pattern->seeds.ids.size(); ++k) {
            if (pattern->seeds.ids[k].index != index) continue;
            return canvas().view().pixels(pattern->seeds.positions[k]).toPoint();
        }
        return {};
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
    MainWindow* m_window = nullptr;
    std::string m_newBytes;
    std::string m_editedBytes;
};

RUBBLE_TEST_WITH(StoryTest, QApplication)
#include "StoryTest.moc"
