#pragma once

#include "core/io/project/ProjectFile.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/editor/TestSettings.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>

namespace rubble {

/// Base of the tests that drive a whole window by mouse and keys. The window's settings are separate from the user's.
class EditorStory : public QObject {
protected:
    static constexpr double kStep = 1.0 / 60.0;  // s

    void open(Project project) {
        begin();
        m_window.reset(m_program->showProject(std::move(project)));
        show();
        viewport().setCameraAnimation(false);
    }
    void openStartPage() {
        begin();
        m_window.reset(m_program->showStartPage());
        show();
    }
    void openFile(const QString& path) {
        begin();
        m_window.reset(m_program->open(path));
        QVERIFY(m_window);
        show();
    }
    /// Opens a project, waits until it is baked, frames the asset and stores the project's text in m_before.
    void openBaked(Project project) {
        open(std::move(project));
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(this->project()), kPatience);
        window().views().frameAsset();
        m_before = text();
    }
    /// Closes the window without asking whether to save.
    void close() {
        m_window.reset();
        m_program.reset();
    }

    MainWindow& window() { return *m_window; }
    PreferenceStore& preferences() { return m_program->preferences(); }
    ViewportWidget& viewport() { return m_window->views().scene().viewport(); }
    PatternCanvas& canvas() { return m_window->views().canvas(); }
    Selection& selection() { return m_window->workspace().selection(); }
    const Project& project() { return m_window->workspace().project(); }
    std::string text() { return projectText(project()); }
    QUndoStack& stack() { return m_window->workspace().document().undoStack(); }
    QAction* action(const char* name) { return m_window->findChild<QAction*>(name); }
    bool hasView() { return viewport().errorText().isEmpty(); }
    bool isBaked(Id asset, std::uint32_t fragments) {
        const auto baked = m_window->workspace().bakes().find(asset);
        return baked && baked->bake && baked->bake->fragmentCount() == fragments;
    }

    /// The number of bodies in the 3D view with a mark: kHidden, kSelected.
    int bodiesMarked(std::uint32_t mark) {
        const auto isMarked = [&](const BodyAppearance& look) { return (look.marks & mark) != 0; };
        return static_cast<int>(std::ranges::count_if(viewport().scene().appearances, isMarked));
    }

    QPoint pixels(Vec2 metres) { return canvas().view().pixels(metres).toPoint(); }
    /// Moves the pointer with modifiers, which QTest::mouseMove() does not support.
    static void moveTo(QWidget& widget, QPoint at, Qt::KeyboardModifiers modifiers = {},
                       Qt::MouseButtons buttons = Qt::NoButton) {
        QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, buttons, modifiers);
        QCoreApplication::sendEvent(&widget, &event);
    }
    static void drag(QWidget& widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
        moveTo(widget, from, modifiers);
        QTest::mousePress(&widget, Qt::LeftButton, modifiers, from);
        moveTo(widget, (from + to) / 2, modifiers, Qt::LeftButton);
        moveTo(widget, to, modifiers, Qt::LeftButton);
        QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, to);
    }

    /// Selects with the lasso in the canvas; corners in m.
    void lasso(std::initializer_list<Vec2> corners) {
        const QPoint first = pixels(*corners.begin()), last = pixels(*(corners.end() - 1));
        QTest::mousePress(&canvas(), Qt::LeftButton, Qt::AltModifier, first);
        for (const Vec2 corner : corners) moveTo(canvas(), pixels(corner), Qt::AltModifier, Qt::LeftButton);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::AltModifier, last);
    }

    QString pathOf(const QString& name) const { return m_folder.filePath(name); }

    std::string m_before;  // the project's text before the test

private:
    void begin() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QSettings().setValue("preferences/softLight", "never");  // what refines pictures takes time from all else
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QApplication::setQuitOnLastWindowClosed(false);
        m_program = std::make_unique<Program>();
    }
    /// Shows the window and gives it the keyboard focus, also without a window manager.
    void show() {
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->activateWindow();
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatience));
        viewport().setAdaptive(false);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
    std::unique_ptr<MainWindow> m_window;
};

}  // namespace rubble
