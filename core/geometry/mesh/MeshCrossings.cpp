#include "core/geometry/mesh/MeshCrossings.h"

#include "core/base/DisjointSets.h"
#include "core/base/Parallel.h"

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

/// Crossings in a block after which it is left: more do not help, and may be as many as the square of the triangles.
constexpr std::size_t kMaxCrossings = 20'000;

/// What one block of triangles contributes.
struct BlockContacts {
    MeshCrossings found;
    FaceLayers layers;
};

bool areNeighbours(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t h = 3 * a; h < 3 * a + 3; ++h) {
        if (surface.across[h] / 3 == b) return true;
    }
    return false;
}

void addContact(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b, BlockContacts& contacts) {
    const TriangleContact contact = contactOf(surface, a, b);
    if (contact == TriangleContact::None) return;
    const TrianglePair pair{std::min(a, b), std::max(a, b)};
    EdgePassage passage = EdgePassage::Cross;
    if (contact != TriangleContact::Cross) passage = passageAtEdges(surface, pair[0], pair[1], contacts.layers);
    if (passage == EdgePassage::Cross)
        contacts.found.crossing.push_back(pair);
    else if ((passage == EdgePassage::Touch || contact == TriangleContact::Face) && !areNeighbours(surface, a, b))
        contacts.found.touching.push_back(pair);
}

/// What is between triangles with a contact of faces, from what is known at the edges of the contacts.
class LayerSearch {
public:
    explicit LayerSearch(FaceLayers layers) : m_layers(std::move(layers)) {
        for (const FaceLayers::Known& known : m_layers.known) m_pairs.push_back(known.pair);
        for (const auto& same : m_layers.same) m_pairs.insert(m_pairs.end(), same.begin(), same.end());
        std::ranges::sort(m_pairs);
        m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
    }

    /// Where both a gap and solid would have to be, a surface enters a face from one side, and leaves it to the other.
    void find(MeshCrossings& found) {
        DisjointSets sets(m_pairs.size());
        for (const auto& [a, b] : m_layers.same) sets.merge(numberOf(a), numberOf(b));
        std::ranges::sort(m_layers.known);
        std::vector<std::optional<FaceLayer>> layerOf(m_pairs.size());
        for (const auto& [pair, layer] : m_layers.known) {
            std::optional<FaceLayer>& other = layerOf[sets.rootOf(numberOf(pair))];
            if (other && *other != layer) found.crossing.push_back(pair);
            if (!other) other = layer;
        }
        for (std::uint32_t k = 0; k < m_pairs.size(); ++k) {
            if (layerOf[sets.rootOf(k)] == FaceLayer::Solid) found.thin.push_back(m_pairs[k]);
        }
    }

private:
    std::uint32_t numberOf(TrianglePair pair) const {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(m_pairs, pair) - m_pairs.begin());
    }

    FaceLayers m_layers;
    std::vector<TrianglePair> m_pairs;
};

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& some) {
    all.insert(all.end(), some.begin(), some.end());
}

void sortUnique(std::vector<TrianglePair>& pairs) {
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

Result<MeshCrossings> findCrossings(const LatticeSurface& surface, const TriangleTree& tree, const TaskContext& task) {
    std::vector<BlockContacts> blocks(tree.blockCount());
    forEachIndex(blocks.size(), task.threads, [&](std::size_t block) {
        MeshCrossings& found = blocks[block].found;
        tree.visitPairs(
            surface, block, [&](std::uint32_t a, std::uint32_t b) { addContact(surface, a, b, blocks[block]); },
            [&] {
                if (found.crossing.size() > kMaxCrossings) found.isComplete = false;
                return !found.isComplete || task.isCancelled();
            });
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    MeshCrossings all;
    FaceLayers layers;
    for (const BlockContacts& block : blocks) {
        append(all.crossing, block.found.crossing);
        append(all.touching, block.found.touching);
        all.isComplete = all.isComplete && block.found.isComplete;
        append(layers.known, block.layers.known);
        append(layers.same, block.layers.same);
    }
    LayerSearch(std::move(layers)).find(all);
    sortUnique(all.crossing);
    sortUnique(all.touching);
    return all;
}

}  // namespace rubble
