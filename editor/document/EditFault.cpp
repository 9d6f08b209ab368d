#include "editor/document/EditFault.h"

#include "core/asset/checks/BondFaults.h"
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

    void add(const Replacement<Material>& replacement) {
        const Material* material = findMaterial(m_project, replacement.id);
        if (!material) return;
        note(Part::Material, replacement.id, faultOf(*material));
        for (const Asset& asset : m_project.assets) {
            if (asset.material == replacement.id && asset.contactTime)
                note(Part::Asset, asset.id, thresholdFault(asset, *material));
        }
    }
    void add(const Replacement<Asset>& replacement) {
        const Asset* asset = findAsset(m_project, replacement.id);
        if (!asset) return;
        note(Part::Asset, replacement.id, assetFault(m_project, *asset));
        // Edits share the surface; only imports bring another one.
        const bool isOther = asset->surface && !(replacement.value && replacement.value->surface == asset->surface);
        if (isOther)
            note(Part::Asset, replacement.id,
                 surfaceFault(ownerText("Asset", asset->id, asset->name), *asset->surface));
    }
    void add(const Replacement<Instance>& replacement) {
        addElement(Part::Instance, findById(m_project.instances, replacement.id));
    }
    void add(const Replacement<Shot>& replacement) {
        addElement(Part::Shot, findById(m_project.shots, replacement.id));
    }
    void add(const Replacement<PlayTest>& replacement) {
        addElement(Part::PlayTest, findById(m_project.playTests, replacement.id));
    }
    void add(const Replacement<Mortar>& replacement) {
        addElement(Part::Mortar, findById(m_project.mortars, replacement.id));
    }
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
    for (const AnyReplacement& replacement : edit.replacements)
        std::visit([&](const auto& values) { faults.add(values); }, replacement);
    return faults.finished();
}

}  // namespace

std::optional<std::string> editFault(Project& project, Edit& edit) {
    applyEdit(project, edit);
    Faults after;
    {
        const auto back = qScopeGuard([&] { revertEdit(project, edit); });  // also where memory runs out
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
