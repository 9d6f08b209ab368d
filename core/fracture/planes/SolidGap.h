#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A fragment of a solid less the gap around it: a closed mesh.
struct ShrunkFragment {
    /// What a triangle is a part of.
    struct Side {
        std::uint32_t neighbour = kNone;  // fragment across the gap; kNone: outside
        std::uint32_t source = kNone;     // of the outside: the triangle of the cut mesh
    };
    TriangleMesh mesh;            // relative to the partition's origin; empty if nothing is left
    std::vector<Side> sides;      // of the triangles
    double volume = 0.0;          // m³
    bool isDisconnected = false;  // only the largest part remains
};

/// All fragments of a solid less the gap between them, by number.
struct ShrunkSolid {
    std::vector<ShrunkFragment> fragments;
    std::vector<Diagnostic> diagnostics;
};

/// Moves the faces between fragments inwards by half a gap, m. Faces of the outside stay in their planes.
///
/// A cell is convex, and its inner faces lie in its bisector planes: what is nearer than half the gap to one of these
/// planes is taken off, whatever shape the mesh gives the fragment. So it is for each plane of inner faces that a
/// fragment is on one side of, as for parts of split fragments. A merged fragment has others, too, where its cells meet
/// at a reflex edge: of these, only what is nearer than half the gap to the face itself is taken off, with mitred edges
/// and bevelled corners. Contacts of no width have no effect. Of a fragment that falls apart, the largest part remains.
///
/// Reports VanishedPiece, with m³, for each fragment that vanishes or falls apart.
///
/// Errors: BadInput for a gap that is negative or not finite; Cancelled.
Result<ShrunkSolid> shrunkFragments(const SolidPartition& partition, double gap, const TaskContext& task = {});

/// Reports that a fragment vanishes because of a gap.
Diagnostic vanishedReport(const SolidPartition& partition, std::uint32_t fragment);

}  // namespace rubble
