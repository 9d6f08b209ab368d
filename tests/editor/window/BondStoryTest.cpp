// Tests editor/panels/inspector/BondSection.cpp in the window: a wall is made to break as bonded, saved and loaded.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/FragmentSelection.h"
#include "editor/panels/inspector/BondSection.h"
#include "editor/panels/inspector/Inspector.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"
#include "tests/support/editor/TextFit.h"

#include <QScrollArea>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

using namespace rubble;

/// A wall that breaks as bonded, by mouse and keys.
class BondStoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setQuitOnLastWindowClosed(false);
        m_program = std::make_unique<Program>();
        m_window = m_program->showProject(starterProject());
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window, kPatience));
        selection().setAsset(wall().id);
        m_before = projectText(project());
    }
    void cleanupTestCase() { delete m_window; }

    void aComboBoxMakesTheWallBreakAsBonded() {
        QVERIFY(!bonds().isVisible());
        auto& breakAs = control<QComboBox>("Break as");
        reveal(breakAs);
        breakAs.setFocus();
        QTest::keyClick(&breakAs, Qt::Key_Down);
        QCOMPARE(wall().breakAs, BreakAs::Bonded);
        QVERIFY(bonds().isVisible());
        QCOMPARE(m_window->workspace().document().undoStack().undoText(), "Set How It Breaks");
    }
    void toolsKeepTextsBesideTheBarOfBonds() {
        m_window->resize(1440, 900);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), QSize(1440, 900), kPatience);
        QVERIFY(m_window->findChild<QToolBar*>("bar-bonds")->isVisible());
        for (const char* name : {"bar-play", "bar-tools"}) {
            auto* bar = m_window->findChild<QToolBar*>(name);
            auto* first = qobject_cast<QToolButton*>(bar->widgetForAction(bar->actions().front()));
            QTRY_COMPARE(first->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
        }
        const auto clipped = [&] { return test::clippedTexts(*m_window).filter("tool bar"); };
        QTRY_VERIFY2(clipped().isEmpty(), qPrintable(clipped().join('\n')));
    }
    void bondsAreSetByTypingAndDragging() {
        type("Maximum span", "1.5");
        type("Damage limit", "75 %");
        auto& add = control<QToolButton>("Add Height");
        for (int k = 0; k < 2; ++k) {
            reveal(add);
            QTest::mouseClick(&add, Qt::LeftButton);
        }
        QCOMPARE(wall().bonding.span, 1.5);
        QCOMPARE(wall().bonding.damageFrom, 0.75);
        QCOMPARE(wall().bonding.heightStrengths.size(), std::size_t{2});
    }
    void selectedFragmentsNeverBreak() {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().bakes().find(wall().id), kPatience);
        const auto baked = m_window->workspace().bakes().find(wall().id);
        QVERIFY(baked && baked->bake);
        FragmentSet set(baked->bake->fragmentCount(), false);
        set[0] = set[2] = true;
        selection().setFragments(selectionOf(set, *baked->bake));
        auto& box = *inspector().findChild<QCheckBox*>("never-breaks");
        reveal(box);
        QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
        QCOMPARE(wall().bonding.neverBreaks.size(), std::size_t{2});
    }
    void savedBondsAreLoaded() {
        const std::filesystem::path file = m_folder.filePath("bonded.rubble").toStdString();
        QVERIFY(saveProject(file, project()));
        const Result<Project> loaded = loadProject(file);
        QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
        QVERIFY(loaded->assets == project().assets);
    }
    void undoingRestoresTheFile() {
        QUndoStack& stack = m_window->workspace().document().undoStack();
        while (stack.canUndo()) stack.undo();
        QCOMPARE(projectText(project()), m_before);
        QVERIFY(!bonds().isVisible());
    }

private:
    const Project& project() { return m_window->workspace().document().project(); }
    const Asset& wall() { return project().assets[0]; }
    Selection& selection() { return m_window->workspace().selection(); }
    Inspector& inspector() { return *m_window->findChild<Inspector*>(); }
    BondSection& bonds() { return *inspector().findChild<BondSection*>(); }
    template <class Control>
    Control& control(const QString& name) {
        for (Control* control : inspector().page().findChildren<Control*>()) {
            if (control->accessibleName() == name) return *control;
        }
        qFatal("There is no control \"%s\".", qPrintable(name));
    }
    /// Scrolls the inspector to a control, as the wheel does.
    void reveal(QWidget& control) {
        for (auto* area : inspector().findChildren<QScrollArea*>()) {
            if (area->widget() && area->widget()->isAncestorOf(&control)) area->ensureWidgetVisible(&control);
        }
    }
    void type(const QString& name, const QString& text) {
        auto& field = control<NumberField>(name);
        reveal(field);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
    MainWindow* m_window = nullptr;
    std::string m_before;
};

RUBBLE_TEST_WITH(BondStoryTest, QApplication)
#include "BondStoryTest.moc"
