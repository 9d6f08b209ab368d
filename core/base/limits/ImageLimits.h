#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// The maximum size of an image file that is kept in a project, bytes: in base64 it takes a sixth of what a project may
/// have.
inline constexpr std::size_t kMaxImageBytes = std::size_t{32} << 20;
/// The maximum width and height of such an image: decoded, it takes 256 MiB.
inline constexpr std::uint32_t kMaxImageSide = 8192;
/// The maximum size of all image files that are read with a mesh, bytes; they are part of the importer's output.
inline constexpr std::size_t kMaxMeshImageBytes = std::size_t{128} << 20;

}  // namespace rubble
