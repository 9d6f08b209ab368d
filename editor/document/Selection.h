#pragma once

#include "editor/document/Edit.h"
#include "editor/document/FragmentChoice.h"

#include <QObject>

#include <set>

namespace rubble {

/// What is chosen in one window, shared by tree, canvas, table and viewport. Not saved and not undone.
///
/// One asset is at hand: the one that canvas and tables show. The canvas is inside its whole, or inside one of its fragments that is
/// broken again. Seeds are those of the pattern in there; choosing one means choosing all fragments that come from it, and choosing some
/// of these chooses the seed, too. Hidden fragments are left out of pictures.
///
/// What was chosen last is the subject, which an inspector is about: a material, instances, an asset (choosing seeds counts
/// as choosing theirs), or the scene where nothing is chosen.
class Selection : public QObject {
    Q_OBJECT
public:
    using Seeds = FragmentChoice::Seeds;

    using QObject::QObject;

    Id asset() const { return m_asset; }
    /// The fragment whose pattern is seen and edited; empty: the whole.
    const FragmentPath& inside() const { return m_inside; }
    /// The chosen fragments, and the seeds that they come from.
    const FragmentChoice& choice() const { return m_choice; }
    /// The seeds of the pattern that is seen from which chosen fragments come.
    const Seeds& seeds() const { return m_seeds; }
    const FragmentChoice& hidden() const { return m_hidden; }
    const std::set<Id>& instances() const { return m_instances; }
    Id material() const { return m_material; }
    /// Part::Material, Asset, Instance or Scene.
    Part subject() const { return m_subject; }

    /// Takes an asset at hand; another one than before leaves no seed chosen or hidden, and is seen as a whole.
    void setAsset(Id asset);
    /// Goes into a fragment, or into the whole. What is chosen stays.
    void setInside(FragmentPath fragment);
    void setSeeds(Seeds seeds);
    void setChoice(FragmentChoice choice);
    /// Chooses the seed, or takes it out of the chosen ones.
    void toggleSeed(SeedId seed);
    void setHidden(FragmentChoice hidden);
    /// Chooses instances; their asset comes to hand where it is one.
    void setInstances(const Project& project, std::set<Id> instances);
    void setMaterial(Id material);
    /// Makes what is chosen of a part the subject; the scene where nothing of it is.
    void setSubject(Part subject);
    /// Forgets what the project does not hold any more.
    void prune(const Project& project);

signals:
    void assetChanged(rubble::Id asset);
    void insideChanged();
    /// Other seeds, or other fragments of theirs.
    void seedsChanged();
    void hiddenChanged();
    void instancesChanged();
    void materialChanged();
    void subjectChanged(rubble::Part subject);

private:
    void takeAsset(Id asset);

    Part m_subject = Part::Scene;
    Id m_asset = 0;
    Id m_material = 0;
    FragmentPath m_inside;
    FragmentChoice m_choice;
    Seeds m_seeds;  // of m_choice, inside m_inside
    FragmentChoice m_hidden;
    std::set<Id> m_instances;
};

}  // namespace rubble
