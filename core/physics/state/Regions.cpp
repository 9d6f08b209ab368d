#include "core/physics/state/Regions.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr int kPartitionInterval = 64;  // calls, two per step: bodies hardly change places in half a second
constexpr int kSortInterval = 8;

/// The axis across which a split costs least. A split separates contacts, fewer on a longer axis, and bodies that are
/// adjacent in memory, fewer the nearer such bodies are along the axis.
int splitAxis(const WorldState& state, std::span<const std::uint32_t> bodies) {
    Vec3f low = state.poses[bodies[0]].centre, high = low, steps(0.0f), last = low;
    float boundingRadius = 0.0f;
    for (std::uint32_t body : bodies) {
        const BodyPose& pose = state.poses[body];
        low = componentMin(low, pose.centre);
        high = componentMax(high, pose.centre);
        steps += componentAbs(pose.centre - last);
        boundingRadius += pose.boundingRadius;
        last = pose.centre;
    }
    const Vec3f cost = (steps + Vec3f(boundingRadius)) / componentMax(high - low, Vec3f(1e-6f));
    return cost.x <= cost.y && cost.x <= cost.z ? 0 : cost.y <= cost.z ? 1 : 2;
}

}  // namespace

void Regions::partition(const WorldState& state, std::span<std::uint32_t> bodies, int axis, std::size_t first,
                        std::size_t cells) {
    if (cells == 1 || bodies.empty()) {
        for (std::uint32_t body : bodies) m_cellOf[body] = static_cast<std::uint16_t>(first);
        return;
    }
    // The cells of a region are slices along the last split axis, so that contacts near the split come last in one
    // region and first in the other.
    if (cells > kCells) axis = splitAxis(state, bodies);
    const std::size_t lower = cells > kCells ? cells / kCells / 2 * kCells : cells / 2;
    const std::size_t middle = bodies.size() * lower / cells;
    std::nth_element(
        bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(middle), bodies.end(),
        [&](std::uint32_t a, std::uint32_t b) { return state.poses[a].centre[axis] < state.poses[b].centre[axis]; });
    partition(state, bodies.first(middle), axis, first, lower);
    partition(state, bodies.subspan(middle), axis, first + lower, cells - lower);
}

void Regions::assignBodies(const WorldState& state, int threads) {
    const std::size_t count = std::min<std::size_t>(threads, kMaxRegions);
    if (count != m_count) m_callsSinceSort = kSortInterval;  // sort at once
    m_count = count;
    clearLists(m_bodies, count);
    m_firstBlocks.resize(ContactColours::kLists);
    if (count == 1) {
        m_bodies[0] = state.awake;
        return;
    }
    if (m_cellOf.size() != state.bodies.size() || ++m_callsSincePartition >= kPartitionInterval) {
        m_callsSincePartition = 0;
        m_cellOf.assign(state.bodies.size(), kNoCell);
        m_order.clear();
        for (std::uint32_t body : state.awake) {
            if (state.bodies[body].isDynamic()) m_order.push_back(body);
        }
        partition(state, m_order, 0, 0, count * kCells);
    }
    for (std::uint32_t body : state.awake)
        m_bodies[m_cellOf[body] == kNoCell ? 0 : m_cellOf[body] / kCells].push_back(body);
}

void Regions::sortContacts(WorldState& state, ThreadPool& threads) {
    if (count() == 1 || ++m_callsSinceSort < kSortInterval) return;
    m_callsSinceSort = 0;
    const auto cellOf = [&](std::uint32_t first, std::uint32_t second) -> std::size_t {
        const std::uint16_t cell = m_cellOf[first] != kNoCell ? m_cellOf[first] : m_cellOf[second];
        return cell == kNoCell ? 0 : cell;
    };
    const auto moved = [&](std::uint32_t contact, ContactSlot slot) { state.contacts[contact].slot = slot; };
    threads.forEachChunk(ContactColours::kOverflow, threads.chunkCount(ContactColours::kOverflow, 1),
                         [&](IndexRange lists, std::size_t) {
                             for (std::size_t list = lists.begin; list < lists.end; ++list) {
                                 const ContactColours::CellEnds ends = state.colours.sort(
                                     static_cast<std::uint32_t>(list), count() * kCells, cellOf, moved);
                                 for (std::size_t region = 1; region < count(); ++region) {
                                     m_firstBlocks[list][region] =
                                         (ends[kCells * region - 1] + kBlockLanes / 2) / kBlockLanes;
                                 }
                             }
                         });
}

}  // namespace rubble
