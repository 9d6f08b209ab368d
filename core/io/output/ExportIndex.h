#pragma once

#include "core/base/Result.h"
#include "core/io/output/ExportManifest.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The name of the index in every output folder.
inline constexpr const char* kIndexName = "export.json";

/// A project as the index names it.
struct IndexedProject {
    std::string name;      // of its file; empty: of no file
    std::string identity;  // see Project::identity; empty: none
    bool operator==(const IndexedProject&) const = default;
};

/// The asset that a folder is of, which it keeps where it is renamed.
struct IndexedAsset {
    std::uint32_t id = 0;
    std::uint32_t variant = 0;
    auto operator<=>(const IndexedAsset&) const = default;
};

/// What an output folder holds, so that later exports know what is theirs: docs/formats/manifest.md.
struct ExportIndex {
    IndexedProject project;
    std::vector<std::string> folders;            // of packs, names without a path
    std::map<std::string, IndexedAsset> assets;  // of `folders`, as far as it is known
    std::vector<ManifestEntry> files;            // of the export in the output folder itself, without this one
    bool operator==(const ExportIndex&) const = default;
};

std::string exportIndexJson(const ExportIndex& index);

/// The index of an output folder; nothing if there is none.
///
/// Errors: BadInput or Unsupported, with the path, if the file is not an index that this version can read, or names
/// folders or files elsewhere; those of readFile() but for NotFound.
Result<std::optional<ExportIndex>> readExportIndex(const std::filesystem::path& folder);

/// Replaces the index of an output folder by what `change` makes of it. The caller has locked the folder, see
/// lockFolder(). Written atomically, and only if it differs; an empty one is not created.
///
/// Errors: those of readExportIndex() and writeFileAtomically().
Status changeExportIndex(const std::filesystem::path& folder,
                         const std::function<ExportIndex(const std::optional<ExportIndex>&)>& change);

/// Whether an index is of a project: by its identity or, where one of them has none, by its name. The index of a
/// project without a file is of any.
bool isIndexOf(const std::optional<ExportIndex>& index, const IndexedProject& project);

/// The folders of an earlier index that no asset of the project has any more. None if it is of another project.
std::vector<std::string> staleFolders(const std::optional<ExportIndex>& earlier, const IndexedProject& project,
                                      std::span<const std::string> current);

/// The index after an export. `current` are the folders of all assets of the project, in their order; of these it has
/// those `exported` now or listed before; then come the stale ones that `kept` has. Files are those of before.
ExportIndex indexAfterExport(const std::optional<ExportIndex>& earlier, const IndexedProject& project,
                             std::span<const std::string> current, const std::set<std::string>& exported,
                             std::span<const std::string> kept);

}  // namespace rubble
