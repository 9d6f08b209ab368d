#include "core/asset/checks/VerifyProject.h"

#include "core/asset/checks/ValueFaults.h"
#include "core/asset/project/Ids.h"
#include "core/asset/project/Names.h"
#include "core/base/Hash.h"
#include "core/base/MessageText.h"
#include "core/base/Utf8.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

/// An id and the element that uses it.
struct IdUse {
    Id id = 0;
    std::string owner;
};

template <class Element>
void addIds(const std::vector<Element>& elements, const char* kind, std::vector<IdUse>& uses) {
    for (const Element& element : elements) uses.push_back({element.id, ownerText(kind, element.id, element.name)});
}

IdUse useOf(const PatternLayer& layer, const std::string& asset) {
    return {layer.id, "Layer " + std::to_string(layer.id) + " of " + asset};
}

/// The patterns of levels and of single fragments, which may share layers.
std::vector<const Pattern*> deeperPatterns(const Asset& asset) {
    std::vector<const Pattern*> patterns;
    for (const Level& level : asset.levels) patterns.push_back(&level.pattern);
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) patterns.push_back(&leaf.level->pattern);
    }
    return patterns;
}

void addLayerIds(const Asset& asset, std::vector<IdUse>& uses) {
    const std::string owner = ownerText("asset", asset.id, asset.name);
    for (const PatternLayer& layer : asset.pattern.layers) uses.push_back(useOf(layer, owner));
    std::set<Id> below;
    for (const Pattern* pattern : deeperPatterns(asset)) {
        std::set<Id> own;
        for (const PatternLayer& layer : pattern->layers) {
            const bool isTwice = !own.insert(layer.id).second;
            if (below.insert(layer.id).second || isTwice) uses.push_back(useOf(layer, owner));
        }
    }
}

std::vector<IdUse> allIds(const Project& project) {
    std::vector<IdUse> uses;
    addIds(project.materials, "Material", uses);
    addIds(project.assets, "Asset", uses);
    for (const Asset& asset : project.assets) addLayerIds(asset, uses);
    addIds(project.instances, "Instance", uses);
    addIds(project.shots, "Saved throw", uses);
    addIds(project.playTests, "Test", uses);
    addIds(project.mortars, "Mortar", uses);
    return uses;
}

Sentence idFault(const Project& project) {
    std::vector<IdUse> uses = allIds(project);
    for (const IdUse& use : uses) {
        if (use.id == 0) return use.owner + " has the id 0, which names nothing.";
        if (use.id >= project.nextId) {
            return use.owner + " has an id that is not below the project's next id, " + std::to_string(project.nextId) +
                   ".";
        }
    }
    std::ranges::stable_sort(uses, {}, &IdUse::id);
    const auto twice = std::ranges::adjacent_find(uses, {}, &IdUse::id);
    if (twice == uses.end()) return std::nullopt;
    return twice->owner + " and " + std::next(twice)->owner + " have the same id.";
}

constexpr std::size_t kMaxNameBytes = 10'000;

/// Checks the order and the names of one list.
template <class Element>
Sentence listFault(const std::vector<Element>& elements, const char* kind) {
    std::set<std::string> names;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const std::string owner = ownerText(kind, elements[k].id, elements[k].name);
        if (k > 0 && elements[k].id < elements[k - 1].id) {
            return owner + " comes after the one with id " + std::to_string(elements[k - 1].id) + "; ids must ascend.";
        }
        if (elements[k].name.empty()) return owner + " has no name.";
        if (!isUtf8(elements[k].name)) {
            return ownerText(kind, elements[k].id, "") + " has a name that is not text in UTF-8.";
        }
        if (elements[k].name.size() > kMaxNameBytes) {
            return std::string(kind) + ' ' + std::to_string(elements[k].id) + " has a name of " +
                   std::to_string(elements[k].name.size()) + " bytes, but at most " + std::to_string(kMaxNameBytes) +
                   " are read; shorten it.";
        }
        if (!names.insert(elements[k].name).second) return owner + " has a name that is already taken.";
    }
    return std::nullopt;
}

std::string missing(const std::string& owner, const char* kind, Id id) {
    return owner + " refers to " + kind + " " + std::to_string(id) + ", which does not exist.";
}

/// Checks the instances of a mortar, which must exist and ascend.
Sentence instancesFault(const Project& project, const Mortar& mortar) {
    const std::string owner = ownerText("Mortar", mortar.id, mortar.name);
    Id before = 0;
    for (const Id instance : mortar.instances) {
        if (!findById(project.instances, instance)) return missing(owner, "instance", instance);
        if (instance <= before) {
            return owner + ": instance " + std::to_string(instance) + " comes after instance " +
                   std::to_string(before) + "; ids must ascend.";
        }
        before = instance;
    }
    return std::nullopt;
}

Sentence referenceFault(const Project& project) {
    for (const Asset& asset : project.assets) {
        const std::string owner = ownerText("Asset", asset.id, asset.name);
        if (!findMaterial(project, asset.material)) return missing(owner, "material", asset.material);
        if (asset.insideMaterial != 0 && !findMaterial(project, asset.insideMaterial)) {
            return missing(owner, "material", asset.insideMaterial);
        }
    }
    for (const Instance& instance : project.instances) {
        const std::string owner = ownerText("Instance", instance.id, instance.name);
        if (!findAsset(project, instance.asset)) return missing(owner, "asset", instance.asset);
    }
    for (const Shot& shot : project.shots) {
        const Throw* thrown = std::get_if<Throw>(&shot.action);
        if (!thrown || thrown->kind != ProjectileKind::Asset || findAsset(project, thrown->asset)) continue;
        return missing(ownerText("Saved throw", shot.id, shot.name), "asset", thrown->asset);
    }
    for (const PlayTest& test : project.playTests) {
        const std::string owner = ownerText("Test", test.id, test.name);
        for (const Id shot : test.shots) {
            if (!findById(project.shots, shot)) return missing(owner, "saved throw", shot);
        }
        for (const InstancePart& part : test.removed) {
            if (!findById(project.instances, part.instance)) return missing(owner, "instance", part.instance);
        }
        for (const Expectation& expectation : test.expectations) {
            if (expectation.instance == 0 || findById(project.instances, expectation.instance)) continue;
            return missing(owner, "instance", expectation.instance);
        }
    }
    for (const Mortar& mortar : project.mortars) {
        if (Sentence fault = instancesFault(project, mortar)) return fault;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> structureFault(const Project& project) {
    const std::optional<ContentHash> identity = parseContentHash(project.identity);
    if (!project.identity.empty() && (!identity || identity->hex() != project.identity))
        return "The identity must have 32 hexadecimal digits, but is " + quotedName(project.identity) + ".";
    if (Sentence fault = listFault(project.materials, "Material")) return fault;
    if (Sentence fault = listFault(project.assets, "Asset")) return fault;
    if (Sentence fault = listFault(project.instances, "Instance")) return fault;
    if (Sentence fault = listFault(project.shots, "Saved throw")) return fault;
    if (Sentence fault = listFault(project.playTests, "Test")) return fault;
    if (Sentence fault = listFault(project.mortars, "Mortar")) return fault;
    if (Sentence fault = idFault(project)) return fault;
    return referenceFault(project);
}

std::optional<std::string> verifyProject(const Project& project) {
    if (Sentence fault = structureFault(project)) return fault;
    return valueFault(project);
}

}  // namespace rubble
