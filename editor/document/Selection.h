#pragma once

#include "editor/document/Edit.h"

#include <QObject>

#include <set>

namespace rubble {

/// What is chosen in one window, shared by tree, canvas, table and viewport. Not saved and not undone.
///
/// One asset is at hand: the one that canvas and tables show. Seeds are those of its pattern; choosing a fragment means
/// choosing the seed it comes from. Hidden fragments are left out of pictures.
///
/// What was chosen last is the subject, which an inspector is about: a material, instances, an asset (choosing seeds counts
/// as choosing theirs), or the scene where nothing is chosen.
class Selection : public QObject {
    Q_OBJECT
public:
    using Seeds = std::set<SeedId>;

    using QObject::QObject;

    Id asset() const { return m_asset; }
    const Seeds& seeds() const { return m_seeds; }
    const Seeds& hiddenSeeds() const { return m_hiddenSeeds; }
    const std::set<Id>& instances() const { return m_instances; }
    Id material() const { return m_material; }
    /// Part::Material, Asset, Instance or Scene.
    Part subject() const { return m_subject; }

    /// Takes an asset at hand; another one than before leaves no seed chosen or hidden.
    void setAsset(Id asset);
    void setSeeds(Seeds seeds);
    /// Chooses the seed, or takes it out of the chosen ones.
    void toggleSeed(SeedId seed);
    void setHiddenSeeds(Seeds seeds);
    /// Chooses instances; their asset comes to hand where it is one.
    void setInstances(const Project& project, std::set<Id> instances);
    void setMaterial(Id material);
    /// Makes what is chosen of a part the subject; the scene where nothing of it is.
    void setSubject(Part subject);
    /// Forgets what the project does not hold any more.
    void prune(const Project& project);

signals:
    void assetChanged(rubble::Id asset);
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
    Seeds m_seeds;
    Seeds m_hiddenSeeds;
    std::set<Id> m_instances;
};

}  // namespace rubble
