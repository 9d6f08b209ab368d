#pragma once

#include "core/asset/library/StarterProject.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/workspace/Workspace.h"
#include "tests/support/editor/TestSettings.h"

#include <QTemporaryDir>

#include <memory>
#include <vector>

namespace rubble::test {

/// A workspace with a wall, saved as wall.rubble in a folder, which has its settings, too.
inline std::unique_ptr<Workspace> savedWall(const QTemporaryDir& folder) {
    keepSettingsIn(folder.path());
    auto workspace = std::make_unique<Workspace>(starterProject(), folder.filePath("backups"));
    if (const auto saved = workspace->file().saveAs(folder.filePath("wall.rubble")); !saved)
        qFatal("%s", saved.error().message.c_str());
    return workspace;
}

/// Adds an asset with a triangle as its outline.
inline void addPrism(Workspace& workspace, const char* name) {
    workspace.document().push(addAsset(workspace.project(), name, {isoscelesTriangleOutline(2.0, 1.0), 0.5}).edit);
}

/// Adds instances of the first asset, each a variant of its own.
inline void addVariants(Workspace& workspace, int count) {
    const Id asset = workspace.project().assets.front().id;
    std::vector<Id> instances;
    for (int k = 0; k < count; ++k) {
        Addition added = placeInstance(workspace.project(), asset, {.position = {3.0 * k, 0.0, 5.0}});
        instances.push_back(added.id);
        workspace.document().push(std::move(added.edit));
    }
    workspace.document().push(assignDistinctVariants(workspace.project(), instances));
}

}  // namespace rubble::test
