#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/fracture/planes/SolidSection.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// What a section cuts of a solid as a partition of the plane, in the section's axes.
struct SectionPieces {
    Partition partition;               // a piece for each polygon of a fragment
    std::vector<std::uint32_t> seeds;  // of the solid, ascending: those of the pieces, by the partition's numbers
};

/// `partition`: what the section cuts. Without seeds, which a solid that is one fragment need not have, pieces have
/// none.
SectionPieces sectionPieces(const SolidSection& section, const SolidPartition& partition, bool hasSeeds);

}  // namespace rubble
