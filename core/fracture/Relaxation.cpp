#include "core/fracture/Relaxation.h"

#include "core/base/Parallel.h"
#include "core/fracture/PatternKind.h"
#include "core/fracture/PatternPartition.h"

#include <atomic>

namespace rubble {

Status relax(std::uint32_t rounds, const LayerContext& context, SeedSet& seeds, const MiddleOfCell& middleOf) {
    const Pattern none;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        const Result<CutCells> cells =
            cellsOf(context.pattern ? *context.pattern : none, seeds.positions, context.outline, context.task);
        if (!cells) return cells.error();
        const Partition& partition = cells->partition;
        std::atomic<bool> isCancelled = false;
        forEachIndex(seeds.size(), context.task.threads, [&](std::size_t seed) {
            const std::uint32_t piece = partition.pieceOfSeed[seed];
            if (piece == kNone || seeds.isHeld[seed] || isCancelled) return;
            seeds.positions[seed] = middleOf(partition, piece, seeds.positions[seed]);
            if (context.isCancelledAt(seed)) isCancelled = true;
        });
        if (isCancelled) return TaskContext::cancelled();
    }
    return success();
}

}  // namespace rubble
