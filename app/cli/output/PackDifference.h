#pragma once

#include "core/asset/compare/RecipeDifference.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/pack/PackFile.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A pack as it was exported.
struct ExportedPack {
    Pack pack;
    std::optional<Manifest> manifest;  // none: it is missing or unreadable
};

/// The pack in a folder.
///
/// Errors: those of readFile() and of readPack(), with the path.
Result<ExportedPack> loadExportedPack(const std::filesystem::path& folder);

enum class PackChange { Removed, Added, Changed };

/// A changed fragment of a pack, or a changed file of its export.
struct PackItemChange {
    PackChange change = PackChange::Changed;
    std::string name;                 // the path of the fragment, "" for the whole; or the name of the file
    std::vector<std::string> fields;  // of a changed fragment: "volume", "hulls"
    double volume = 0.0;              // m³, of an added or removed fragment
};

/// What differs between two packs of an asset.
struct PackDifference {
    std::string name;                   // of the later asset, or of the removed one
    std::optional<PackChange> change;   // of the pack; none: it is the same
    std::size_t before = 0, after = 0;  // fragments
    std::vector<RecipeChange> fields;   // of pack.json: name, threshold, material, gap, bonds, hash
    /// Removed ones, then added ones, then changed ones, the whole first.
    std::vector<PackItemChange> fragments;
    std::vector<PackItemChange> files;  // of the manifests, but for pack.json; by name
};

/// Compares two packs field by field, exactly; fragments are matched by their paths, which leave out the asset's id. Of
/// a pack that is null, the other one was added or removed; not both are.
PackDifference packDifference(const ExportedPack* before, const ExportedPack* after);

/// Lines for people; at most `most` fragments of each change.
std::string packDifferenceText(const PackDifference& difference, std::size_t most);

/// JSON for programs: docs/formats/results.md.
std::string packDifferencesJson(std::span<const PackDifference> differences);

}  // namespace rubble
