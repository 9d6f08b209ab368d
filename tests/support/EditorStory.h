#pragma once

#include "core/io/ProjectFile.h"
#include "editor/MainWindow.h"
#include "editor/Program.h"
#include "editor/SceneView.h"
#include "editor/Views.h"
#include "editor/canvas/PatternCanvas.h"
#include "tests/support/TestSettings.h"
#include "viewport/ViewportWidget.h"

#include <QApplication>
#include <QMouseEvent>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>

namespace rubble {

/// What tests share that work a whole window by mouse and keys: one with a project, its settings kept apart from the user's.
class EditorStory : public QObject {
protected:
    static constexpr int kPatience = 60000;  // ms, for baking and drawing on a busy machine

    void open(Project project) {
        begin();
        m_window.reset(m_program->showNew(std::move(project), true));
        show();
        viewport().setFlights(false);
    }
    void openFile(const QString& path) {
        begin();
        m_window.reset(m_program->open(path));
        QVERIFY(m_window);
        show();
    }
    /// Waits until all is baked, shows all of it, and keeps the project's text in m_before.
    void openBaked(Project project) {
        open(std::move(project));
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(this->project()), kPatience);
        window().views().fit();
        m_before = text();
    }
    /// Without asking whether to save.
    void close() {
        m_window.reset();
        m_program.reset();
    }

    MainWindow& window() { return *m_window; }
    ViewportWidget& viewport() { return m_window->views().scene().viewport(); }
    PatternCanvas& canvas() { return m_window->views().canvas(); }
    Selection& selection() { return m_window->workspace().selection(); }
    const Project& project() { return m_window->workspace().project(); }
    std::string text() { return projectText(project()); }
    QUndoStack& stack() { return m_window->workspace().document().undoStack(); }
    QAction* action(const char* name) { return m_window->findChild<QAction*>(name); }
    bool hasView() { return viewport().fault().isEmpty(); }
    bool isBaked(Id asset, std::uint32_t fragments) {
        const auto baked = m_window->workspace().bakes().find(asset);
        return baked && baked->bake && baked->bake->fragmentCount() == fragments;
    }

    /// How many bodies of the scene have a mark: kHidden, kSelected.
    int bodiesMarked(std::uint32_t mark) {
        const auto isMarked = [&](const BodyLook& look) { return (look.marks & mark) != 0; };
        return static_cast<int>(std::ranges::count_if(viewport().scene().looks, isMarked));
    }

    QPoint pixels(Vec2 metres) { return canvas().view().pixels(metres).toPoint(); }
    /// Moves the pointer; QTest::mouseMove() knows no modifiers.
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

    /// Chooses in the canvas what lies within these corners, m.
    void lasso(std::initializer_list<Vec2> corners) {
        const QPoint first = pixels(*corners.begin()), last = pixels(*(corners.end() - 1));
        QTest::mousePress(&canvas(), Qt::LeftButton, Qt::AltModifier, first);
        for (const Vec2 corner : corners) moveTo(canvas(), pixels(corner), Qt::AltModifier, Qt::LeftButton);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::AltModifier, last);
    }

    QString pathOf(const QString& name) const { return m_folder.filePath(name); }

    std::string m_before;  // the project's text, as a test keeps it

private:
    void begin() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QApplication::setQuitOnLastWindowClosed(false);
        m_program = std::make_unique<Program>();
    }
    /// The window has the keys, whether there is a window manager or not.
    void show() {
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->activateWindow();
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatience));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
    std::unique_ptr<MainWindow> m_window;
};

}  // namespace rubble
