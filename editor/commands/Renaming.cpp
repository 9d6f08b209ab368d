#include "editor/commands/Renaming.h"

#include "core/asset/project/Names.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {

namespace {

struct RenamingTexts {
    Q_DECLARE_TR_FUNCTIONS(Renaming)
};

/// Calls a function with the list of a kind of elements.
template <class Function>
auto withListOf(const Project& project, Part part, const Function& function) {
    switch (part) {
        case Part::Material: return function(project.materials);
        case Part::Asset: return function(project.assets);
        case Part::Mortar: return function(project.mortars);
        default: return function(project.instances);
    }
}

/// The instances or the asset that have the name of a renamed asset or of its instance, and follow it.
std::vector<std::pair<Part, Id>> namesakesOf(const Project& project, Part part, Id id) {
    std::vector<std::pair<Part, Id>> namesakes;
    const QString name = nameOf(project, part, id);
    const auto add = [&](Part other, Id otherId) {
        if (nameOf(project, other, otherId) == name) namesakes.emplace_back(other, otherId);
    };
    const auto instance = std::ranges::find(project.instances, id, &Instance::id);
    if (part == Part::Instance && instance != project.instances.end()) add(Part::Asset, instance->asset);
    for (const Instance& other : project.instances) {
        if (part == Part::Asset && other.asset == id) add(Part::Instance, other.id);
    }
    return namesakes;
}

void addRenamed(const Project& project, Part part, Id id, const std::string& name, Edit& edit) {
    withListOf(project, part, [&](const auto& elements) {
        auto changed = *std::ranges::find(elements, id, [](const auto& element) { return element.id; });
        changed.name = name;
        edit.replacements.push_back(Replacement<decltype(changed)>{id, std::move(changed)});
    });
}

}  // namespace

QString nameFault(const Project& project, Part part, Id id, const QString& name) {
    if (name.trimmed().isEmpty()) return RenamingTexts::tr("A name must not be empty.");
    const std::string folded = caseFolded(name.trimmed().toStdString());
    return withListOf(project, part, [&](const auto& elements) {
        const auto other = std::ranges::find_if(
            elements, [&](const auto& element) { return element.id != id && caseFolded(element.name) == folded; });
        if (other == elements.end()) return QString();
        return RenamingTexts::tr("The name \"%1\" is already taken.").arg(nameText(other->name));
    });
}

Edit renameElement(const Project& project, Part part, Id id, const QString& name) {
    Edit edit{.text = RenamingTexts::tr("Rename")};
    addRenamed(project, part, id, name.trimmed().toStdString(), edit);
    renameNamesakes(project, edit);
    return edit;
}

void renameNamesakes(const Project& project, Edit& edit) {
    const auto isInEdit = [&edit](Part part, Id id) {
        return std::ranges::any_of(edit.replacements, [&](const AnyReplacement& replacement) {
            const auto* asset = std::get_if<Replacement<Asset>>(&replacement);
            const auto* instance = std::get_if<Replacement<Instance>>(&replacement);
            return part == Part::Asset ? asset && asset->id == id : instance && instance->id == id;
        });
    };
    const auto renameThoseOf = [&](Part part, Id id, const std::string& name) {
        const QString after = QString::fromStdString(name), before = nameOf(project, part, id);
        if (before.isEmpty() || before == after) return;
        for (const auto& [other, otherId] : namesakesOf(project, part, id)) {
            const bool mayFollow = !isInEdit(other, otherId) && nameFault(project, other, otherId, after).isEmpty();
            if (mayFollow) addRenamed(project, other, otherId, name, edit);
        }
    };
    for (std::size_t k = 0, count = edit.replacements.size(); k < count; ++k) {
        const auto* asset = std::get_if<Replacement<Asset>>(&edit.replacements[k]);
        const auto* instance = std::get_if<Replacement<Instance>>(&edit.replacements[k]);
        if (asset && asset->value) renameThoseOf(Part::Asset, asset->id, std::string(asset->value->name));
        if (instance && instance->value)
            renameThoseOf(Part::Instance, instance->id, std::string(instance->value->name));
    }
}

QString nameOf(const Project& project, Part part, Id id) {
    return withListOf(project, part, [&](const auto& elements) {
        const auto place = std::ranges::find(elements, id, [](const auto& element) { return element.id; });
        return place == elements.end() ? QString() : QString::fromStdString(place->name);
    });
}

}  // namespace rubble
