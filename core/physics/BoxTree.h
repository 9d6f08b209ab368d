#pragma once

#include "core/physics/Box.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Boxes in a binary tree, to find those that a box overlaps in logarithmic time. Boxes that grow are grown in place, and the
/// tree is built anew when half of them have: a cheap way to keep a heap in motion well sorted. Boxes that are put in lie loose
/// until then, or find their place one by one.
/// Source: Wald 2007 (splits by the middle of the longest side); Goldsmith, Salmon 1987 (insertion by surface).
class BoxTree {
public:
    static constexpr std::uint32_t kNone = ~0u;

    /// Puts a box in under the caller's number; gives the leaf that names it from now on.
    std::uint32_t insert(const Box& box, std::uint32_t number);
    void remove(std::uint32_t leaf);
    /// Makes a leaf's box at least this large.
    void grow(std::uint32_t leaf, const Box& box);
    /// Gives a leaf another box, of any size.
    void move(std::uint32_t leaf, const Box& box);
    /// Restores the tree's order where enough has changed since; to be called once a step.
    void tidy();

    const Box& box(std::uint32_t leaf) const { return m_nodes[leaf].box; }
    std::size_t size() const { return m_leafCount; }

    /// Calls visit(number, box) for each box that overlaps; in an order that depends on the tree alone.
    template <class Visit>
    void visitOverlapping(const Box& box, const Visit& visit) const {
        visitWhere([&](const Box& other) { return other.overlaps(box); }, visit);
    }
    /// Calls visit(number, box) for each that `meets` accepts, as it must every box around such a one.
    template <class Meets, class Visit>
    void visitWhere(const Meets& meets, const Visit& visit) const {
        if (m_root != kNone) visitBelow(m_root, meets, visit);
        for (const std::uint32_t leaf : m_loose) {
            if (meets(m_nodes[leaf].box)) visit(m_nodes[leaf].number, m_nodes[leaf].box);
        }
    }

private:
    static constexpr std::uint32_t kLoose = kNone - 1;  // the parent of a leaf that has no place yet

    struct Node {
        Box box;
        std::uint32_t parent = kNone;
        std::array<std::uint32_t, 2> children{kNone, kNone};
        std::uint32_t number = 0;  // the caller's, of a leaf
        bool isLeaf() const { return children[0] == kNone; }
    };

    template <class Meets, class Visit>
    void visitBelow(std::uint32_t top, const Meets& meets, const Visit& visit) const {
        std::array<std::uint32_t, 64> open;  // all of them met
        std::size_t count = 0;
        open[0] = top;
        count += meets(m_nodes[top].box) ? 1 : 0;
        while (count > 0) {
            const Node& node = m_nodes[open[--count]];
            if (node.isLeaf()) {
                visit(node.number, node.box);
            } else if (count + 2 <= open.size()) {
                // Written in any case, and kept by counting: a branch that cannot be foreseen costs more than the test.
                open[count] = node.children[1];
                count += meets(m_nodes[node.children[1]].box) ? 1 : 0;
                open[count] = node.children[0];
                count += meets(m_nodes[node.children[0]].box) ? 1 : 0;
            } else {  // deeper than a tree in order: its parts are visited on their own
                visitBelow(node.children[0], meets, visit);
                visitBelow(node.children[1], meets, visit);
            }
        }
    }

    std::uint32_t newNode();
    std::uint32_t siblingFor(const Box& box) const;
    void place(std::uint32_t leaf);
    void refitAbove(std::uint32_t node);
    struct PlacedLeaf {
        Vec3f middle;  // twice that of its box
        std::uint32_t leaf;
    };
    static constexpr std::size_t kFew = 64;  // so few are sorted quickest by counting
    void sortFew(std::span<PlacedLeaf> leaves, int side) const;
    std::uint32_t built(std::span<PlacedLeaf> leaves);
    void rebuild();

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_free;
    std::vector<std::uint32_t> m_loose;
    std::vector<PlacedLeaf> m_leaves;  // while it is built anew
    std::uint32_t m_root = kNone;
    std::size_t m_leafCount = 0;
    std::size_t m_changes = 0;  // leaves put in or grown since it was built
};

}  // namespace rubble
