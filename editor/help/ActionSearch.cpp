#include "editor/help/ActionSearch.h"

#include "editor/widgets/Buttons.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTimer>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <compare>
#include <utility>
#include <vector>

namespace rubble {

namespace {

/// Returns an action's text without mnemonic and ellipsis.
QString plain(QString text) { return text.remove('&').remove("…"); }

/// How well a word matches an action, the best match first.
enum Match { kNameStart, kNameWordStart, kMenuWordStart, kInPath, kTipWordStart, kInTip, kSynonym, kNone };

/// Words that mean the same to someone who searches, in lower case, separated by spaces.
const QStringList& synonyms() {
    static const QStringList groups{ActionSearch::tr("explode explosion explosive detonate blast bomb"),
                                    ActionSearch::tr("throw shoot fire launch ball projectile"),
                                    ActionSearch::tr("hammer hit strike smash"),
                                    ActionSearch::tr("break destroy shatter crack fracture"),
                                    ActionSearch::tr("picture image screenshot photo still"),
                                    ActionSearch::tr("film video movie animation record"),
                                    ActionSearch::tr("sound audio noise hear mute volume loud"),
                                    ActionSearch::tr("delete remove erase"),
                                    ActionSearch::tr("preferences settings options configuration"),
                                    ActionSearch::tr("simulate simulation play run start"),
                                    ActionSearch::tr("reset restart rewind"),
                                    ActionSearch::tr("random seed reseed variant"),
                                    ActionSearch::tr("zoom frame focus"),
                                    ActionSearch::tr("manual help documentation")};
    return groups;
}

bool hasWordStartingWith(const QString& text, const QString& start) {
    for (qsizetype at = text.indexOf(start, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(start, at + 1, Qt::CaseInsensitive)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber()) return true;
    }
    return false;
}

Match directMatch(const QString& word, const QAction* action) {
    const QString name = plain(action->text()), path = pathOf(action);
    const QString tip = action->statusTip() + '\n' + action->toolTip();  // which has the keys, too
    if (name.startsWith(word, Qt::CaseInsensitive)) return kNameStart;
    if (hasWordStartingWith(name, word)) return kNameWordStart;
    if (hasWordStartingWith(path, word)) return kMenuWordStart;
    if (path.contains(word, Qt::CaseInsensitive)) return kInPath;
    if (hasWordStartingWith(tip, word)) return kTipWordStart;
    return tip.contains(word, Qt::CaseInsensitive) ? kInTip : kNone;
}

/// A word of at least three letters also stands for its synonyms.
Match matchOf(const QString& word, const QAction* action) {
    constexpr int kMinLetters = 3;
    const Match direct = directMatch(word, action);
    if (direct != kNone || word.size() < kMinLetters) return direct;
    for (const QString& group : synonyms()) {
        if (!hasWordStartingWith(group, word)) continue;
        for (const QString& other : group.split(' ')) {
            if (directMatch(other, action) <= kTipWordStart) return kSynonym;
        }
    }
    return kNone;
}

constexpr QChar kPathSeparator(0x25b8);  // ▸

/// The order of matching actions.
struct Rank {
    bool isDisabled = false;
    int score = 0;  // the sum of the words' matches
    qsizetype depth = 0;
    auto operator<=>(const Rank&) const = default;
};

}  // namespace

QString pathOf(const QAction* action) {
    QString path = plain(action->text());
    for (const QObject* object : action->associatedObjects()) {
        const auto* menu = qobject_cast<const QMenu*>(object);
        if (menu && !menu->title().isEmpty()) return pathOf(menu->menuAction()) + " ▸ " + path;
    }
    return path;
}

QList<QAction*> matchingActions(const QString& query, const QList<QAction*>& actions) {
    const QStringList words = query.split(' ', Qt::SkipEmptyParts);
    std::vector<std::pair<Rank, QAction*>> found;
    for (QAction* action : actions) {
        // Commands before what a submenu lists, such as docks; those that can be triggered before all others.
        const qsizetype depth = pathOf(action).count(kPathSeparator);
        Rank rank{!action->isEnabled(), 0, depth};
        int& score = rank.score;
        bool isMatch = true;
        for (const QString& word : words) {
            const Match match = matchOf(word, action);
            score += match;
            isMatch = isMatch && match != kNone;
        }
        if (isMatch) found.emplace_back(rank, action);
    }
    std::ranges::stable_sort(found, {}, &std::pair<Rank, QAction*>::first);
    QList<QAction*> sorted;
    for (const auto& [rank, action] : found) sorted.append(action);
    return sorted;
}

ActionSearch::ActionSearch(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent, Qt::Popup),
      m_actions(actions.begin(), actions.end()),
      m_query(new QLineEdit),
      m_list(new QListWidget) {
    setAccessibleName(tr("Search actions"));
    m_query->setPlaceholderText(tr("Search actions"));
    addClearButton(*m_query);
    m_query->installEventFilter(this);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(m_query);
    layout->addWidget(m_list);
    connect(m_query, &QLineEdit::textChanged, this, &ActionSearch::filter);
    connect(m_query, &QLineEdit::returnPressed, this, &ActionSearch::triggerCurrent);
    connect(m_list, &QListWidget::itemClicked, this, &ActionSearch::triggerCurrent);
    resize(520, 360);
    move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, parent->height() / 8)));
    filter({});
    m_query->setFocus();
}

/// Arrow keys move through the list while the query has the focus.
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

void ActionSearch::filter(const QString& query) {
    m_list->clear();
    m_actions.removeAll(nullptr);
    const QList<QAction*> found = matchingActions(query, {m_actions.begin(), m_actions.end()});
    m_found = {found.begin(), found.end()};
    for (const QAction* action : found) {
        const QString path = pathOf(action);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(action->icon(), keys.isEmpty() ? path : path + "    " + keys, m_list);
        item->setToolTip(action->statusTip());
        if (!action->isEnabled()) {
            item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
            item->setText(tr("%1    not available now").arg(path));
        }
    }
    if (found.isEmpty()) {
        auto* item = new QListWidgetItem(tr("No action matches \"%1\". Try another word.").arg(query), m_list);
        item->setFlags(Qt::NoItemFlags);
    }
    m_list->setCurrentRow(0);
}

void ActionSearch::triggerCurrent() {
    const int row = m_list->currentRow();
    if (row < 0 || row >= static_cast<int>(m_found.size())) return;
    QAction* action = m_found[row];
    if (action && !action->isEnabled()) {
        return QToolTip::showText(m_list->mapToGlobal(m_list->visualItemRect(m_list->currentItem()).bottomLeft()),
                                  tr("Not available now: %1").arg(action->statusTip()), m_list);
    }
    accept();
    if (!action) return;
    QTimer::singleShot(0, action, &QAction::trigger);  // after the popup has closed and the window has the focus
}

}  // namespace rubble

#include "moc_ActionSearch.cpp"
