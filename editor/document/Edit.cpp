#include "editor/document/Edit.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

/// Where a project keeps things of one kind, and what the kind is called in changes.
template <class Value>
struct Home {
    Part part;
    std::vector<Value> Project::*list;
};
template <class Value>
constexpr Home<Value> kHome{};
template <>
constexpr Home<Material> kHome<Material>{Part::Material, &Project::materials};
template <>
constexpr Home<Asset> kHome<Asset>{Part::Asset, &Project::assets};
template <>
constexpr Home<Instance> kHome<Instance>{Part::Instance, &Project::instances};
template <>
constexpr Home<Shot> kHome<Shot>{Part::Shot, &Project::shots};
template <>
constexpr Home<PlayTest> kHome<PlayTest>{Part::PlayTest, &Project::playTests};

/// Where the thing with an id stands, or would.
template <class List>
auto placeOf(List& list, Id id) {
    return std::ranges::lower_bound(list, id, {}, [](const auto& element) { return element.id; });
}

template <class Value>
Change exchange(Project& project, Swap<Value>& swap) {
    auto& list = project.*kHome<Value>.list;
    const auto place = placeOf(list, swap.id);
    const bool isThere = place != list.end() && place->id == swap.id;
    RUBBLE_ASSERT(!swap.value || swap.value->id == swap.id);
    if (isThere && swap.value) {
        std::swap(*place, *swap.value);
        return {kHome<Value>.part, swap.id, ChangeKind::Altered};
    }
    if (isThere) {
        swap.value = std::move(*place);
        list.erase(place);
        return {kHome<Value>.part, swap.id, ChangeKind::Removed};
    }
    RUBBLE_ASSERT(swap.value);
    list.insert(place, std::move(*swap.value));
    swap.value.reset();
    return {kHome<Value>.part, swap.id, ChangeKind::Added};
}

Change exchange(Project& project, SceneSettings& scene) {
    std::swap(project.ground, scene.ground);
    std::swap(project.gravity, scene.gravity);
    std::swap(project.damage, scene.damage);
    std::swap(project.debris, scene.debris);
    return {Part::Scene, 0, ChangeKind::Altered};
}

template <class Value>
bool isSame(const Project& project, const Swap<Value>& swap) {
    const auto& list = project.*kHome<Value>.list;
    const auto place = placeOf(list, swap.id);
    const bool isThere = place != list.end() && place->id == swap.id;
    return isThere ? swap.value && *swap.value == *place : !swap.value;
}

bool isSame(const Project& project, const SceneSettings& scene) { return sceneSettings(project) == scene; }

template <class Value>
Id idOf(const Swap<Value>& swap) {
    return swap.id;
}
Id idOf(const SceneSettings&) { return 0; }

bool areOfSameThing(const AnySwap& a, const AnySwap& b) {
    const auto id = [](const auto& swap) { return idOf(swap); };
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

Id Edit::takeId(const Project& project) {
    const Id id = nextId.value_or(project.nextId);
    nextId = id + 1;
    return id;
}

Changes swapInto(Project& project, Edit& edit) {
    Changes changes;
    for (AnySwap& swap : edit.swaps) {
        changes.list.push_back(std::visit([&](auto& values) { return exchange(project, values); }, swap));
    }
    if (edit.nextId) std::swap(project.nextId, *edit.nextId);
    return changes;
}

void join(Edit& earlier, Edit&& later) {
    for (AnySwap& swap : later.swaps) {
        const auto isSameThing = [&](const AnySwap& other) { return areOfSameThing(swap, other); };
        if (std::ranges::none_of(earlier.swaps, isSameThing)) earlier.swaps.push_back(std::move(swap));
    }
    if (!earlier.nextId) earlier.nextId = later.nextId;
}

bool isNoChange(const Project& project, const Edit& edit) {
    return (!edit.nextId || *edit.nextId == project.nextId) &&
           std::ranges::all_of(edit.swaps, [&](const AnySwap& swap) {
               return std::visit([&](const auto& values) { return isSame(project, values); }, swap);
           });
}

SceneSettings sceneSettings(const Project& project) {
    return {project.ground, project.gravity, project.damage, project.debris};
}

}  // namespace rubble
