// Tests the shortcuts of editor/actions: in every context, a key has at most one meaning.
#include "core/asset/library/StarterProject.h"
#include "editor/views/Views.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"

#include <QAbstractItemView>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenuBar>

#include <map>
#include <set>

using namespace rubble;

namespace {

/// True if the action's shortcuts can fire while a widget has the focus.
bool isReachable(const QAction& action, const QWidget& focus) {
    if (!action.isEnabled()) return false;
    switch (action.shortcutContext()) {
        case Qt::WindowShortcut:
        case Qt::ApplicationShortcut: return true;
        case Qt::WidgetShortcut: return action.associatedObjects().contains(&focus);
        case Qt::WidgetWithChildrenShortcut:
            for (const QWidget* widget = &focus; widget != nullptr; widget = widget->parentWidget()) {
                if (action.associatedObjects().contains(widget)) return true;
            }
            return false;
    }
    return false;
}

}  // namespace

class ShortcutsTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() { openBaked(starterProject()); }
    void keysHaveOneMeaningInEveryContext() {
        const Id asset = project().assets.front().id, instance = project().instances.front().id;
        const auto baked = window().workspace().bakes().find(asset);
        QVERIFY(baked && baked->bake);
        const std::vector<std::pair<const char*, std::function<void()>>> selections{
            {"nothing", [&] { selection().setSeeds({}); }},
            {"the asset", [&] { selection().setAsset(asset); }},
            {"a fragment", [&] { window().findChild<QAction*>("select-all")->trigger(); }},
            {"an instance", [&] { selection().setInstances(project(), {instance}); }}};
        for (const bool isInPlay : {false, true}) {
            if (isInPlay) play();
            for (const auto& [name, select] : selections) {
                if (!isInPlay) select();
                for (QWidget* focus : focusWidgets()) checkKeys(name, *focus);
            }
        }
    }
    /// Alt and a letter opens a menu, unless the view has another meaning for it.
    void showAllPrecedesTheHelpMenu() {
        window().workspace().play().stop();
        for (QWidget* view : std::initializer_list<QWidget*>{&canvas(), &viewport()}) {
            QKeyEvent press(QEvent::ShortcutOverride, Qt::Key_H, Qt::AltModifier);
            press.ignore();
            QApplication::sendEvent(view, &press);
            QVERIFY(press.isAccepted());
        }
    }
    /// Otherwise Alt and the letter only move between the items.
    void mnemonicsAreDistinctInEveryMenu() {
        QStringList faults;
        const QList<QMenu*> menus = window().findChildren<QMenu*>();
        QVERIFY(menus.size() > 15);
        for (QMenu* menu : menus) {
            emit menu->aboutToShow();  // fills it
            std::map<QString, QStringList> items;
            for (const QAction* item : menu->actions()) {
                const QKeySequence key = QKeySequence::mnemonic(item->text());
                if (item->isVisible() && !key.isEmpty()) items[key.toString()] << item->text();
            }
            QString used;
            for (const auto& [key, texts] : items) used += key.back();
            for (const auto& [key, texts] : items) {
                if (texts.size() > 1) faults << QString("%1: %2 (used: %3)").arg(menu->title(), texts.join(", "), used);
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }
    /// After a click in a dock, and after Return in one of its fields.
    void keysOfPlayWorkInDocks() {
        play();
        advance(5);
        for (QWidget* focus : focusWidgets()) {
            if (focus == &canvas() || focus == &viewport() || qobject_cast<QLineEdit*>(focus)) continue;
            window().activateWindow();
            focus->setFocus();
            if (!focus->hasFocus()) continue;
            advance(5);
            QTest::keyClick(focus, Qt::Key_R);
            QTRY_COMPARE_WITH_TIMEOUT(controller().frame()->step, 0u, kPatience);
        }
        QLineEdit* field = nullptr;
        for (auto* dock : window().findChildren<QDockWidget*>()) {
            if (dock->objectName().contains("play-tools")) field = dock->findChild<QLineEdit*>();
        }
        QVERIFY(field);
        field->window()->activateWindow();
        for (QWidget* shown = field; shown != nullptr; shown = shown->parentWidget()) shown->show();
        field->setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(field->hasFocus(), kPatience);
        advance(5);
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(viewport().hasFocus());
    }
    void cleanupTestCase() { close(); }

private:
    PlayController& controller() { return window().workspace().play(); }
    void play() {
        controller().thread().useSteppedClock();
        controller().play();
        QTRY_VERIFY_WITH_TIMEOUT(controller().isPlaying() && controller().frame(), kPatience);
    }
    void advance(int steps) {
        if (!controller().isPlaying()) controller().play();
        for (int k = 0; k < steps; ++k) controller().thread().advance(kStep);
        controller().applyUpdate();
    }
    /// Both views, and the lists, tables and a text field of each dock.
    std::vector<QWidget*> focusWidgets() {
        std::vector<QWidget*> widgets{&canvas(), &viewport()};
        for (auto* dock : window().findChildren<QDockWidget*>()) {
            for (auto* view : dock->findChildren<QAbstractItemView*>()) {
                if (view->focusPolicy() != Qt::NoFocus && view->isVisibleTo(dock)) widgets.push_back(view);
            }
            if (auto* line = dock->findChild<QLineEdit*>()) widgets.push_back(line);
        }
        return widgets;
    }
    void checkKeys(const QString& selected, QWidget& focus) {
        std::map<QString, std::set<const QAction*>> meanings;
        for (const QAction* action : window().findChildren<QAction*>()) {
            if (!isReachable(*action, focus)) continue;
            for (const QKeySequence& key : action->shortcuts()) meanings[key.toString()].insert(action);
        }
        for (const QAction* menu : window().menuBar()->actions()) {
            const QKeySequence key = QKeySequence::mnemonic(menu->text());
            if (!key.isEmpty()) meanings[key.toString()].insert(menu);
        }
        QVERIFY(meanings.size() > 20);
        for (const auto& [key, actions] : meanings) {
            if (actions.size() < 2 || isHandledBy(focus, QKeySequence(key))) continue;
            QStringList names;
            for (const QAction* action : actions) names << action->text();
            QFAIL(qPrintable(key + " means " + names.join(" and ") + " in " + focus.metaObject()->className() + ' ' +
                             focus.objectName() + " with " + selected + " selected"));
        }
    }
    /// True if the widget takes the key before any shortcut.
    static bool isHandledBy(QWidget& focus, const QKeySequence& key) {
        QKeyEvent event(QEvent::ShortcutOverride, key[0].key(), key[0].keyboardModifiers());
        event.ignore();
        QApplication::sendEvent(&focus, &event);
        return event.isAccepted();
    }
};

RUBBLE_TEST_WITH(ShortcutsTest, QApplication)
#include "ShortcutsTest.moc"
