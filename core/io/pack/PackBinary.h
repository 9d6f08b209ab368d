#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/exchange/PackBuilder.h"

#include <span>
#include <string>
#include <string_view>

namespace rubble {

/// The file of a pack for engines that map it into memory.
inline constexpr const char* kPackBinaryName = "pack.bin";

/// Returns pack.bin: what pack.json has, in arrays of little-endian numbers, with coordinates of hulls, contacts and
/// principal inertia as floats. The bytes do not depend on the number of threads. All fields are described in
/// docs/formats/pack-bin.md.
///
/// Errors: Limit if a hull has more than 65,535 vertices, or all together more than 4 billion vertices, corners of
/// faces or bytes of names.
Result<std::string> packBinary(const PackBuilder& builder, std::span<const PackMeshFile> meshes,
                               const TaskContext& task = {});
/// The same of a pack that was read.
Result<std::string> packBinary(const Pack& pack);

/// Reads what packBinary() wrote. Inertias follow from their principal moments, and edges and planes from the faces;
/// the checksum of the text is empty.
///
/// Errors: BadInput if the bytes were changed or are not of this form; Unsupported if the version is newer.
Result<Pack> readPackBinary(std::string_view bytes);

}  // namespace rubble
