#include "editor/help/ManualWindow.h"

#include "editor/help/ManualPage.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/ScreenFit.h"

#include <QFileInfo>
#include <QLineEdit>
#include <QToolBar>
#include <QUrl>

namespace rubble {

ManualWindow::ManualWindow(const QString& folder) : m_page(new ManualPage) {
    setWindowTitle(tr("Rubble Manual"));
    m_page->setAccessibleName(tr("Manual page"));
    m_page->setSearchPaths({folder});
    m_page->setOpenExternalLinks(true);
    setCentralWidget(m_page);

    QToolBar* bar = addToolBar(tr("Navigation"));
    bar->setMovable(false);
    const auto add = [&](const ActionDefinition& definition, void (QTextBrowser::*slot)()) {
        QAction* action = makeAction(this, definition);
        connect(action, &QAction::triggered, m_page, slot);
        bar->addAction(action);
        return action;
    };
    QAction* back =
        add({"go-back", tr("Back"), tr("Go to the previous page"), QKeySequence::Back}, &QTextBrowser::backward);
    add({"go-home", tr("Contents"), tr("Go to the table of contents"), QKeySequence("Alt+Home")}, &QTextBrowser::home);
    back->setEnabled(false);
    auto* close = new QAction(this);
    close->setShortcuts({QKeySequence(Qt::Key_Escape), QKeySequence(QKeySequence::Close)});
    connect(close, &QAction::triggered, this, &QWidget::close);
    addAction(close);
    connect(m_page, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    auto* search = new QLineEdit;
    search->setPlaceholderText(tr("Find on this page"));
    search->setMaximumWidth(240);
    connect(search, &QLineEdit::returnPressed, this, [this, search] { findNext(search->text()); });
    auto* space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    bar->addWidget(search);

    if (QFileInfo::exists(folder + "/index.md")) {
        m_page->setSource(QUrl::fromLocalFile(folder + "/index.md"), QTextDocument::MarkdownResource);
    } else {
        m_page->setPlainText(
            tr("The manual is not installed: the folder \"%1\" is missing. Reinstall Rubble.").arg(folder));
    }
    resizeWithinScreen(*this, {860, 900});
}

/// Finds the next occurrence, continuing at the top of the page.
void ManualWindow::findNext(const QString& text) {
    if (m_page->find(text)) return;
    m_page->moveCursor(QTextCursor::Start);
    m_page->find(text);
}

}  // namespace rubble

#include "moc_ManualWindow.cpp"
