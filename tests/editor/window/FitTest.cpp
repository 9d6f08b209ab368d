// Tests the layout of editor/views/DockLayout.cpp and of all docks and dialogs: every text fits into its rectangle.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/dialogs/import/ImportDialog.h"
#include "editor/views/Views.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/TextFit.h"
#include "tests/support/files/FileTree.h"

#include <QDockWidget>

using namespace rubble;

namespace {

constexpr const char* kBrick =
    "o brick\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

}  // namespace

/// Walks all docks at the smallest supported sizes of the window, in both themes and in all units of length. A screen
/// of 2560 × 1440 pixels at 2× has the layout of 1280 × 720 points.
class FitTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        const Result<Project> house = loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        QVERIFY(house.hasValue());
        Project project = starterProject();
        project.shots.push_back(house->shots.front());  // for a video
        project.shots.front().id = project.nextId++;
        openBaked(project);
        play().thread().useSteppedClock();
        writeFileTree(pathOf({}), {{"brick.obj", kBrick}});
        window().show();
        QVERIFY(QTest::qWaitForWindowExposed(&window(), kPatience));
    }
    void cleanupTestCase() { close(); }

    /// With all docks; a screen of 2560 × 1440 pixels has 1280 × 720 points at 2×, less the panels of the desktop.
    void windowFitsOnASmallScreen() {
        const QSize least = window().minimumSizeHint();
        QVERIFY2(least.width() <= 1100 && least.height() <= 500,
                 qPrintable(QString("%1 × %2").arg(least.width()).arg(least.height())));
    }
    void textsFit_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("theme");
        QTest::addColumn<int>("unit");
        for (const QSize size : {QSize(1280, 720), QSize(1440, 900)}) {
            for (const ColourScheme theme : {ColourScheme::Light, ColourScheme::Dark}) {
                for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Foot}) {
                    QTest::addRow("%d-%s-%d", size.width(), theme == ColourScheme::Dark ? "dark" : "light",
                                  static_cast<int>(unit))
                        << size << static_cast<int>(theme) << static_cast<int>(unit);
                }
            }
        }
    }
    void textsFit() {
        QFETCH(const QSize, size);
        QFETCH(const int, theme);
        QFETCH(const int, unit);
        m_faults.clear();
        preferences().setPreferences(
            {.theme = static_cast<ColourScheme>(theme), .unit = static_cast<LengthUnit>(unit)});
        window().views().docks().reset();
        window().resize(size);
        QTRY_COMPARE_WITH_TIMEOUT(window().size(), size, kPatience);
        for (const auto& [name, select] : subjects()) {
            select();
            for (std::size_t k = 0; k < kDockCount; ++k) {
                QDockWidget& dock = window().views().docks().dock(static_cast<DockId>(k));
                dock.raise();
                check(dock, QString("%1 (%2)").arg(dock.windowTitle(), name));
            }
        }
        check(window(), "Window");
        resizeDocks(1);  // to their least width
        for (const auto& [name, select] : subjects()) {
            select();
            for (const DockId id :
                 {DockId::Project, DockId::History, DockId::Inspector, DockId::Strength, DockId::PlayTools}) {
                QDockWidget& dock = window().views().docks().dock(id);
                dock.raise();
                check(dock, QString("Narrow %1 (%2)").arg(dock.windowTitle(), name));
            }
        }
        for (const char* name : kDialogs) {
            QVERIFY2(action(name), name);
            QVERIFY2(action(name)->isEnabled(), name);
            test::onNextDialog<QDialog>([this](QDialog& dialog) {
                check(dialog, dialog.windowTitle());
                dialog.reject();
            });
            action(name)->trigger();
        }
        ImportDialog importing(pathOf("brick.obj"), project(), preferences().preferences(), &window());
        QVERIFY(importing.read(RUBBLE_IMPORTER));
        importing.show();
        check(importing, importing.windowTitle());
        checkPlay();
        for (const QString& fault : m_faults) qWarning("%s", qPrintable(fault));
        QVERIFY(m_faults.isEmpty());
    }

private:
    static constexpr const char* kDialogs[] = {"shape-rectangle",     "shape-triangle",        "shape-polygon",
                                               "edit-preferences",    "file-export",           "material-library",
                                               "instance-grid-array", "instance-radial-array", "select-volume",
                                               "select-random",       "file-save-picture",     "play-video"};

    PlayController& play() { return window().workspace().play(); }
    void checkPlay() {
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        for (int k = 0; k < 30; ++k) play().thread().advance(kStep);
        play().applyUpdate();
        for (const DockId id : {DockId::Play, DockId::Tests}) {
            QDockWidget& dock = window().views().docks().dock(id);
            dock.raise();
            check(dock, dock.windowTitle() + " in play");
        }
        check(window(), "Window in play");
        play().stop();
    }

    void resizeDocks(int width) {
        DockLayout& docks = window().views().docks();
        window().resizeDocks({&docks.dock(DockId::Project), &docks.dock(DockId::Inspector)}, {width, width},
                             Qt::Horizontal);
    }
    void check(QWidget& widget, const QString& name) {
        for (int k = 0; k < 3; ++k) QCoreApplication::processEvents();  // wrapped texts have a second layout
        for (const QString& text : test::clippedTexts(widget) + test::faintTexts(widget)) {
            if (const QString fault = name + ": " + text; !m_faults.contains(fault)) m_faults << fault;
        }
        const QString folder = qEnvironmentVariable("RUBBLE_PICTURES");  // for inspection by a person
        if (!folder.isEmpty()) widget.grab().save(QString("%1/%2-%3.png").arg(folder, QTest::currentDataTag(), name));
    }
    std::vector<std::pair<QString, std::function<void()>>> subjects() {
        const Id asset = project().assets.front().id;
        return {{"asset", [this, asset] { selection().setAsset(asset); }},
                {"fragments", [this] { action("select-all")->trigger(); }},
                {"instance", [this] { selection().setInstances(project(), {project().instances.front().id}); }}};
    }

    QStringList m_faults;
};

RUBBLE_TEST_WITH(FitTest, QApplication)
#include "FitTest.moc"
