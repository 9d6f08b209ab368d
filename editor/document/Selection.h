#pragma once

#include "editor/document/Edit.h"
#include "editor/document/FragmentSelection.h"

#include <QObject>

#include <set>

namespace rubble {

/// The selection of one window, shared by tree, canvas, table and viewport. It is neither saved nor undone.
///
/// One asset is active: canvas and tables show it. The canvas shows the pattern of the whole asset, or of one of its
/// fractured fragments that was entered. Selecting a seed of that pattern selects all fragments that come from it;
/// selecting some of these fragments selects the seed, too. Hidden fragments are not drawn.
///
/// The inspector shows the subject, which is what was selected last: a material, instances, an asset (also by its
/// seeds), or the scene if nothing is selected.
class Selection : public QObject {
    Q_OBJECT
public:
    using Seeds = FragmentSelection::Seeds;

    using QObject::QObject;

    /// The active asset; 0 if there is none.
    Id asset() const { return m_asset; }
    /// The fragment whose pattern is shown and edited; empty: the whole asset.
    const FragmentPath& enteredFragment() const { return m_enteredFragment; }
    /// The selected fragments and the seeds that they come from.
    const FragmentSelection& fragments() const { return m_fragments; }
    /// The seeds of the shown pattern that selected fragments come from.
    const Seeds& seeds() const { return m_seeds; }
    const FragmentSelection& hidden() const { return m_hidden; }
    /// The level of clusters of fragments that is edited.
    std::uint32_t clusterLevel() const { return m_clusterLevel; }
    const std::set<Id>& instances() const { return m_instances; }
    Id material() const { return m_material; }
    /// The mortar whose numbers and joints are shown; 0: none.
    Id mortar() const { return m_mortar; }
    /// Part::Material, Asset, Instance or Scene.
    Part subject() const { return m_subject; }

    /// Makes an asset active. A change of asset clears the selected and hidden fragments and exits the entered
    /// fragment.
    void setAsset(Id asset);
    /// Enters a fragment; an empty path shows the whole asset. The selection is kept.
    void setEnteredFragment(FragmentPath fragment);
    void setSeeds(Seeds seeds);
    void setFragments(FragmentSelection fragments);
    /// Adds the seed to the selection or removes it.
    void toggleSeed(SeedId seed);
    void setHidden(FragmentSelection hidden);
    void setClusterLevel(std::uint32_t level);
    /// Selects instances. Their asset becomes active if all have the same.
    void setInstances(const Project& project, std::set<Id> instances);
    void setMaterial(Id material);
    void setMortar(Id mortar);
    /// Makes the selected elements of this kind the subject, or the scene if none is selected.
    void setSubject(Part subject);
    /// Removes everything that is not in the project.
    void prune(const Project& project);

signals:
    void assetChanged(rubble::Id asset);
    void enteredFragmentChanged();
    /// The selected seeds or fragments changed.
    void seedsChanged();
    void hiddenChanged();
    void clusterLevelChanged();
    void instancesChanged();
    void materialChanged();
    void mortarChanged();
    void subjectChanged(rubble::Part subject);

private:
    void activate(Id asset);

    Part m_subject = Part::Scene;
    Id m_asset = 0;
    Id m_material = 0;
    Id m_mortar = 0;
    FragmentPath m_enteredFragment;
    FragmentSelection m_fragments;
    Seeds m_seeds;  // of m_fragments, in the pattern of m_enteredFragment
    FragmentSelection m_hidden;
    std::uint32_t m_clusterLevel = 0;
    std::set<Id> m_instances;
};

}  // namespace rubble
