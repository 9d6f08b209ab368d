#include "core/fracture/kinds/Relaxation.h"

#include "core/base/Parallel.h"
#include "core/fracture/layer/LayerContext.h"

#include <atomic>

namespace rubble {

Status relax(std::uint32_t rounds, const LayerContext& context, SeedSet& seeds, const CentroidOfCell& centroidOf) {
    for (std::uint32_t round = 0; round < rounds; ++round) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        const Result<Partition> cells = context.cellsOf(seeds.positions);
        if (!cells) return cells.error();
        const Partition& partition = *cells;
        std::atomic<bool> isCancelled = false;
        forEachIndex(seeds.size(), context.task.threads, [&](std::size_t seed) {
            const std::uint32_t piece = partition.pieceOfSeed[seed];
            if (piece == kNone || seeds.isLocked[seed] || isCancelled) return;
            seeds.positions[seed] = centroidOf(partition, piece, seeds.positions[seed]);
            if (context.isCancelledAt(seed)) isCancelled = true;
        });
        if (isCancelled) return TaskContext::cancelled();
    }
    return success();
}

}  // namespace rubble
