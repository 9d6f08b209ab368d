#include "core/base/limits/SoftwareRendererNeeds.h"

#include "core/base/limits/MemoryReserve.h"
#include "core/base/limits/Threads.h"

namespace rubble {
namespace {

/// Its queues.
constexpr int kFurtherThreads = 4;
/// Measured, and more, bytes.
constexpr std::size_t kAddressSpace = std::size_t{768} << 20;
/// A copy of the geometry and the transformed vertices; measured, and more.
constexpr std::size_t kTimesGeometry = 8;
constexpr std::size_t kForDrawing = std::size_t{64} << 20;

}  // namespace

bool areRendererThreadsLeft(int processors) { return canStartThreads(processors + kFurtherThreads); }

bool isRendererMemoryLeft() { return isAddressSpaceLeft(kAddressSpace); }

bool isRendererMemoryLeft(std::size_t geometryBytes) {
    return isAddressSpaceLeft(kForDrawing + kTimesGeometry * geometryBytes);
}

}  // namespace rubble
