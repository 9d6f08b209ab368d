#pragma once

#include <cstdint>

/// Numbers of the glTF 2.0 specification.
namespace rubble::gltf {

/// Types of components.
inline constexpr std::uint64_t kByte = 5120;
inline constexpr std::uint64_t kUnsignedByte = 5121;
inline constexpr std::uint64_t kShort = 5122;
inline constexpr std::uint64_t kUnsignedShort = 5123;
inline constexpr std::uint64_t kUnsignedInt = 5125;
inline constexpr std::uint64_t kFloat = 5126;

/// Targets of buffer views.
inline constexpr std::uint64_t kArrayBuffer = 34962;
inline constexpr std::uint64_t kElementArrayBuffer = 34963;

}  // namespace rubble::gltf
