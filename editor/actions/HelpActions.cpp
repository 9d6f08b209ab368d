#include "editor/actions/HelpActions.h"

#include "editor/help/ActionSearch.h"
#include "editor/help/ManualWindow.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/InstalledData.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace rubble {

namespace {

void collectActions(const QMenu& menu, QList<QAction*>& actions) {
    for (QAction* action : menu.actions()) {
        if (QMenu* submenu = action->menu()) {
            emit submenu->aboutToShow();  // fills those that list what there is now, such as saved throws
            collectActions(*submenu, actions);
        } else if (!action->isSeparator()) {
            actions.append(action);
        }
    }
}

}  // namespace

HelpActions::HelpActions(QMainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Help"), &window)) {
    const auto add = actionAdder(*m_menu, this);
    add({"help-manual", tr("&Manual"), tr("Open the manual"), QKeySequence::HelpContents}, &HelpActions::openManual);
    add({"help-search", tr("&Search Actions…"), tr("Search all actions by name"), QKeySequence("Ctrl+Shift+P")},
        &HelpActions::searchActions);
    m_menu->addSeparator();
    add({"help-about", tr("&About Rubble"), tr("Show version and licence")}, &HelpActions::showAbout);
}

void HelpActions::openManual() {
    auto* manual = new ManualWindow(installedDataFolder() + "/docs/manual");
    manual->setAttribute(Qt::WA_DeleteOnClose);
    manual->show();
}

void HelpActions::searchActions() {
    QList<QAction*> actions;
    for (const QAction* menu : m_window.menuBar()->actions()) collectActions(*menu->menu(), actions);
    auto* search = new ActionSearch(actions, &m_window);
    search->setAttribute(Qt::WA_DeleteOnClose);
    search->show();
}

void HelpActions::showAbout() {
    QMessageBox::about(&m_window, tr("About Rubble"),
                       tr("<h3>Rubble %1</h3><p>An editor for destructible assets.</p>"
                          "<p>Free software under the MIT licence.</p><p>Made with Qt %2.</p>")
                           .arg(QApplication::applicationVersion(), qVersion()));
}

}  // namespace rubble

#include "moc_HelpActions.cpp"
