#pragma once

#include "editor/document/FragmentChoice.h"

#include <QObject>

#include <functional>
#include <memory>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;

/// Select menu: what is chosen of the asset at hand, seeds and fragments alike, and what of it is hidden.
class SelectActions : public QObject {
    Q_OBJECT
public:
    explicit SelectActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    /// What chooses by what is chosen: neighbours, siblings, parents, children.
    const QList<QAction*>& kinActions() const { return m_forChosen; }
    QList<QAction*> hidingActions() const { return m_forHiding + QList{m_showAll}; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Slot = void (SelectActions::*)();
    /// Gives another set of a bake's fragments for the chosen ones.
    using Change = std::function<FragmentSet(const Bake&, const FragmentSet&)>;

    void addKin();
    void addFigures();
    void addHiding();
    QAction* addInViews(const struct ActionLook& look, Slot slot);

    void chooseAll();
    void chooseNone();
    void invert();
    void chooseNeighbours();
    void chooseSiblings();
    void chooseParents();
    void chooseChildren();
    void chooseVolumes();
    void chooseRandomly();
    void hide();
    void isolate();
    void showAll();

    /// Null where the asset at hand was not baked.
    std::shared_ptr<const Bake> bake() const;
    /// Chooses what a change gives, or says why that is nothing.
    void change(const Change& change, const QString& sentenceIfNone);
    void takeBake();
    void update();

    MainWindow& m_window;
    QMenu* m_menu;
    QMenu* m_levels = nullptr;
    QAction* m_showAll = nullptr;
    QList<QAction*> m_forChosen;  // those that need something chosen
    QList<QAction*> m_forBake;    // those that need fragments
    QList<QAction*> m_forHiding;  // those that share their keys with what is done to instances
    quint64 m_randomSeed = 1;     // this and the next: as they were asked for last
    int m_percent = 50;
};

}  // namespace rubble
