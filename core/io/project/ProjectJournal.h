#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/io/project/MeshFolder.h"

#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Some elements of a project as they are after an edit, and those that it removed.
struct ProjectPart {
    Project values;  // of the lists only the elements that changed; the rest is that of the project
    // Ascending:
    std::vector<Id> removedMaterials, removedAssets, removedInstances, removedShots, removedPlayTests, removedMortars;
    std::vector<Id> keptTextures;  // assets of `values` that have the texture of before, which is left out there
};

/// A journal holds what was edited since a project was written as a text, so that it need not be written anew for every
/// edit: a line with the hash of that text, then records, each sealed by its hash and those before it. What a program
/// that is killed leaves of the last record ends the journal.
///
/// Returns the first line of the journal of a text.
std::string journalStart(const ContentHash& text);

/// Returns the record of an edit, and seals it: `seal` is the hash of the text or of the record before, and becomes
/// that of this one.
std::string journalRecord(const ProjectPart& part, ContentHash& seal);

/// Returns a project with the edits of its journal, up to the first record that is not whole. `text` is the hash of
/// what the project was read from; edits of another text are left out. `meshes` gives the closed meshes.
///
/// Errors: those of readProjectPart() in a sealed record, which another version may have written.
Result<Project> replayed(Project project, const ContentHash& text, std::string_view journal,
                         const MeshSource& meshes = {});

}  // namespace rubble
