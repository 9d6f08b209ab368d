#pragma once

#include "editor/document/FragmentSelection.h"

#include <QObject>

#include <functional>
#include <memory>

class QAction;
class QMenu;

namespace rubble {

class PreferenceStore;
class Views;
class VisibilityActions;
class Workspace;
struct ActionDefinition;
struct BakedPattern;

/// The Select menu: selecting seeds and fragments of the active asset.
class SelectActions : public QObject {
    Q_OBJECT
public:
    SelectActions(Views& views, const PreferenceStore& preferences, const VisibilityActions& visibility);

    QMenu* menu() const { return m_menu; }
    /// Neighbours, siblings, parents and children of the selection.
    const QList<QAction*>& relatedActions() const { return m_needSelection; }

private:
    using Slot = void (SelectActions::*)();
    /// Maps the selected fragments of a bake to others.
    using Mapping = std::function<FragmentSet(const Bake&, const FragmentSet&)>;

    void addRelated();
    void addByValue();
    QAction* addInViews(const ActionDefinition& definition, Slot slot);

    void selectAll();
    void selectNone();
    void invert();
    void selectNeighbours();
    void selectSiblings();
    void selectParents();
    void selectChildren();
    void selectLevel(std::uint32_t level);
    void selectByVolume();
    void selectRandomly();

    /// Returns the bake of the active asset, or null if there is none.
    bool areInstancesSelected() const;
    std::shared_ptr<const Bake> bake() const;
    /// Returns the pattern shown in the canvas, or null if there is none.
    std::shared_ptr<const BakedPattern> pattern() const;
    /// Selects what a mapping returns; if that is nothing, shows a sentence instead.
    void selectBy(const Mapping& mapping, const QString& sentenceIfEmpty);
    void updateLevels();
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    const PreferenceStore& m_preferences;
    QMenu* m_menu;
    QMenu* m_levels = nullptr;
    QList<QAction*> m_needSelection;  // enabled while seeds or fragments are selected
    QList<QAction*> m_needBake;       // enabled while there is a bake
    quint64 m_randomSeed = 1;         // this and the next: as last entered in the dialog
    int m_percent = 50;
};

}  // namespace rubble
