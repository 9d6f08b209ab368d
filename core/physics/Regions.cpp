#include "core/physics/Regions.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr int kCallsACut = 64;  // two a step: bodies hardly change places in half a second
constexpr int kCallsAnOrder = 8;

/// The axis that a cut across disturbs least. It parts contacts, the fewer the longer the axis; and it parts bodies that lie next to
/// each other in memory, which processors fetch together: the fewer the nearer such bodies are along it.
int axisToCut(const WorldState& state, std::span<const std::uint32_t> bodies) {
    Vec3f low = state.places[bodies[0]].centre, high = low, steps(0.0f), last = low;
    float reach = 0.0f;
    for (std::uint32_t body : bodies) {
        const BodyPlace& place = state.places[body];
        low = leastOf(low, place.centre);
        high = greatestOf(high, place.centre);
        steps += magnitudes(place.centre - last);
        reach += place.reach;
        last = place.centre;
    }
    const Vec3f cost = (steps + Vec3f(reach)) / greatestOf(high - low, Vec3f(1e-6f));
    return cost.x <= cost.y && cost.x <= cost.z ? 0 : cost.y <= cost.z ? 1 : 2;
}

}  // namespace

void Regions::cut(const WorldState& state, std::span<std::uint32_t> bodies, int axis, std::size_t first,
                  std::size_t cells) {
    if (cells == 1 || bodies.empty()) {
        for (std::uint32_t body : bodies) m_cellOf[body] = static_cast<std::uint16_t>(first);
        return;
    }
    // A region's cells are slices along the last cut, so that contacts near it come last on one side and first on the other.
    if (cells > kCells) axis = axisToCut(state, bodies);
    const std::size_t lower = cells > kCells ? cells / kCells / 2 * kCells : cells / 2;
    const std::size_t middle = bodies.size() * lower / cells;
    std::nth_element(
        bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(middle), bodies.end(),
        [&](std::uint32_t a, std::uint32_t b) { return state.places[a].centre[axis] < state.places[b].centre[axis]; });
    cut(state, bodies.first(middle), axis, first, lower);
    cut(state, bodies.subspan(middle), axis, first + lower, cells - lower);
}

void Regions::shareOut(const WorldState& state, int workers) {
    const std::size_t count = std::min<std::size_t>(workers, kMost);
    if (count != m_bodies.size()) m_callsSinceOrder = kCallsAnOrder;  // at once
    m_bodies.resize(count);
    m_firstBlocks.resize(ContactColours::kLists);
    for (std::vector<std::uint32_t>& bodies : m_bodies) bodies.clear();
    if (count == 1) {
        m_bodies[0] = state.awake;
        return;
    }
    if (m_cellOf.size() != state.bodies.size() || ++m_callsSinceCut >= kCallsACut) {
        m_callsSinceCut = 0;
        m_cellOf.assign(state.bodies.size(), kNowhere);
        m_order.clear();
        for (std::uint32_t body : state.awake) {
            if (state.bodies[body].isDynamic()) m_order.push_back(body);
        }
        cut(state, m_order, 0, 0, count * kCells);
    }
    for (std::uint32_t body : state.awake)
        m_bodies[m_cellOf[body] == kNowhere ? 0 : m_cellOf[body] / kCells].push_back(body);
}

void Regions::orderContacts(WorldState& state, WorkerTeam& team) {
    if (count() == 1 || ++m_callsSinceOrder < kCallsAnOrder) return;
    m_callsSinceOrder = 0;
    const auto cellOf = [&](std::uint32_t first, std::uint32_t second) -> std::size_t {
        const std::uint16_t cell = m_cellOf[first] != kNowhere ? m_cellOf[first] : m_cellOf[second];
        return cell == kNowhere ? 0 : cell;
    };
    const auto moved = [&](std::uint32_t contact, ContactSlot slot) { state.contacts[contact].slot = slot; };
    team.share(ContactColours::kOneByOne, team.chunksOf(ContactColours::kOneByOne, 1),
               [&](IndexRange lists, std::size_t) {
                   for (std::size_t list = lists.begin; list < lists.end; ++list) {
                       const ContactColours::CellEnds ends =
                           state.colours.order(static_cast<std::uint32_t>(list), count() * kCells, cellOf, moved);
                       for (std::size_t region = 1; region < count(); ++region) {
                           m_firstBlocks[list][region] = (ends[kCells * region - 1] + kBlockLanes / 2) / kBlockLanes;
                       }
                   }
               });
}

}  // namespace rubble
