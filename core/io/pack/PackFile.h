#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/formats/PackOptions.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rubble {

/// The version of packs that is written. Version 1 is read as well.
inline constexpr std::uint32_t kPackVersion = 2;

/// The file of a pack that describes its bodies and lists its meshes.
inline constexpr const char* kPackName = "pack.json";

/// Returns pack.json: one body per line, every number the shortest that reads back as the same double. The bytes do not
/// depend on the number of threads. All fields are described in docs/formats/pack.md.
std::string packJson(const PackBuilder& builder, std::span<const PackMeshFile> meshes,
                     PackTopology topology = PackTopology::Full, const TaskContext& task = {});

/// Reads what packJson() wrote, bit for bit; edges, signed edges and planes that were not written follow from the
/// faces. Ignores unknown keys.
///
/// Errors: BadInput if the text is not JSON of this form, with the path ("fragments[3].hulls[0].planes[2]: ...");
/// Unsupported if its version is newer; Limit if it is too large.
Result<Pack> readPack(std::string_view json);

/// Returns the first error in a pack, if there is one: repeated ids or names, missing parents and neighbours,
/// neighbours that are not mutual, children whose masses do not sum to their parent's or have another centre of mass,
/// contacts that the hulls do not have (verifyPackContacts()), bonds that are not of neighbours (verifyPackBonding()),
/// mass that is not density times volume, an impossible inertia, principal moments that are not its, hulls that fail
/// verifyPolytope() or do not fill their body, signed edges that do not follow their face or start with two collinear
/// ones, meshes of missing fragments, a malformed or zero hash.
std::optional<std::string> verifyPack(const Pack& pack);

/// Returns that the text of a pack was changed after it was written, if its checksum says so. The checksum is the hash
/// of the text with 32 zeros in its place.
std::optional<std::string> verifyPackText(std::string_view json, const Pack& pack);
/// Returns the text of a pack with the right checksum. It must have one.
std::string withChecksum(std::string json);

}  // namespace rubble
