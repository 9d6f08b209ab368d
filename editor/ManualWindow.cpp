#include "editor/ManualWindow.h"

#include "editor/Action.h"
#include "editor/ManualPage.h"

#include <QFileInfo>
#include <QLineEdit>
#include <QToolBar>
#include <QUrl>

namespace rubble {

ManualWindow::ManualWindow(const QString& folder, const QPalette& palette) : m_page(new ManualPage) {
    setWindowTitle(tr("Rubble Manual"));
    setPalette(palette);
    m_page->setAccessibleName(tr("Manual page"));
    m_page->setSearchPaths({folder});
    m_page->setOpenExternalLinks(true);
    setCentralWidget(m_page);

    QToolBar* bar = addToolBar(tr("Navigation"));
    bar->setMovable(false);
    const auto add = [&](const ActionLook& look, void (QTextBrowser::*slot)()) {
        QAction* action = makeAction(this, look);
        connect(action, &QAction::triggered, m_page, slot);
        bar->addAction(action);
        return action;
    };
    QAction* back = add({"go-back", tr("Back"), tr("To the page before"), QKeySequence::Back}, &QTextBrowser::backward);
    add({"go-home", tr("Contents"), tr("To the first page"), QKeySequence("Alt+Home")}, &QTextBrowser::home);
    back->setEnabled(false);
    connect(m_page, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    auto* words = new QLineEdit;
    words->setPlaceholderText(tr("Find on this page"));
    words->setMaximumWidth(240);
    connect(words, &QLineEdit::returnPressed, this, [this, words] { find(words->text()); });
    auto* space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    bar->addWidget(words);

    if (QFileInfo::exists(folder + "/index.md")) {
        m_page->setSource(QUrl::fromLocalFile(folder + "/index.md"), QTextDocument::MarkdownResource);
    } else {
        m_page->setPlainText(tr("The manual is not installed: there is no \"%1\".").arg(folder));
    }
    resize(860, 900);
}

/// The next place with the words, from the top again after the last.
void ManualWindow::find(const QString& words) {
    if (m_page->find(words)) return;
    m_page->moveCursor(QTextCursor::Start);
    m_page->find(words);
}

}  // namespace rubble
