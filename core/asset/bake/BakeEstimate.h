#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

struct Bake;

/// The memory that the bake of one asset may take, by estimate, bytes.
inline constexpr double kMaxBakeBytes = 2.0 * 1024.0 * 1024.0 * 1024.0;

/// The memory that bakes which are kept or made at the same time may take together, bytes.
inline constexpr double kMaxTotalBakeBytes = 8.0 * 1024.0 * 1024.0 * 1024.0;

/// What is done with an asset, each at its peak; Kept is what a bake takes afterwards.
enum class MemoryStage { Kept, Bake, Export, Play };

/// About how large a bake is.
struct BakeEstimate {
    double fragments = 0.0;  // of all levels
    double fractures = 0.0;  // of the whole and of fragments
    double largest = 0.0;    // fragments of the largest fracture
    double ofMeshes = 0.0;   // of the fragments, those of meshes
    double shrunk = 0.0;     // of these, those less a gap
    double triangles = 0.0;  // of the meshes that are cut, on all levels
    double meshBytes = 0.0;  // of a fragment: of its meshes in an export
    double bytes(MemoryStage stage = MemoryStage::Kept) const;
};

/// How large a bake is.
BakeEstimate estimateOf(const Bake& bake);

/// The estimate for an asset with valid numbers, from its recipe alone: the fragments that its patterns make, level by
/// level. Settings of single fragments are not considered.
BakeEstimate estimateOf(const Asset& asset);

/// Why a bake is refused, as a sentence with the estimate and the limit; nothing if its peak is within kMaxBakeBytes.
std::optional<std::string> sizeFault(const BakeEstimate& estimate);
/// The same for exporting or playing it, and kMaxTotalBakeBytes.
std::optional<std::string> stageFault(const BakeEstimate& estimate, MemoryStage stage);
/// The same for a number of bakes that take `bytes` together, and kMaxTotalBakeBytes.
std::optional<std::string> totalSizeFault(std::size_t bakes, double bytes);

/// How many of several bakes may be made at the same time, so that those that are take kMaxTotalBakeBytes at most: at
/// least 1 and at most `threads`.
int bakesAtOnce(std::vector<double> bytes, int threads);

}  // namespace rubble
