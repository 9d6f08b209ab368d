#include "core/physics/broadphase/DynamicBoxTree.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

int longestSide(const Box& box) {
    const Vec3f side = box.high - box.low;
    if (side.x >= side.y && side.x >= side.z) return 0;
    return side.y >= side.z ? 1 : 2;
}

}  // namespace

std::uint32_t DynamicBoxTree::newNode() {
    if (m_free.empty()) {
        m_nodes.emplace_back();
        return static_cast<std::uint32_t>(m_nodes.size() - 1);
    }
    const std::uint32_t node = m_free.back();
    m_free.pop_back();
    m_nodes[node] = Node{};
    return node;
}

/// Descends to the child whose surface area grows least, and stops where a new parent node grows less.
std::uint32_t DynamicBoxTree::bestSibling(const Box& box) const {
    std::uint32_t node = m_root;
    while (!m_nodes[node].isLeaf()) {
        const float area = m_nodes[node].box.halfSurfaceArea();
        const float whole = joined(m_nodes[node].box, box).halfSurfaceArea();
        std::array<float, 2> cost{};
        for (std::size_t side = 0; side < 2; ++side) {
            const Node& child = m_nodes[m_nodes[node].children[side]];
            const float grown = joined(child.box, box).halfSurfaceArea();
            cost[side] = (child.isLeaf() ? grown : grown - child.box.halfSurfaceArea()) + (whole - area);
        }
        if (whole < cost[0] && whole < cost[1]) break;
        node = m_nodes[node].children[cost[1] < cost[0] ? 1 : 0];
    }
    return node;
}

std::uint32_t DynamicBoxTree::insert(const Box& box, std::uint32_t number) {
    const std::uint32_t leaf = newNode();
    m_nodes[leaf].box = box;
    m_nodes[leaf].number = number;
    m_nodes[leaf].parent = kPending;
    pendingIndex(leaf) = static_cast<std::uint32_t>(m_pending.size());
    m_pending.push_back(leaf);
    ++m_leafCount;
    ++m_changes;
    return leaf;
}

/// Inserts a pending leaf next to the best sibling.
void DynamicBoxTree::attach(std::uint32_t leaf) {
    if (m_root == kNone) {
        m_root = leaf;
        m_nodes[leaf].parent = kNone;
        return;
    }
    const std::uint32_t sibling = bestSibling(m_nodes[leaf].box);
    const std::uint32_t parent = newNode(), above = m_nodes[sibling].parent;
    m_nodes[parent].parent = above;
    m_nodes[parent].children = {sibling, leaf};
    m_nodes[sibling].parent = m_nodes[leaf].parent = parent;
    if (above == kNone) {
        m_root = parent;
    } else {
        m_nodes[above].children[m_nodes[above].children[1] == sibling ? 1 : 0] = parent;
    }
    refitAncestors(leaf);
}

void DynamicBoxTree::refitAncestors(std::uint32_t node) {
    for (std::uint32_t above = m_nodes[node].parent; above < kPending; above = m_nodes[above].parent) {
        Node& parent = m_nodes[above];
        parent.box = joined(m_nodes[parent.children[0]].box, m_nodes[parent.children[1]].box);
    }
}

void DynamicBoxTree::remove(std::uint32_t leaf) {
    RUBBLE_ASSERT(isLeaf(leaf));
    const std::uint32_t parent = m_nodes[leaf].parent;
    --m_leafCount;
    m_free.push_back(leaf);
    if (parent == kPending) return removePending(leaf);
    if (parent == kNone) {
        m_root = kNone;
        return;
    }
    const Node& gone = m_nodes[parent];
    const std::uint32_t sibling = gone.children[gone.children[0] == leaf ? 1 : 0], above = gone.parent;
    m_nodes[sibling].parent = above;
    m_free.push_back(parent);
    if (above == kNone) {
        m_root = sibling;
        return;
    }
    m_nodes[above].children[m_nodes[above].children[1] == parent ? 1 : 0] = sibling;
    refitAncestors(sibling);
}

/// Keeps the order of the others, in constant time on average: the list is compacted when half of it is removed.
void DynamicBoxTree::removePending(std::uint32_t leaf) {
    m_pending[pendingIndex(leaf)] = kNone;
    if (2 * ++m_removedPending <= m_pending.size()) return;
    std::erase(m_pending, kNone);
    m_removedPending = 0;
    for (std::size_t k = 0; k < m_pending.size(); ++k) pendingIndex(m_pending[k]) = static_cast<std::uint32_t>(k);
}

void DynamicBoxTree::enlarge(std::uint32_t leaf, const Box& box) {
    RUBBLE_ASSERT(isLeaf(leaf));
    ++m_changes;
    m_nodes[leaf].box = joined(m_nodes[leaf].box, box);
    for (std::uint32_t above = m_nodes[leaf].parent; above < kPending; above = m_nodes[above].parent) {
        if (m_nodes[above].box.contains(box)) return;
        m_nodes[above].box = joined(m_nodes[above].box, box);
    }
}

void DynamicBoxTree::move(std::uint32_t leaf, const Box& box) {
    RUBBLE_ASSERT(isLeaf(leaf));
    ++m_changes;
    m_nodes[leaf].box = box;
    refitAncestors(leaf);
}

/// Sorts few leaves by their centres along a side: each counts those before it, without branches.
void DynamicBoxTree::countingSort(std::span<LeafCentre> leaves, int side) const {
    const std::size_t count = leaves.size();
    std::array<LeafCentre, kCountingSortMax> unsorted;
    std::array<float, kCountingSortMax> coordinates;
    std::array<std::uint32_t, kCountingSortMax> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        unsorted[i] = leaves[i];
        coordinates[i] = leaves[i].centre[side];
        numbers[i] = m_nodes[leaves[i].leaf].number;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const float coordinate = coordinates[i];
        const std::uint32_t number = numbers[i];
        std::uint32_t before = 0;
        for (std::size_t j = 0; j < count; ++j) {
            const int isBefore =
                (coordinates[j] < coordinate) | ((coordinates[j] == coordinate) & (numbers[j] < number));
            before += static_cast<std::uint32_t>(isBefore);
        }
        leaves[before] = unsorted[i];
    }
}

std::uint32_t DynamicBoxTree::build(std::span<LeafCentre> leaves) {
    if (leaves.size() == 1) return leaves.front().leaf;
    Box centres{leaves.front().centre, leaves.front().centre};
    for (const LeafCentre& leaf : leaves) centres = joined(centres, {leaf.centre, leaf.centre});
    const int side = longestSide(centres);
    const auto half = static_cast<std::ptrdiff_t>(leaves.size() / 2);
    if (leaves.size() <= kCountingSortMax) {
        countingSort(leaves, side);
    } else {
        std::nth_element(leaves.begin(), leaves.begin() + half, leaves.end(),
                         [&](const LeafCentre& a, const LeafCentre& b) {
                             const float coordinateA = a.centre[side], coordinateB = b.centre[side];
                             return coordinateA != coordinateB ? coordinateA < coordinateB
                                                               : m_nodes[a.leaf].number < m_nodes[b.leaf].number;
                         });
    }
    const std::uint32_t node = newNode();
    const std::uint32_t left = build(leaves.first(leaves.size() / 2)), right = build(leaves.subspan(leaves.size() / 2));
    m_nodes[node].children = {left, right};
    m_nodes[node].box = joined(m_nodes[left].box, m_nodes[right].box);
    m_nodes[left].parent = m_nodes[right].parent = node;
    return node;
}

void DynamicBoxTree::rebuild() {
    m_leaves.clear();
    const auto addLeaf = [&](std::uint32_t leaf) {
        m_leaves.push_back({m_nodes[leaf].box.low + m_nodes[leaf].box.high, leaf});
    };
    for (const std::uint32_t leaf : m_pending) {
        if (leaf != kNone) addLeaf(leaf);
    }
    std::vector<std::uint32_t>& inner = m_free;  // every inner node becomes free
    inner.reserve(m_nodes.size());
    std::vector<std::uint32_t> open;
    if (m_root != kNone) open.push_back(m_root);
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        if (m_nodes[node].isLeaf()) {
            addLeaf(node);
            continue;
        }
        open.push_back(m_nodes[node].children[1]);
        open.push_back(m_nodes[node].children[0]);
        inner.push_back(node);
    }
    m_root = m_leaves.empty() ? kNone : build(m_leaves);
    if (m_root != kNone) m_nodes[m_root].parent = kNone;
    m_changes = 0;
}

void DynamicBoxTree::update() {
    if (2 * m_changes > m_leafCount) {
        rebuild();
    } else {
        for (const std::uint32_t leaf : m_pending) {
            if (leaf != kNone) attach(leaf);
        }
    }
    m_pending.clear();
    m_removedPending = 0;
}

/// Checks the nodes below a node and marks them.
std::optional<std::string> DynamicBoxTree::verifyBelow(std::uint32_t top, std::vector<char>& seen) const {
    std::vector<std::uint32_t> open{top};
    while (!open.empty()) {
        const std::uint32_t number = open.back();
        open.pop_back();
        const Node& node = m_nodes[number];
        const std::string place = "nodes[" + std::to_string(number) + "]";
        if (seen[number]++ != 0) return place;
        if (node.isLeaf()) {
            if (node.children[1] != kNone && node.children[1] >= m_nodes.size()) return place;
            continue;
        }
        for (const std::uint32_t child : node.children) {
            const bool isThere = child < m_nodes.size() && m_nodes[child].parent == number;
            if (!isThere || !node.box.contains(m_nodes[child].box)) return place;
            open.push_back(child);
        }
    }
    return std::nullopt;
}

std::optional<std::string> DynamicBoxTree::verifyTree(std::span<const std::uint32_t> leafOf) const {
    std::vector<char> seen(m_nodes.size(), 0);
    for (std::size_t k = 0; k < m_free.size(); ++k) {
        if (m_free[k] >= m_nodes.size() || seen[m_free[k]]++ != 0) return "free[" + std::to_string(k) + "]";
    }
    std::size_t removed = 0;
    for (std::size_t k = 0; k < m_pending.size(); ++k) {
        const std::uint32_t leaf = m_pending[k];
        removed += leaf == kNone ? 1 : 0;
        if (leaf == kNone) continue;
        const bool isPending = leaf < m_nodes.size() && m_nodes[leaf].isLeaf() && m_nodes[leaf].parent == kPending &&
                               m_nodes[leaf].children[1] == k;
        if (!isPending || seen[leaf]++ != 0) return "pending[" + std::to_string(k) + "]";
    }
    if (removed != m_removedPending) return "removedPending";
    if (m_root != kNone) {
        if (m_root >= m_nodes.size() || m_nodes[m_root].parent != kNone) return "root";
        if (std::optional<std::string> fault = verifyBelow(m_root, seen)) return fault;
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
        if (seen[k] == 0) return "nodes[" + std::to_string(k) + "]";
    }
    std::vector<char> isFree(m_nodes.size(), 0);
    for (const std::uint32_t node : m_free) isFree[node] = 1;
    std::size_t leaves = 0;
    for (std::uint32_t k = 0; k < m_nodes.size(); ++k) {
        if (isFree[k] != 0 || !m_nodes[k].isLeaf()) continue;
        const std::uint32_t number = m_nodes[k].number;
        if (number >= leafOf.size() || leafOf[number] != k) return "nodes[" + std::to_string(k) + "]";
        ++leaves;
    }
    const auto hasLeaf = [](std::uint32_t leaf) { return leaf != kNone; };
    if (leaves != m_leafCount || std::ranges::count_if(leafOf, hasLeaf) != static_cast<std::ptrdiff_t>(leaves)) {
        return "leafCount";
    }
    return std::nullopt;
}

}  // namespace rubble
