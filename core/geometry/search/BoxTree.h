#pragma once

#include "core/geometry/search/Box3.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace rubble {

/// A static bounding volume hierarchy over boxes, for nearest and overlap queries; for boxes in the plane, z is 0. O(n
/// log n) to build; a query visits O(log n) items, plus those found, unless many boxes overlap there. The order of
/// visits depends only on the boxes.
class BoxTree {
public:
    explicit BoxTree(std::span<const Box3> boxes);

    /// Calls `visit(item)` for the items, by index, that can lie within a distance of `point`: each call returns that
    /// distance, m, which may shrink, for the items after it. Nearer boxes come first. Returns the number of visited
    /// items.
    ///
    /// Visited are all items whose box is within the distance, with a margin for the rounding of distances computed
    /// from the items' coordinates: a search that keeps the item with the least (distance, index) finds the same one as
    /// a linear scan.
    template <class Visit>
    std::size_t visitNear(Vec3 point, Visit visit) const;

    /// Calls `visit(item)`, or `visit(item, itsBox)`, for the items, by index, whose boxes overlap or touch `box`.
    template <class Visit>
    void visitOverlapping(const Box3& box, Visit visit) const;

    /// Calls `visit(item)` for all items, by index, whose boxes reach beyond a plane: to a point with
    /// dot(normal, point) > offset, as rounded; perhaps for others near them, too.
    template <class Visit>
    void visitBeyond(Vec3 normal, double offset, Visit visit) const;

private:
    static constexpr std::uint32_t kLeafSize = 4;

    struct Node {
        Box3 box;
        std::uint32_t first = 0;  // of a leaf: in m_items; else index of the left child, the right one follows
        std::uint32_t count = 0;  // of items; 0: an inner node
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t count, std::span<const Box3> boxes,
               std::span<const Vec3> centres);
    static double distanceTo(const Box3& box, Vec3 point) {
        return glm::length(glm::max(glm::max(box.min - point, point - box.max), Vec3(0.0)));
    }
    static bool overlap(const Box3& a, const Box3& b) {
        // Without branches: which comparison fails cannot be predicted.
        const bool x = (a.min.x <= b.max.x) & (b.min.x <= a.max.x);
        const bool y = (a.min.y <= b.max.y) & (b.min.y <= a.max.y);
        const bool z = (a.min.z <= b.max.z) & (b.min.z <= a.max.z);
        return x & y & z;
    }

    /// Calls `visit(place)` for the places in m_items of the leaves whose boxes, and those around them, are reached.
    template <class IsReached, class VisitPlace>
    void visitPlaces(IsReached isReached, VisitPlace visit) const;

    /// The largest dot product of a normal with a point of a box. Rounding is monotonic: no point of the box has a
    /// larger one.
    static double reach(const Box3& box, Vec3 normal) {
        return glm::dot(normal, glm::mix(box.min, box.max, glm::greaterThan(normal, Vec3(0.0))));
    }

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_items;  // by leaf
    std::vector<Box3> m_boxes;           // of m_items
    double m_extent = 0.0;               // the largest coordinate
};

template <class Visit>
std::size_t BoxTree::visitNear(Vec3 point, Visit visit) const {
    constexpr double kRelativeMargin = 1e-12;  // of the coordinates: thousands of roundings of doubles
    if (m_items.empty()) return 0;
    const double margin = kRelativeMargin * (m_extent + std::abs(point.x) + std::abs(point.y) + std::abs(point.z));
    struct Entry {
        std::uint32_t node;
        double distance;
    };
    Entry stack[64];
    int size = 0;
    std::size_t visited = 0;
    double limit = 1e308;
    stack[size++] = {0, 0.0};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (entry.distance > limit + margin) continue;
        const Node& node = m_nodes[entry.node];
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) limit = visit(m_items[k]);
        visited += node.count;
        if (node.count > 0) continue;
        Entry left{node.first, distanceTo(m_nodes[node.first].box, point)};
        Entry right{node.first + 1, distanceTo(m_nodes[node.first + 1].box, point)};
        if (left.distance < right.distance) std::swap(left, right);
        stack[size++] = left;  // the farther one
        stack[size++] = right;
    }
    return visited;
}

template <class IsReached, class VisitPlace>
void BoxTree::visitPlaces(IsReached isReached, VisitPlace visit) const {
    if (m_items.empty()) return;
    std::uint32_t stack[64];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const Node& node = m_nodes[stack[--size]];
        if (!isReached(node.box)) continue;
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) visit(k);
        if (node.count > 0) continue;
        stack[size++] = node.first + 1;
        stack[size++] = node.first;
    }
}

template <class Visit>
void BoxTree::visitOverlapping(const Box3& box, Visit visit) const {
    const auto visitPlace = [&](std::uint32_t k) {
        if (!overlap(m_boxes[k], box)) return;
        if constexpr (std::is_invocable_v<Visit, std::uint32_t, const Box3&>)
            visit(m_items[k], m_boxes[k]);
        else
            visit(m_items[k]);
    };
    visitPlaces([&](const Box3& reached) { return overlap(reached, box); }, visitPlace);
}

template <class Visit>
void BoxTree::visitBeyond(Vec3 normal, double offset, Visit visit) const {
    visitPlaces([&](const Box3& box) { return reach(box, normal) > offset; },
                [&](std::uint32_t k) { visit(m_items[k]); });
}

}  // namespace rubble
