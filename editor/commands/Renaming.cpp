#include "editor/commands/Renaming.h"

#include "core/asset/project/Names.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

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
    withListOf(project, part, [&](const auto& elements) {
        auto changed = *std::ranges::find(elements, id, [](const auto& element) { return element.id; });
        changed.name = name.trimmed().toStdString();
        edit.replacements.push_back(Replacement<decltype(changed)>{id, std::move(changed)});
    });
    return edit;
}

QString nameOf(const Project& project, Part part, Id id) {
    return withListOf(project, part, [&](const auto& elements) {
        const auto place = std::ranges::find(elements, id, [](const auto& element) { return element.id; });
        return place == elements.end() ? QString() : QString::fromStdString(place->name);
    });
}

}  // namespace rubble
