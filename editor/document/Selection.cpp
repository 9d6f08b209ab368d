#include "editor/document/Selection.h"

#include <algorithm>
#include <utility>

namespace rubble {

void Selection::setAsset(Id asset) {
    activate(asset);
    setSubject(Part::Asset);
}

void Selection::activate(Id asset) {
    if (asset == m_asset) return;
    m_asset = asset;
    const bool hadEntered = !std::exchange(m_enteredFragment, {}).empty();
    m_fragments = {};
    m_seeds.clear();
    m_hidden = {};
    emit assetChanged(asset);
    if (hadEntered) emit enteredFragmentChanged();
    emit seedsChanged();
    emit hiddenChanged();
}

void Selection::setClusterLevel(std::uint32_t level) {
    if (level == m_clusterLevel) return;
    m_clusterLevel = level;
    emit clusterLevelChanged();
}

void Selection::setEnteredFragment(FragmentPath fragment) {
    if (fragment == m_enteredFragment) return;
    m_enteredFragment = std::move(fragment);
    m_seeds = m_fragments.seedsOf(m_enteredFragment);
    emit enteredFragmentChanged();
    emit seedsChanged();
}

void Selection::setSeeds(Seeds seeds) { setFragments({std::move(seeds), std::nullopt, m_enteredFragment}); }

void Selection::setFragments(FragmentSelection fragments) {
    if (fragments.isEmpty()) fragments = {};
    if (fragments == m_fragments) return;
    m_fragments = std::move(fragments);
    m_seeds = m_fragments.seedsOf(m_enteredFragment);
    emit seedsChanged();
    if (!m_fragments.isEmpty()) setSubject(Part::Asset);
}

void Selection::toggleSeed(SeedId seed) {
    Seeds seeds = m_seeds;
    if (!seeds.insert(seed).second) seeds.erase(seed);
    setSeeds(std::move(seeds));
}

void Selection::setHidden(FragmentSelection hidden) {
    if (hidden == m_hidden) return;
    m_hidden = std::move(hidden);
    emit hiddenChanged();
}

void Selection::setInstances(const Project& project, std::set<Id> instances) {
    std::set<Id> assets;
    for (const Instance& instance : project.instances) {
        if (instances.contains(instance.id)) assets.insert(instance.asset);
    }
    if (assets.size() == 1) activate(*assets.begin());
    if (instances != m_instances) {
        m_instances = std::move(instances);
        emit instancesChanged();
    }
    if (!m_instances.empty() || m_subject == Part::Instance) setSubject(Part::Instance);
}

void Selection::setMaterial(Id material) {
    if (material != m_material) {
        m_material = material;
        emit materialChanged();
    }
    if (material != 0 || m_subject == Part::Material) setSubject(Part::Material);
}

void Selection::setMortar(Id mortar) {
    if (mortar == m_mortar) return;
    m_mortar = mortar;
    emit mortarChanged();
}

void Selection::setSubject(Part subject) {
    const bool isSelected = (subject == Part::Material && m_material != 0) ||
                            (subject == Part::Asset && m_asset != 0) ||
                            (subject == Part::Instance && !m_instances.empty());
    const Part effective = isSelected ? subject : Part::Scene;
    if (effective == m_subject) return;
    m_subject = effective;
    emit subjectChanged(effective);
}

void Selection::prune(const Project& project) {
    std::set<Id> instances = m_instances;
    std::erase_if(instances, [&](Id id) { return findInstance(project, id) == nullptr; });
    if (!findAsset(project, m_asset)) setAsset(project.assets.empty() ? 0 : project.assets.front().id);
    if (!findMaterial(project, m_material)) setMaterial(0);
    if (!findMortar(project, m_mortar)) setMortar(0);
    if (instances != m_instances) setInstances(project, std::move(instances));
}

}  // namespace rubble

#include "moc_Selection.cpp"
