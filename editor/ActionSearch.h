#pragma once

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace rubble {

/// Finds an action of a window by what it is called, and carries it out: everything a program can do, by typing a few
/// letters of it.
class ActionSearch : public QDialog {
    Q_OBJECT
public:
    explicit ActionSearch(const QList<QAction*>& actions, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& words);
    void run();

    QList<QAction*> m_actions;
    QLineEdit* m_words;
    QListWidget* m_list;
};

/// The actions that can be carried out now and bear each of some words, or of their beginnings, in their name, their menus'
/// names or their tip: names before menus, those before tips, beginnings of words before what is within; then in the order given.
QList<QAction*> actionsFor(const QString& words, const QList<QAction*>& actions);

/// All actions of menus with what leads to them: "File ▸ Save".
QString pathOf(const QAction* action);

}  // namespace rubble
