#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Partition.h"
#include "core/fracture/Prism.h"
#include "core/geometry/ConvexParts.h"
#include "core/geometry/MassProperties.h"
#include "core/geometry/Polytope.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Somebody a fragment touches.
struct Bond {
    std::uint32_t fragment = 0;  // index in the same list
    double area = 0.0;           // m^2 shared
};

/// One solid piece of a prism. Its own frame has the prism's axes and its centre of mass as origin.
struct Fragment {
    std::uint32_t seed = kNone;         // input index
    std::uint32_t piece = 0;            // k-th piece of its seed's cell
    std::uint32_t piecesOfSeed = 1;     // how many the outline cut that cell into
    Polygon outline;                    // the exact piece, m, in the fragment's own frame
    std::vector<std::uint32_t> across;  // behind each edge, ring after ring (outer first): a fragment; kNone: outside
    IndexLoops parts;            // convex parts of the outline, which hulls stand on; none where it is convex itself
    double depth = 0.0;          // m
    Vec3 offset{0.0, 0.0, 0.0};  // centre of mass in the prism's frame, m
    MassProperties mass;         // at density 1, of the exact piece and of what was given to it; centre (0, 0, 0)
    std::vector<Bond> bonds;     // ascending fragment
};

/// The convex hulls that fill a fragment, in its own frame: one where its outline is convex, else one a part. Corners on
/// straight sides, and those that turn right by no more than rounding, are left out. Made when asked for: a bake of
/// 50,000 fragments would spend most of its time on them.
std::vector<Polytope> hullsOf(const Fragment& fragment);

/// The pieces of a partition of the prism's outline, extruded.
struct Fragments {
    std::vector<Fragment> fragments;  // by seed, then piece
    std::vector<Report> reports;      // the partition's, then ThinPiece
};

/// Extrudes a partition: one fragment a piece, with convex hulls, mass properties and bonds (shared length x depth, where
/// the length is more than kLeastSharedEdge of the outline's diameter). A piece too thin for a hull (its width below 1e-9
/// of the outline's, see widthOf) is reported and its mass given to the neighbour with the longest shared edge (see
/// thinPieceGifts); whom it touched that one touches, and `across` names that one in its place.
/// O(corners · log corners of a piece) on task.threads.
///
/// Errors: Cancelled.
Result<Fragments> extrudedFragments(const Prism& prism, const Partition& partition, const TaskContext& task = {});

}  // namespace rubble
