#include "editor/ActionSearch.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>

namespace rubble {

namespace {

QString plain(QString text) { return text.remove('&').remove("…"); }

/// True where each word stands somewhere in the text.
bool hasWords(const QString& text, const QString& words) {
    const QStringList list = words.split(' ', Qt::SkipEmptyParts);
    return std::all_of(list.begin(), list.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

QString pathOf(const QAction* action) {
    QString path = plain(action->text());
    for (const QObject* object : action->associatedObjects()) {
        const auto* menu = qobject_cast<const QMenu*>(object);
        if (menu && !menu->title().isEmpty()) return pathOf(menu->menuAction()) + " ▸ " + path;
    }
    return path;
}

ActionSearch::ActionSearch(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent, Qt::Popup), m_actions(actions), m_words(new QLineEdit), m_list(new QListWidget) {
    setAccessibleName(tr("Search actions"));
    m_words->setPlaceholderText(tr("What do you want to do?"));
    m_words->setClearButtonEnabled(true);
    m_words->installEventFilter(this);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(m_words);
    layout->addWidget(m_list);
    connect(m_words, &QLineEdit::textChanged, this, &ActionSearch::filter);
    connect(m_words, &QLineEdit::returnPressed, this, &ActionSearch::run);
    connect(m_list, &QListWidget::itemClicked, this, &ActionSearch::run);
    resize(520, 360);
    move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, parent->height() / 8)));
    filter({});
    m_words->setFocus();
}

/// Arrow keys go through the list while words are typed.
bool ActionSearch::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int by = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (by != 0) {
            m_list->setCurrentRow(std::clamp(m_list->currentRow() + by, 0, m_list->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void ActionSearch::filter(const QString& words) {
    m_list->clear();
    for (QAction* action : m_actions) {
        const QString path = pathOf(action);
        if (!action->isEnabled() || !hasWords(path + ' ' + action->statusTip(), words)) continue;
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(action->icon(), keys.isEmpty() ? path : path + "    " + keys, m_list);
        item->setToolTip(action->statusTip());
        item->setData(Qt::UserRole, QVariant::fromValue(action));
    }
    m_list->setCurrentRow(0);
}

void ActionSearch::run() {
    const QListWidgetItem* item = m_list->currentItem();
    if (!item) return;
    auto* action = item->data(Qt::UserRole).value<QAction*>();
    accept();
    QTimer::singleShot(0, action, &QAction::trigger);  // when this is gone and the window has the focus again
}

}  // namespace rubble
