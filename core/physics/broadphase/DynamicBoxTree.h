#pragma once

#include "core/base/Index.h"
#include "core/physics/math/Box.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A dynamic bounding volume hierarchy of boxes. Finds the boxes overlapping a box in O(log n + result) for a balanced
/// tree. Changed boxes are refitted in place; once half of the leaves have changed, update() rebuilds the tree, which
/// keeps the tree of a moving heap balanced at low cost. Inserted boxes are pending until the next update().
/// Source: Wald 2007 (median splits along the longest axis); Goldsmith, Salmon 1987 (insertion by surface area).
class DynamicBoxTree {
public:
    /// Inserts a box under the caller's number. Returns its leaf.
    std::uint32_t insert(const Box& box, std::uint32_t number);
    void remove(std::uint32_t leaf);
    /// Extends a leaf's box to include `box`.
    void enlarge(std::uint32_t leaf, const Box& box);
    /// Replaces a leaf's box.
    void move(std::uint32_t leaf, const Box& box);
    /// Inserts pending leaves, or rebuilds the tree if half of the leaves changed; call once per step.
    void update();

    const Box& box(std::uint32_t leaf) const { return m_nodes[leaf].box; }
    std::size_t size() const { return m_leafCount; }
    std::size_t byteCount() const { return m_nodes.size() * sizeof(Node); }

    /// Where the links are not those of a tree, as "nodes[5]"; nothing if they are. `leafOf` is the leaf of each of the
    /// caller's numbers; kNone: it has none.
    std::optional<std::string> verifyTree(std::span<const std::uint32_t> leafOf) const;
    /// Visits everything that is saved.
    template <class Self, class Visit>
    static void visitFields(Self& self, Visit& visit) {
        visit("nodes", self.m_nodes);
        visit("free", self.m_free);
        visit("pending", self.m_pending);
        visit("removedPending", self.m_removedPending);
        visit("root", self.m_root);
        visit("leafCount", self.m_leafCount);
        visit("changes", self.m_changes);
    }

    /// Calls visit(number, box) for each overlapping box, in an order that depends only on the tree.
    template <class Visit>
    void visitOverlapping(const Box& box, const Visit& visit) const {
        visitIf([&](const Box& other) { return other.overlaps(box); }, visit);
    }
    /// Calls visit(number, box) for each box that `accepts` accepts. It must accept every box containing an accepted
    /// one.
    template <class Accepts, class Visit>
    void visitIf(const Accepts& accepts, const Visit& visit) const {
        if (m_root != kNone) visitBelow(m_root, accepts, visit);
        for (const std::uint32_t leaf : m_pending) {
            if (leaf != kNone && accepts(m_nodes[leaf].box)) visit(m_nodes[leaf].number, m_nodes[leaf].box);
        }
    }

private:
    static constexpr std::uint32_t kPending = kNone - 1;  // the parent of a pending leaf

    struct Node {
        Box box;
        std::uint32_t parent = kNone;
        std::array<std::uint32_t, 2> children{kNone, kNone};
        std::uint32_t number = 0;  // the caller's, of a leaf
        bool isLeaf() const { return children[0] == kNone; }
        template <class Self, class Visit>
        static void visitFields(Self& self, Visit& visit) {
            visit("box", self.box);
            visit("parent", self.parent);
            visit("children", self.children);
            visit("number", self.number);
        }
    };

    template <class Accepts, class Visit>
    void visitBelow(std::uint32_t top, const Accepts& accepts, const Visit& visit) const {
        std::array<std::uint32_t, 64> open;  // nodes to visit; all accepted
        std::size_t count = 0;
        open[0] = top;
        count += accepts(m_nodes[top].box) ? 1 : 0;
        while (count > 0) {
            const Node& node = m_nodes[open[--count]];
            if (node.isLeaf()) {
                visit(node.number, node.box);
            } else if (count + 2 <= open.size()) {
                // Branchless: written unconditionally, kept by counting. A mispredicted branch costs more than the
                // test.
                open[count] = node.children[1];
                count += accepts(m_nodes[node.children[1]].box) ? 1 : 0;
                open[count] = node.children[0];
                count += accepts(m_nodes[node.children[0]].box) ? 1 : 0;
            } else {  // deeper than a balanced tree
                visitBelow(node.children[0], accepts, visit);
                visitBelow(node.children[1], accepts, visit);
            }
        }
    }

    std::optional<std::string> verifyBelow(std::uint32_t node, std::vector<char>& seen) const;
    bool isLeaf(std::uint32_t node) const { return node < m_nodes.size() && m_nodes[node].isLeaf(); }
    std::uint32_t newNode();
    std::uint32_t bestSibling(const Box& box) const;
    /// The index in m_pending of a pending leaf, which has no children.
    std::uint32_t& pendingIndex(std::uint32_t leaf) { return m_nodes[leaf].children[1]; }
    void removePending(std::uint32_t leaf);
    void attach(std::uint32_t leaf);
    void refitAncestors(std::uint32_t node);
    struct LeafCentre {
        Vec3f centre;  // twice the centre of its box
        std::uint32_t leaf;
    };
    static constexpr std::size_t kCountingSortMax = 64;  // fewer leaves are sorted fastest by counting
    void countingSort(std::span<LeafCentre> leaves, int side) const;
    std::uint32_t build(std::span<LeafCentre> leaves);
    void rebuild();

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_free;
    std::vector<std::uint32_t> m_pending;  // leaves in order of insertion; kNone where one was removed
    std::size_t m_removedPending = 0;      // at most half of them
    std::vector<LeafCentre> m_leaves;      // scratch of rebuild()
    std::uint32_t m_root = kNone;
    std::size_t m_leafCount = 0;
    std::size_t m_changes = 0;  // insertions and box changes since the last rebuild
};

}  // namespace rubble
