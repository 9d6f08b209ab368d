#include "tests/attack/monkey/Monkey.h"

#include "core/asset/library/StarterProject.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "viewport/widget/ViewportWidget.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>

namespace rubble::attack {
namespace {

constexpr std::chrono::milliseconds kStepPause{2};  // between the steps of an event
constexpr std::chrono::milliseconds kLongPause{300};
constexpr QSize kWindowSize{900, 620};  // small: most of the time is spent with drawing
constexpr int kMaxWindows = 3;
constexpr int kMaxDragSteps = 8;

constexpr const char* kPlainValues[] = {"0", "0.05", "0.3", "1", "2", "2.5", "7", "12", "60", "45"};
constexpr const char* kOddValues[] = {
    "0",     "1",   "2.5",           "-1",          "7",   "12",  "60", "0.05", "0.001", "-0",  "1e9", "1e-9",
    "1e300", "nan", "inf",           "10 cm",       "3 m", "1,5", "",   "wall", "50 %",  "a b", "Ωß",  "#",
    "..",    "*",   "volume > 0.01", "999999999999"};
constexpr Qt::Key kKeys[] = {Qt::Key_Return,    Qt::Key_Escape, Qt::Key_Tab,    Qt::Key_Backtab,  Qt::Key_Delete,
                             Qt::Key_Backspace, Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Left,     Qt::Key_Right,
                             Qt::Key_Home,      Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Insert,
                             Qt::Key_F1,        Qt::Key_F2,     Qt::Key_F5,     Qt::Key_F11,      Qt::Key_Menu};
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789 +-./,*[]";
constexpr Qt::KeyboardModifiers kModifiers[] = {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier,
                                                Qt::ControlModifier | Qt::ShiftModifier};

bool isField(const QWidget& widget) {
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QComboBox*>(&widget);
}

bool isButton(const QWidget& widget) { return qobject_cast<const QAbstractButton*>(&widget) != nullptr; }

QList<MainWindow*> mainWindows() {
    QList<MainWindow*> windows;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* window = qobject_cast<MainWindow*>(widget);
        if (window && window->isVisible()) windows.append(window);
    }
    return windows;
}

/// The windows that a user could use now: main windows, floating docks, the manual, a contact sheet.
QWidgetList usableWindows() {
    QWidgetList windows;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        const bool isUsable = widget->isVisible() && widget->windowHandle() && widget->windowType() != Qt::ToolTip &&
                              widget->windowType() != Qt::Popup;
        if (isUsable) windows.append(widget);
    }
    return windows;
}

}  // namespace

Monkey::Monkey(Program& program, JournalWriter& journal, const QString& files, std::uint64_t seed)
    : m_program(program), m_journal(journal), m_files(files), m_random(seed) {}

void Monkey::start(std::uint64_t count, std::function<void()> finished) {
    m_left = count;
    m_finished = std::move(finished);
    step();
}

/// An event may open a dialog, which runs an event loop until it is closed. So each step plans the next one first.
void Monkey::step() {
    if (m_steps.empty() && m_left == 0) return m_finished();
    const bool isLong = m_steps.empty() && m_random.below(100) == 0;
    QTimer::singleShot(isLong ? kLongPause : kStepPause, this, &Monkey::step);
    if (m_steps.empty()) {
        --m_left;
        return act();
    }
    const std::function<void()> next = std::move(m_steps.front());
    m_steps.pop_front();
    next();
}

void Monkey::act() {
    m_modifiers = {};
    for (MainWindow* window : mainWindows()) {
        window->findChild<QAction*>("file-quit")->setEnabled(false);
        if (window->width() > kWindowSize.width()) window->resize(kWindowSize);
    }
    if (QWidget* popup = QApplication::activePopupWidget()) return actInPopup(*popup);
    QWidget* modal = QApplication::activeModalWidget();
    if (auto* dialog = qobject_cast<QFileDialog*>(modal)) return answerFileDialog(*dialog);
    if (modal) return actInDialog(*modal);
    const qsizetype count = mainWindows().size();
    if (count == 0 || count > kMaxWindows) return openOrCloseWindows();
    const QWidgetList windows = usableWindows();
    QWidget& window = *(isChance(20) ? oneOf(windows) : mainWindows().front());
    if (!window.isActiveWindow()) window.activateWindow();
    actInWindow(window);
}

void Monkey::openOrCloseWindows() {
    const QList<MainWindow*> windows = mainWindows();
    note(windows.isEmpty() ? "open" : "close", nullptr);
    if (!windows.isEmpty()) {
        windows.front()->close();
    } else if (isChance(50)) {
        m_program.open(m_files + "/original.rubble");
    } else {
        m_program.showStartPage();
    }
}

void Monkey::actInWindow(QWidget& window) {
    auto* main = qobject_cast<MainWindow*>(&window);
    const std::uint64_t number = m_random.below(100);
    if (main && number < 30) return triggerAction(*main);
    QWidget* widget = widgetIn(window, [](const QWidget&) { return true; });
    if (main && number < 65 && !main->isPristine()) {
        QWidget& canvas = main->views().canvas();
        QWidget& viewport = main->views().scene().viewport();
        QWidget& view = isChance(65) ? canvas : viewport;
        if (view.isVisible()) widget = &view;
    }
    if (!widget) return;
    if (number < 45 || number >= 94) return click(*widget);
    if (number < 60) return drag(*widget);
    if (number < 65) return turnWheel(*widget);
    if (number < 80) return enterValue(window);
    if (number < 86) return pressButton(window);
    pressKey(window);
}

void Monkey::actInDialog(QWidget& dialog) {
    const std::uint64_t number = m_random.below(100);
    QWidget* widget = widgetIn(dialog, [](const QWidget&) { return true; });
    if (qobject_cast<QMessageBox*>(&dialog) || number < 35) return pressButton(dialog);
    if (number < 60) return enterValue(dialog);
    if (number < 75 && widget) return click(*widget);
    if (number < 80 && widget) return drag(*widget);
    if (number < 90) return pressKey(dialog);
    const bool isAccepted = isChance(50);
    note(isAccepted ? "accept" : "reject", &dialog);
    addKey(dialog.windowHandle(), isAccepted ? Qt::Key_Return : Qt::Key_Escape, {}, isAccepted ? "\r" : "");
}

void Monkey::actInPopup(QWidget& popup) {
    const std::uint64_t number = m_random.below(100);
    if (number < 60) return click(popup);
    if (number < 85) return pressKey(popup);
    note("close popup", &popup);
    addKey(popup.windowHandle(), Qt::Key_Escape, {}, {});
}

/// Names are entered as a whole: most that are typed at random exist nowhere.
void Monkey::answerFileDialog(QFileDialog& dialog) {
    if (isChance(25)) {
        note("reject", &dialog);
        return dialog.reject();
    }
    const QString name = dialog.fileMode() == QFileDialog::Directory ? QString() : fileNameFor(dialog);
    const QString path = m_files + '/' + name;
    note("answer", &dialog, path);
    dialog.findChild<QLineEdit*>("fileNameEdit")->setText(path);
    static_cast<QDialog&>(dialog).accept();
}

/// A file that exists if one is to be opened, mostly; a new one or an existing one to save.
QString Monkey::fileNameFor(const QFileDialog& dialog) {
    QStringList patterns;
    for (const QString& filter : dialog.nameFilters()) {
        patterns += filter.section('(', -1).section(')', 0, 0).split(' ', Qt::SkipEmptyParts);
    }
    const QStringList files = QDir(m_files).entryList(patterns, QDir::Files);
    const QStringList newNames = {"a", "b", "wall 2"};
    const bool isNew = files.isEmpty() || isChance(dialog.acceptMode() == QFileDialog::AcceptSave ? 60 : 5);
    const QString name = isNew ? oneOf(newNames) : oneOf(files);
    return isNew && !dialog.defaultSuffix().isEmpty() ? name + '.' + dialog.defaultSuffix() : name;
}

/// Triggers an action of a random menu: menus with few actions count as much as those with many.
void Monkey::triggerAction(const MainWindow& window) {
    const QWidget* menu = window.menuBar();
    while (menu != nullptr) {
        if (const auto* opened = qobject_cast<const QMenu*>(menu)) emit const_cast<QMenu*>(opened)->aboutToShow();
        QList<QAction*> actions = menu->actions();
        actions.removeIf([](const QAction* action) { return action->isSeparator() || !action->isEnabled(); });
        if (actions.isEmpty()) return;
        QAction* action = oneOf(actions);
        menu = action->menu();
        if (menu != nullptr) continue;
        note("trigger", nullptr, action->objectName().isEmpty() ? action->text() : action->objectName());
        action->trigger();
    }
}

void Monkey::click(QWidget& widget) {
    const QPoint at = pointIn(widget);
    const Qt::MouseButton button = isChance(80) ? Qt::LeftButton : isChance(75) ? Qt::RightButton : Qt::MiddleButton;
    m_modifiers = modifiers();
    note("click", &widget, QString("%1 %2,%3").arg(button).arg(at.x()).arg(at.y()));
    QWindow* window = widget.window()->windowHandle();
    addMouse(window, at, Qt::NoButton, Qt::NoButton, QEvent::MouseMove);
    for (int presses = isChance(25) ? 2 : 1; presses > 0; --presses) {
        addMouse(window, at, button, button, QEvent::MouseButtonPress);
        addMouse(window, at, Qt::NoButton, button, QEvent::MouseButtonRelease);
    }
    m_milliseconds += 1000;  // the next press is no double click
}

void Monkey::drag(QWidget& widget) {
    QPoint at = pointIn(widget);
    const Qt::MouseButton button = isChance(75) ? Qt::LeftButton : isChance(50) ? Qt::RightButton : Qt::MiddleButton;
    m_modifiers = modifiers();
    note("drag", &widget, QString("%1 %2,%3").arg(button).arg(at.x()).arg(at.y()));
    QWindow* window = widget.window()->windowHandle();
    addMouse(window, at, Qt::NoButton, Qt::NoButton, QEvent::MouseMove);
    addMouse(window, at, button, button, QEvent::MouseButtonPress);
    for (auto moves = m_random.below(kMaxDragSteps); moves > 0; --moves) {
        at = pointIn(widget);
        addMouse(window, at, button, Qt::NoButton, QEvent::MouseMove);
        if (isChance(3)) pressKey(widget);
    }
    addMouse(window, at, Qt::NoButton, button, QEvent::MouseButtonRelease);
    m_milliseconds += 1000;
}

void Monkey::turnWheel(QWidget& widget) {
    const QPoint at = pointIn(widget);
    const int angle = isChance(50) ? 120 : -120;
    const Qt::KeyboardModifiers held = modifiers();
    note("wheel", &widget, QString::number(angle));
    m_steps.push_back([window = QPointer(widget.window()->windowHandle()), at, angle, held] {
        if (!window) return;
        QWheelEvent event(at, window->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, held, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(window, &event);
    });
}

void Monkey::pressKey(QWidget& widget) {
    QWindow* window = widget.window()->windowHandle();
    if (isChance(50)) {
        const Qt::Key key = oneOf(kKeys);
        const Qt::KeyboardModifiers held = modifiers();
        note("key", &widget, QKeySequence(held | key).toString());
        return addKey(window, key, held, key == Qt::Key_Return ? "\r" : key == Qt::Key_Tab ? "\t" : "");
    }
    const QChar letter = QLatin1Char(oneOf(kLetters));
    const Qt::KeyboardModifiers held = modifiers();
    const bool isTyped = !(held & (Qt::ControlModifier | Qt::AltModifier));
    note("key", &widget, QKeySequence(held | Qt::Key(letter.toUpper().unicode())).toString());
    addKey(window, letter.toUpper().unicode(), held, isTyped ? QString(letter) : QString());
}

/// Clicks a field, types a value and often commits it.
void Monkey::enterValue(QWidget& window) {
    QWidget* field = widgetIn(window, isField);
    if (!field) return;
    const QString value = QString::fromUtf8(isChance(60) ? oneOf(kPlainValues) : oneOf(kOddValues));
    QWindow* handle = window.windowHandle();
    note("enter", field, value);
    const QPoint at = pointIn(*field);
    addMouse(handle, at, Qt::LeftButton, Qt::LeftButton, QEvent::MouseButtonPress);
    addMouse(handle, at, Qt::NoButton, Qt::LeftButton, QEvent::MouseButtonRelease);
    m_milliseconds += 1000;
    if (qobject_cast<QComboBox*>(field)) return;  // its popup gets the next events
    addKey(handle, Qt::Key_A, Qt::ControlModifier, {});
    addText(handle, value);
    if (isChance(35)) return addKey(handle, Qt::Key_Return, {}, "\r");
    if (isChance(60)) addKey(handle, Qt::Key_Tab, {}, "\t");
}

void Monkey::pressButton(QWidget& window) {
    QWidget* button = widgetIn(window, isButton);
    if (button) click(*button);
}

void Monkey::addMouse(QWindow* window, QPoint at, Qt::MouseButtons buttons, Qt::MouseButton button, QEvent::Type type) {
    const Qt::KeyboardModifiers held = m_modifiers;
    m_steps.push_back([this, window = QPointer(window), at, buttons, button, type, held] {
        m_milliseconds += 10;
        if (window) {
            qt_handleMouseEvent(window, at, window->mapToGlobal(at), buttons, button, type, held, m_milliseconds);
        }
    });
}

void Monkey::addKey(QWindow* window, int key, Qt::KeyboardModifiers modifiers, const QString& text) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        m_steps.push_back([window = QPointer(window), type, key, modifiers, text] {
            if (window) qt_handleKeyEvent(window, type, key, modifiers, text);
        });
    }
}

void Monkey::addText(QWindow* window, const QString& text) {
    for (const QChar letter : text) addKey(window, letter.toUpper().unicode(), {}, letter);
}

/// A visible, enabled widget of a window; null if there is none.
QWidget* Monkey::widgetIn(QWidget& window, const std::function<bool(const QWidget&)>& isWanted) {
    QWidgetList widgets = window.findChildren<QWidget*>();
    widgets.removeIf([&](const QWidget* widget) {
        return widget->window() != &window || !widget->isVisible() || !widget->isEnabled() ||
               widget->visibleRegion().isEmpty() || !isWanted(*widget);
    });
    return widgets.isEmpty() ? nullptr : oneOf(widgets);
}

/// A point of the visible part of a widget, in the coordinates of its window; in the canvas often a seed.
QPoint Monkey::pointIn(const QWidget& widget) {
    const auto* canvas = qobject_cast<const PatternCanvas*>(&widget);
    const auto pattern = canvas ? canvas->displayedPattern() : nullptr;
    if (pattern && !pattern->seeds().positions.empty() && isChance(40)) {
        const QPoint at = canvas->view().pixels(oneOf(pattern->seeds().positions)).toPoint();
        if (widget.rect().contains(at)) return widget.mapTo(widget.window(), at);
    }
    QRect rect = widget.visibleRegion().boundingRect();
    if (rect.isEmpty()) rect = widget.rect();
    const auto below = [this](int size) { return static_cast<int>(m_random.below(std::max(1U, unsigned(size)))); };
    return widget.mapTo(widget.window(), rect.topLeft() + QPoint(below(rect.width()), below(rect.height())));
}

Qt::KeyboardModifiers Monkey::modifiers() { return isChance(70) ? Qt::NoModifier : oneOf(kModifiers); }

void Monkey::note(std::string_view what, const QWidget* widget, const QString& detail) {
    QString text = QString::fromUtf8(what.data(), static_cast<qsizetype>(what.size()));
    if (widget) text += QString(" ") + widget->metaObject()->className() + ' ' + widget->objectName();
    m_journal.note("event", {(text + ' ' + detail).toStdString()});
}

}  // namespace rubble::attack
