#include "editor/document/Edit.h"

#include "core/asset/project/Ids.h"
#include "core/base/Assert.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubble {

namespace {

/// The list of a project that holds the elements of one type, and their kind.
template <class Value>
struct ElementList {
    Part part;
    std::vector<Value> Project::*list;
};
template <class Value>
constexpr ElementList<Value> kElementList{};
template <>
constexpr ElementList<Material> kElementList<Material>{Part::Material, &Project::materials};
template <>
constexpr ElementList<Asset> kElementList<Asset>{Part::Asset, &Project::assets};
template <>
constexpr ElementList<Instance> kElementList<Instance>{Part::Instance, &Project::instances};
template <>
constexpr ElementList<Shot> kElementList<Shot>{Part::Shot, &Project::shots};
template <>
constexpr ElementList<PlayTest> kElementList<PlayTest>{Part::PlayTest, &Project::playTests};
template <>
constexpr ElementList<Mortar> kElementList<Mortar>{Part::Mortar, &Project::mortars};

/// The position of the element with an id, or where it would be inserted.
template <class List>
auto positionOf(List& list, Id id) {
    return std::ranges::lower_bound(list, id, {}, [](const auto& element) { return element.id; });
}

/// Makes room for an element that a replacement adds, beside `count` others, so that adding it cannot fail.
template <class Value>
void reserveFor(Project& project, const Replacement<Value>& replacement, std::size_t count) {
    auto& list = project.*kElementList<Value>.list;
    const auto position = positionOf(list, replacement.id);
    const bool isAdded = position == list.end() || position->id != replacement.id;
    if (isAdded && list.capacity() < list.size() + count) list.reserve(2 * list.size() + count);
}
void reserveFor(Project&, const SceneSettings&, std::size_t) {}

template <class Value>
Change exchange(Project& project, Replacement<Value>& replacement) {
    auto& list = project.*kElementList<Value>.list;
    const auto position = positionOf(list, replacement.id);
    const bool exists = position != list.end() && position->id == replacement.id;
    RUBBLE_ASSERT(!replacement.value || replacement.value->id == replacement.id);
    if (exists && replacement.value) {
        std::swap(*position, *replacement.value);
        return {kElementList<Value>.part, replacement.id, ChangeKind::Modified};
    }
    if (exists) {
        replacement.value = std::move(*position);
        list.erase(position);
        return {kElementList<Value>.part, replacement.id, ChangeKind::Removed};
    }
    RUBBLE_ASSERT(replacement.value);
    list.insert(position, std::move(*replacement.value));
    replacement.value.reset();
    return {kElementList<Value>.part, replacement.id, ChangeKind::Added};
}

Change exchange(Project& project, SceneSettings& scene) {
    std::swap(project.ground, scene.ground);
    std::swap(project.gravity, scene.gravity);
    std::swap(project.damage, scene.damage);
    std::swap(project.debris, scene.debris);
    std::swap(project.events, scene.events);
    return {Part::Scene, 0, ChangeKind::Modified};
}

template <class Value>
bool isSame(const Project& project, const Replacement<Value>& replacement) {
    const auto& list = project.*kElementList<Value>.list;
    const auto position = positionOf(list, replacement.id);
    const bool exists = position != list.end() && position->id == replacement.id;
    return exists ? replacement.value && *replacement.value == *position : !replacement.value;
}

bool isSame(const Project& project, const SceneSettings& scene) { return sceneSettings(project) == scene; }

template <class Value>
Id idOf(const Replacement<Value>& replacement) {
    return replacement.id;
}
Id idOf(const SceneSettings&) { return 0; }

bool areOfSameElement(const AnyReplacement& a, const AnyReplacement& b) {
    const auto id = [](const auto& replacement) { return idOf(replacement); };
    return a.index() == b.index() && std::visit(id, a) == std::visit(id, b);
}

}  // namespace

bool Changes::touches(Part part) const {
    return isEverything || std::ranges::find(list, part, &Change::part) != list.end();
}

bool Changes::touches(Part part, Id id) const {
    return isEverything ||
           std::ranges::any_of(list, [&](const Change& change) { return change.part == part && change.id == id; });
}

Id Edit::allocateId(const Project& project) {
    const Id id = nextId.value_or(project.nextId);
    if (id == std::numeric_limits<Id>::max()) return lastReused = lowestUnusedId(project, lastReused);
    nextId = id + 1;
    return id;
}

Changes applyEdit(Project& project, Edit& edit) {
    Changes changes;
    changes.list.reserve(edit.replacements.size());
    for (const AnyReplacement& replacement : edit.replacements)
        std::visit([&](const auto& values) { reserveFor(project, values, edit.replacements.size()); }, replacement);
    for (AnyReplacement& replacement : edit.replacements) {  // cannot fail from here
        changes.list.push_back(std::visit([&](auto& values) { return exchange(project, values); }, replacement));
    }
    if (edit.nextId) std::swap(project.nextId, *edit.nextId);
    return changes;
}

void revertEdit(Project& project, Edit& edit) {
    for (AnyReplacement& replacement : edit.replacements)
        std::visit([&](auto& values) { exchange(project, values); }, replacement);
    if (edit.nextId) std::swap(project.nextId, *edit.nextId);
}

void merge(Edit& earlier, Edit&& later) {
    earlier.replacements.reserve(earlier.replacements.size() +
                                 later.replacements.size());  // all or nothing where memory runs out
    for (AnyReplacement& replacement : later.replacements) {
        const auto isSameElement = [&](const AnyReplacement& other) { return areOfSameElement(replacement, other); };
        if (std::ranges::none_of(earlier.replacements, isSameElement))
            earlier.replacements.push_back(std::move(replacement));
    }
    if (!earlier.nextId) earlier.nextId = later.nextId;
}

bool isNoChange(const Project& project, const Edit& edit) {
    return (!edit.nextId || *edit.nextId == project.nextId) &&
           std::ranges::all_of(edit.replacements, [&](const AnyReplacement& replacement) {
               return std::visit([&](const auto& values) { return isSame(project, values); }, replacement);
           });
}

SceneSettings sceneSettings(const Project& project) {
    return {project.ground, project.gravity, project.damage, project.debris, project.events};
}

}  // namespace rubble
