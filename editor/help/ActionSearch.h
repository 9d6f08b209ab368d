#pragma once

#include <QAction>
#include <QDialog>
#include <QPointer>

class QLineEdit;
class QListWidget;

namespace rubble {

/// A popup that finds an action by typed words and triggers it.
class ActionSearch : public QDialog {
    Q_OBJECT
public:
    explicit ActionSearch(const QList<QAction*>& actions, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& query);
    void triggerCurrent();

    // Actions may be removed meanwhile, such as those of recent files.
    QList<QPointer<QAction>> m_actions;
    QList<QPointer<QAction>> m_found;  // one per row
    QLineEdit* m_query;
    QListWidget* m_list;
};

/// Returns the actions that match every word of a query, enabled ones first, then by best match: words match the start
/// of the name, of a word in the name, of a word in the menus' names, any part of those, the start of a word in the
/// tip, any part of the tip, or, of three letters and more, by a synonym. Of equal matches, those in fewer menus come
/// first; else they keep their order.
QList<QAction*> matchingActions(const QString& query, const QList<QAction*>& actions);

/// Returns the name of an action after those of its menus: "File ▸ Save".
QString pathOf(const QAction* action);

}  // namespace rubble
