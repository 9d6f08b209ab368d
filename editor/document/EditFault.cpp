#include "editor/document/EditFault.h"

#include "core/asset/checks/PlayFaults.h"
#include "core/asset/checks/ValueFaults.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Names.h"
#include "core/asset/project/SurfaceFault.h"

#include <QScopeGuard>

#include <map>

namespace rubble {

namespace {

using Sentence = std::optional<std::string>;
/// By element; those of derived thresholds by asset.
using Faults = std::map<std::pair<Part, Id>, std::string>;

Sentence assetFault(const Project& project, const Asset& asset) {
    if (Sentence fault = faultOf(asset)) return fault;
    const Material* material = findMaterial(project, asset.material);
    return material ? thresholdFault(asset, *material) : std::nullopt;
}

/// Faults of the project's elements that the edit changes.
class ChangedFaults {
public:
    explicit ChangedFaults(const Project& project) : m_project(project) {}

    void add(const Swap<Material>& swap) {
        const Material* material = findMaterial(m_project, swap.id);
        if (!material) return;
        note(Part::Material, swap.id, faultOf(*material));
        for (const Asset& asset : m_project.assets) {
            if (asset.material == swap.id && asset.contactTime)
                note(Part::Asset, asset.id, thresholdFault(asset, *material));
        }
    }
    void add(const Swap<Asset>& swap) {
        const Asset* asset = findAsset(m_project, swap.id);
        if (!asset) return;
        note(Part::Asset, swap.id, assetFault(m_project, *asset));
        // Edits share the surface; only imports bring another one.
        const bool isOther = asset->surface && !(swap.value && swap.value->surface == asset->surface);
        if (isOther)
            note(Part::Asset, swap.id, surfaceFault(ownerText("Asset", asset->id, asset->name), *asset->surface));
    }
    void add(const Swap<Instance>& swap) { addElement(Part::Instance, findById(m_project.instances, swap.id)); }
    void add(const Swap<Shot>& swap) { addElement(Part::Shot, findById(m_project.shots, swap.id)); }
    void add(const Swap<PlayTest>& swap) { addElement(Part::PlayTest, findById(m_project.playTests, swap.id)); }
    void add(const SceneSettings&) { note(Part::Scene, 0, sceneFault(m_project)); }

    Faults finished() { return std::move(m_faults); }

private:
    template <class Element>
    void addElement(Part part, const Element* element) {
        if (element) note(part, element->id, faultOf(*element));
    }
    void note(Part part, Id id, const Sentence& fault) {
        if (fault) m_faults.try_emplace({part, id}, *fault);
    }

    const Project& m_project;
    Faults m_faults;
};

Faults faultsOf(const Project& project, const Edit& edit) {
    ChangedFaults faults(project);
    for (const AnySwap& swap : edit.swaps) std::visit([&](const auto& values) { faults.add(values); }, swap);
    return faults.finished();
}

}  // namespace

std::optional<std::string> editFault(Project& project, Edit& edit) {
    swapInto(project, edit);
    Faults after;
    {
        const auto back = qScopeGuard([&] { swapBack(project, edit); });  // also where memory runs out
        after = faultsOf(project, edit);
    }
    if (after.empty()) return std::nullopt;
    const Faults before = faultsOf(project, edit);
    for (const auto& [element, fault] : after) {
        if (!before.contains(element)) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble
