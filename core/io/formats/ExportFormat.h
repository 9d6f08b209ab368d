#pragma once

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/formats/ExportOption.h"
#include "core/io/formats/TextureBaking.h"

#include <string>
#include <vector>

namespace rubble {

/// What the files of a format are written from. Borrowed.
struct FormatInput {
    const PackBuilder& pack;
    const MeshOptions& options;
    const MeshMaterials& materials;
    const FragmentMesher& mesher;
    const RoughCuts& cuts;
    const BakedTextures* textures;  // null: finishes are not baked
    const TaskContext& task;
};

/// A file with the meshes of some bodies of an asset, which several formats write.
struct PartFile {
    std::string name;  // without the suffix of a format
    PackMeshBodies bodies = PackMeshBodies::Fragments;
    std::vector<std::uint32_t> fragments;  // ascending; none: the whole
    std::optional<std::uint32_t> level;    // see PackMeshFile
};

/// A format that an asset is exported in: a row that says all about it. The command line, the dialog, settings, hashes,
/// estimates of memory and lists of files are loops over these rows; see docs/architecture.md for adding one.
struct ExportFormat {
    std::string_view word;     // "usd": an option of the command line, and in settings and hashes
    std::string_view caption;  // in the dialog, with its mnemonic
    std::string_view hint;     // in the dialog and on the command line
    std::span<const ExportOption* const> options;
    bool hasImageFile = false;                             // its files refer to a file with the image of a texture
    bool (*hasBakedImages)(const MeshOptions&) = nullptr;  // whether its files show them; null: never
    /// The memory that a fragment takes while it is exported, bytes. Measured with 20,000 fragments.
    double (*bytesPerFragment)(const MeshOptions&) = nullptr;

    // Files of parts, which are listed in the pack. Those of all fragments depend on FileSplit.
    std::string_view suffix;  // empty: the format has none
    /// Errors: those of the format's writer.
    Result<std::string> (*partFile)(const FormatInput&, const PartFile&, std::span<const MeshPart>) = nullptr;

    // Files of the asset, which are not.
    std::vector<std::string> (*assetFileNames)(const PackNames&) = nullptr;  // null: the format has none
    /// Returns the bytes of the files, in the order of their names.
    ///
    /// Errors: those of the format's writer; Cancelled.
    Result<std::vector<std::string>> (*assetFiles)(const FormatInput&) = nullptr;
};

/// All formats, in the order of their files in an export.
std::span<const ExportFormat* const> exportFormats();

/// A row of exportFormats(); null if there is no format of that name.
const ExportFormat* formatNamed(std::string_view word);

/// The formats of a set, in their order.
std::vector<const ExportFormat*> formatsOf(const FormatSet& set);

/// The fragments of an asset that do not break.
std::vector<std::uint32_t> unbrokenFragments(const Bake& bake);

/// The name of the whole's mesh file, without the suffix of a format.
std::string wholeFileName(const PackNames& names);

}  // namespace rubble
