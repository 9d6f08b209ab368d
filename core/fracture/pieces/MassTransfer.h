#pragma once

#include "core/fracture/partition/Partition.h"

#include <span>
#include <vector>

namespace rubble {

/// The transfer of the mass of a piece too thin for a hull to a piece that is not.
struct MassTransfer {
    std::uint32_t thin = 0;
    std::uint32_t receiver = kNone;  // kNone: all pieces connected to it are thin
};

/// The receiver of each thin piece's mass: the neighbour with the longest shared edge that is not thin (ties go to the
/// first). A thin piece with thin neighbours only has the receiver of the neighbour with the longest shared edge among
/// those decided in fewer rounds. `thin` contains each piece once; the result has its order.
std::vector<MassTransfer> massTransfersOf(const Partition& partition, std::span<const std::uint32_t> thin);

/// The diagnostic of a mass transfer.
Diagnostic massTransferReport(const Partition& partition, MassTransfer transfer);

}  // namespace rubble
