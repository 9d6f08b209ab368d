#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/LatticeSurface.h"
#include "core/geometry/search/BoxTree.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rubble {

/// The triangles of a surface in box trees of some thousands each, so that they are built in parallel and can be
/// cancelled. The same on any number of threads.
class TriangleTree {
public:
    /// Errors: Cancelled.
    static Result<TriangleTree> make(const LatticeSurface& surface, const TaskContext& task);

    /// The triangles are divided into blocks.
    std::size_t blockCount() const { return m_blocks.size(); }

    /// Calls `visit(a, b)` once for each two triangles whose boxes overlap or touch, of which a is in a block and b in
    /// it or a later one; ends before a triangle at which `isDone()`.
    template <class Visit, class IsDone>
    void visitPairs(const LatticeSurface& surface, std::size_t block, Visit visit, IsDone isDone) const;

    /// Calls `visit(triangle)` for those whose boxes overlap or touch `box`.
    template <class Visit>
    void visitOverlapping(const Box3& box, Visit visit) const {
        m_top->visitOverlapping(box, [&](std::uint32_t block) {
            const Block& found = m_blocks[block];
            found.tree.visitOverlapping(box, [&](std::uint32_t item) { visit(found.triangles[item]); });
        });
    }

private:
    struct Block {
        std::vector<std::uint32_t> triangles;
        BoxTree tree;
        Box3 box;
    };

    std::vector<Block> m_blocks;
    std::optional<BoxTree> m_top;  // of the blocks
};

template <class Visit, class IsDone>
void TriangleTree::visitPairs(const LatticeSurface& surface, std::size_t block, Visit visit, IsDone isDone) const {
    const Block& own = m_blocks[block];
    std::vector<std::pair<const Block*, Box3>> later;
    m_top->visitOverlapping(own.box, [&](std::uint32_t other, const Box3& box) {
        if (other > block) later.emplace_back(&m_blocks[other], box);
    });
    for (std::uint32_t k = 0; k < own.triangles.size(); ++k) {
        if (isDone()) return;
        const std::uint32_t triangle = own.triangles[k];
        const Box3 box = surface.boxOf(triangle);
        own.tree.visitOverlapping(box, [&](std::uint32_t item) {
            if (item > k) visit(triangle, own.triangles[item]);
        });
        for (const auto& [other, around] : later) {
            if (box.min.x > around.max.x || box.max.x < around.min.x || box.min.y > around.max.y ||
                box.max.y < around.min.y || box.min.z > around.max.z || box.max.z < around.min.z)
                continue;
            other->tree.visitOverlapping(box, [&](std::uint32_t item) { visit(triangle, other->triangles[item]); });
        }
    }
}

}  // namespace rubble
