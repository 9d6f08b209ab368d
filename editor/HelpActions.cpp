#include "editor/HelpActions.h"

#include "editor/Action.h"
#include "editor/ActionSearch.h"
#include "editor/MainWindow.h"
#include "editor/ManualWindow.h"
#include "editor/Program.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace rubble {

namespace {

void addActionsOf(const QMenu& menu, QList<QAction*>& actions) {
    for (QAction* action : menu.actions()) {
        if (action->menu()) {
            addActionsOf(*action->menu(), actions);
        } else if (!action->isSeparator()) {
            actions.append(action);
        }
    }
}

}  // namespace

HelpActions::HelpActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Help"), &window)) {
    const auto add = addingTo(*m_menu, this);
    add({"help-manual", tr("&Manual"), tr("Open the manual"), QKeySequence::HelpContents}, &HelpActions::openManual);
    add({"help-search", tr("&Search Actions…"), tr("Find anything the program can do"), QKeySequence("Ctrl+Shift+P")},
        &HelpActions::search);
    m_menu->addSeparator();
    add({"help-about", tr("&About Rubble"), tr("Version and licence")}, &HelpActions::about);
}

void HelpActions::openManual() {
    auto* manual = new ManualWindow(Program::dataFolder() + "/docs/manual", m_window.palette());
    manual->setAttribute(Qt::WA_DeleteOnClose);
    manual->show();
}

void HelpActions::search() {
    QList<QAction*> actions;
    for (const QAction* menu : m_window.menuBar()->actions()) addActionsOf(*menu->menu(), actions);
    auto* search = new ActionSearch(actions, &m_window);
    search->setAttribute(Qt::WA_DeleteOnClose);
    search->show();
}

void HelpActions::about() {
    QMessageBox::about(&m_window, tr("About Rubble"),
                       tr("<h3>Rubble %1</h3><p>A desktop editor for destructible assets.</p>"
                          "<p>Free software under the MIT licence.</p><p>Made with Qt %2.</p>")
                           .arg(QApplication::applicationVersion(), qVersion()));
}

}  // namespace rubble
