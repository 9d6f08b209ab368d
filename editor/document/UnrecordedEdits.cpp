#include "editor/document/UnrecordedEdits.h"

#include <algorithm>

namespace rubble {

namespace {

/// Copies an element, or notes that it is gone.
template <class Element>
void add(Id id, const std::vector<Element>& list, std::vector<Element>& values, std::vector<Id>& removed) {
    const auto at = std::ranges::lower_bound(list, id, {}, &Element::id);
    if (at != list.end() && at->id == id) {
        values.push_back(*at);
    } else {
        removed.push_back(id);
    }
}

}  // namespace

void UnrecordedEdits::note(const Changes& changes) {
    m_isEverything = m_isEverything || changes.isEverything;
    for (const Change& change : changes.list) m_elements.emplace(change.part, change.id);
}

void UnrecordedEdits::forget(const Project& project) {
    m_elements.clear();
    m_isEverything = false;
    m_textures.clear();
    for (const Asset& asset : project.assets) {
        if (asset.texture) m_textures.emplace(asset.id, *asset.texture);
    }
}

ProjectPart UnrecordedEdits::take(const Project& project) {
    ProjectPart part{.values = {.identity = project.identity,
                                .nextId = project.nextId,
                                .ground = project.ground,
                                .gravity = project.gravity,
                                .damage = project.damage,
                                .debris = project.debris,
                                .events = project.events}};
    Project& values = part.values;
    for (const auto& [kind, id] : m_elements) {
        switch (kind) {
            case Part::Material: add(id, project.materials, values.materials, part.removedMaterials); break;
            case Part::Asset: add(id, project.assets, values.assets, part.removedAssets); break;
            case Part::Instance: add(id, project.instances, values.instances, part.removedInstances); break;
            case Part::Shot: add(id, project.shots, values.shots, part.removedShots); break;
            case Part::PlayTest: add(id, project.playTests, values.playTests, part.removedPlayTests); break;
            case Part::Mortar: add(id, project.mortars, values.mortars, part.removedMortars); break;
            case Part::Scene: break;  // always there
        }
    }
    m_elements.clear();
    for (const Id id : part.removedAssets) m_textures.erase(id);
    for (Asset& asset : values.assets) {
        if (!asset.texture) {
            m_textures.erase(asset.id);
        } else if (const auto known = m_textures.find(asset.id);
                   known != m_textures.end() && known->second == *asset.texture) {
            asset.texture.reset();
            part.keptTextures.push_back(asset.id);
        } else {
            m_textures.insert_or_assign(asset.id, *asset.texture);
        }
    }
    return part;
}

}  // namespace rubble
