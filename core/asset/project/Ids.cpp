#include "core/asset/project/Ids.h"

#include <algorithm>
#include <limits>
#include <set>

namespace rubble {
namespace {

void addLayers(const Pattern& pattern, std::set<Id>& ids) {
    for (const PatternLayer& layer : pattern.layers) ids.insert(layer.id);
}

std::set<Id> usedIds(const Project& project) {
    std::set<Id> ids;
    const auto add = [&](const auto& elements) {
        for (const auto& element : elements) ids.insert(element.id);
    };
    add(project.materials);
    add(project.assets);
    add(project.instances);
    add(project.shots);
    add(project.playTests);
    add(project.mortars);
    for (const Asset& asset : project.assets) {
        addLayers(asset.pattern, ids);
        for (const Level& level : asset.levels) addLayers(level.pattern, ids);
        for (const FragmentLevel& leaf : asset.fragmentLevels) {
            if (leaf.level) addLayers(leaf.level->pattern, ids);
        }
    }
    return ids;
}

}  // namespace

Id lowestUnusedId(const Project& project, Id after) {
    const std::set<Id> used = usedIds(project);
    Id id = after + 1;
    for (auto next = used.lower_bound(id); next != used.end() && *next == id; ++next) ++id;
    return id;
}

Id allocateId(Project& project) {
    return project.nextId < std::numeric_limits<Id>::max() ? project.nextId++ : lowestUnusedId(project);
}

bool isAmong(std::span<const Id> ids, Id id) { return std::ranges::find(ids, id) != ids.end(); }

}  // namespace rubble
