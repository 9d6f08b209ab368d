#include "editor/ActionSearch.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {

namespace {

QString plain(QString text) { return text.remove('&').remove("…"); }

/// Where a word was found, the best place first.
enum Place { kNameBegins, kNameWordBegins, kMenuWordBegins, kWithinPath, kTipWordBegins, kWithinTip, kNowhere };

bool hasWordThatBegins(const QString& text, const QString& start) {
    for (qsizetype at = text.indexOf(start, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(start, at + 1, Qt::CaseInsensitive)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber()) return true;
    }
    return false;
}

Place placeOf(const QString& word, const QAction* action) {
    const QString name = plain(action->text()), path = pathOf(action), tip = action->statusTip();
    if (name.startsWith(word, Qt::CaseInsensitive)) return kNameBegins;
    if (hasWordThatBegins(name, word)) return kNameWordBegins;
    if (hasWordThatBegins(path, word)) return kMenuWordBegins;
    if (path.contains(word, Qt::CaseInsensitive)) return kWithinPath;
    if (hasWordThatBegins(tip, word)) return kTipWordBegins;
    return tip.contains(word, Qt::CaseInsensitive) ? kWithinTip : kNowhere;
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

QList<QAction*> actionsFor(const QString& words, const QList<QAction*>& actions) {
    const QStringList list = words.split(' ', Qt::SkipEmptyParts);
    std::vector<std::pair<int, QAction*>> found;  // with the sum of their words' places
    for (QAction* action : actions) {
        int sum = 0;
        bool hasAll = action->isEnabled();
        for (const QString& word : list) {
            const Place place = placeOf(word, action);
            sum += place;
            hasAll = hasAll && place != kNowhere;
        }
        if (hasAll) found.emplace_back(sum, action);
    }
    std::ranges::stable_sort(found, {}, &std::pair<int, QAction*>::first);
    QList<QAction*> sorted;
    for (const auto& [sum, action] : found) sorted.append(action);
    return sorted;
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
    for (QAction* action : actionsFor(words, m_actions)) {
        const QString path = pathOf(action);
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
