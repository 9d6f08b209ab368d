#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace rubble {

// The records of pack.bin: see docs/formats/pack-bin.md.
static_assert(std::endian::native == std::endian::little, "the numbers in pack.bin are little-endian");

inline constexpr std::string_view kBinaryMagic = "RUBBLEPK";
inline constexpr std::uint32_t kBinaryVersion = 1;
inline constexpr std::size_t kSectionAlignment = 16;  // bytes
inline constexpr std::size_t kBinaryChecksum = 8;     // bytes, at the end

struct BinaryHead {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t sectionCount = 0;
    std::uint64_t fileSize = 0;  // bytes
};

/// The arrays of a file, in their order.
enum class BinarySection : std::uint32_t { Header = 1, Bodies, Hulls, Vertices, Loops, Contacts, Texts };
inline constexpr std::uint32_t kBinarySections = 7;

struct BinarySectionEntry {
    std::uint32_t kind = 0;
    std::uint32_t elementSize = 0;  // bytes
    std::uint64_t offset = 0;       // bytes, from the start of the file
    std::uint64_t count = 0;        // of elements
};

struct BinaryBody {
    std::array<double, 3> offset{};
    double mass = 0.0, volume = 0.0;
    double threshold = 0.0;  // 0: it does not break
    double gap = 0.0, lostMass = 0.0;
    std::array<float, 3> moments{};
    std::array<float, 4> rotation{};  // x, y, z, w
    std::array<float, 3> min{}, max{};
    float radius = 0.0f, thinnest = 0.0f;
    std::uint32_t parent = 0;  // kNone: the whole
    std::uint32_t level = 0, firstChild = 0, childCount = 0;
    std::uint32_t firstHull = 0, hullCount = 0;
    std::uint32_t id = 0, name = 0;  // where they start in the texts
    std::uint32_t unused = 0;
};

struct BinaryHull {
    std::uint32_t firstVertex = 0, vertexCount = 0;
    std::uint32_t firstLoop = 0, faceCount = 0;  // the loops of a hull are together
    float inset = 0.0f;
};

using BinaryVertex = std::array<float, 3>;

struct BinaryContact {
    std::uint32_t first = 0, second = 0;  // fragments, ascending
    float area = 0.0f;
    std::array<float, 3> centroid{}, normal{};
    float capacity = 0.0f;  // of a bond; infinite: it never breaks; 0 where the asset breaks whole
    std::uint32_t clusterLevel = 0;
};

static_assert(sizeof(BinaryHead) == 24 && sizeof(BinarySectionEntry) == 24 && sizeof(BinaryBody) == 160);
static_assert(sizeof(BinaryHull) == 20 && sizeof(BinaryVertex) == 12 && sizeof(BinaryContact) == 44);
static_assert(std::has_unique_object_representations_v<BinaryHead>);

}  // namespace rubble
