#pragma once

#include "core/base/Random.h"
#include "tests/attack/monkey/Journal.h"

#include <QObject>
#include <QPointer>
#include <QWindow>

#include <deque>
#include <functional>
#include <string_view>

class QAction;
class QFileDialog;
class QWidget;

namespace rubble {
class MainWindow;
class Program;
}  // namespace rubble

namespace rubble::attack {

/// Uses the editor at random: mouse, wheel and keys, values in fields, actions of the menus, files in dialogs. The
/// events take the way of those of the window system, and dialogs get theirs while they are open. Only Quit is left
/// out.
///
/// The seed determines what is drawn; what it hits also depends on what the editor computed by then.
class Monkey : public QObject {
public:
    /// `files`: the folder with files to open, in which files are saved.
    Monkey(Program& program, JournalWriter& journal, const QString& files, std::uint64_t seed);

    /// Makes events until there were `count`, then calls `finished`.
    void start(std::uint64_t count, std::function<void()> finished);

private:
    void step();
    void act();
    void actInWindow(QWidget& window);
    void actInDialog(QWidget& dialog);
    void actInPopup(QWidget& popup);
    void answerFileDialog(QFileDialog& dialog);
    QString fileNameFor(const QFileDialog& dialog);
    void openOrCloseWindows();
    void triggerAction(const MainWindow& window);

    void click(QWidget& widget);
    void drag(QWidget& widget);
    void turnWheel(QWidget& widget);
    void pressKey(QWidget& window);
    void enterValue(QWidget& window);
    void pressButton(QWidget& window);

    void addMouse(QWindow* window, QPoint at, Qt::MouseButtons buttons, Qt::MouseButton button, QEvent::Type type);
    void addKey(QWindow* window, int key, Qt::KeyboardModifiers modifiers, const QString& text);
    void addText(QWindow* window, const QString& text);
    QWidget* widgetIn(QWidget& window, const std::function<bool(const QWidget&)>& isWanted);
    QPoint pointIn(const QWidget& widget);
    Qt::KeyboardModifiers modifiers();
    bool isChance(int percent) { return m_random.below(100) < static_cast<std::uint64_t>(percent); }
    template <class List>
    auto& oneOf(List& list) {
        return list[m_random.below(std::size(list))];
    }
    void note(std::string_view what, const QWidget* widget, const QString& detail = {});

    Program& m_program;
    JournalWriter& m_journal;
    QString m_files;
    Random m_random;
    std::uint64_t m_left = 0;
    std::function<void()> m_finished;
    std::deque<std::function<void()>> m_steps;  // of the current event
    int m_milliseconds = 0;                     // of the events' clock
    Qt::KeyboardModifiers m_modifiers;          // held during the current event
};

}  // namespace rubble::attack
