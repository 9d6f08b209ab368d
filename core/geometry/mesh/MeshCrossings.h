#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/TriangleContact.h"
#include "core/geometry/mesh/TriangleTree.h"

#include <cstddef>
#include <vector>

namespace rubble {

/// Where a surface crosses and touches itself.
struct MeshCrossings {
    std::vector<TrianglePair> crossing;  // ascending
    std::vector<TrianglePair> touching;  // in a line or an area, ascending; without neighbours at edges
    std::vector<TrianglePair> thin;      // with solid of no thickness between them, ascending
    bool isComplete = true;              // false where so many triangles cross that the search ended before all
};

/// Finds the triangles of a surface that cross, exactly. Surfaces that meet only in faces, edges and corners cross
/// where one of them passes to the other side of the other one there. O(n log n) plus the number of contacts.
///
/// Where nothing crosses, each shell of the surface could be moved apart from itself and from the others, infinitely
/// little, so that nothing touches any more; which shells enclose which others is not looked at.
///
/// Errors: Cancelled.
Result<MeshCrossings> findCrossings(const LatticeSurface& surface, const TriangleTree& tree, const TaskContext& task);

}  // namespace rubble
