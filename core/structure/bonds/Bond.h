#pragma once

#include "core/asset/bake/Bake.h"
#include "core/base/Index.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The common face of two fragments of a fracture, or of a fragment and an anchor, through which force flows.
struct Bond {
    std::uint32_t first = 0;       // node
    std::uint32_t second = kNone;  // node > first; kNone: an anchor
    double area = 0.0;             // m²
    Vec3 centroid{0.0};            // m, in the structure's frame
    Vec3 normal{0.0};              // of length 1, from first to second, or out of first
    Mat3 moments{0.0};             // m⁴: the integral of r rᵀ over the face, r from the centroid
    double seedDistance = 0.0;     // m, > 0: see seedDistanceOf(); to an anchor: from the fragment's seed to the face
    bool operator==(const Bond&) const = default;
};

/// The bonds of all pairs of neighbouring fragments, by first, then second; nodes are fragments by index. In the frame
/// of Fragment::offset(), which is the asset's. The pairs and areas are those of Fragment::contacts(): of the pieces
/// before the gap, those of thin pieces included. O(n log n) in the edges.
///
/// A pair that shares several edges has one bond: the sum of a rectangle for each. Its normal is their area-weighted
/// mean. Where that vanishes, since one fragment encloses the other, it leads from the centre of mass of the first to
/// that of the second, or along x if these coincide.
///
/// Those of a mesh are the contacts of its partition.
///
/// `seeds`: of each input index, m, in the frame of what was cut; empty: none.
std::vector<Bond> bondsOf(const Fragments& fragments, const Seeds& seeds = {});
std::vector<Bond> bondsOf(const BakedFracture& fracture);

/// Two fragments, or a fragment and an anchor, as a bond sees them.
struct BondedPoints {
    Vec3 first{0.0};  // m
    Vec3 second{0.0};
};
/// Their distance along the normal, m, if the face lies between them; nothing otherwise.
std::optional<double> distanceAcross(const Bond& bond, const BondedPoints& points);

/// The length over which a bond is strained, m, > 0: that between the seeds along the normal, if the face lies between
/// them. Else that between the centres of mass, if the face lies between those; else that of the centres to the face's
/// centroid together, or the root of the area if these coincide. No `seeds`: the fragments share one or have none.
double seedDistanceOf(const Bond& bond, const std::optional<BondedPoints>& seeds, const BondedPoints& centres);

/// The same to an anchor, m, > 0: the distance of a seed or centre from the face along the normal, if the normal leads
/// away from it; else from the face's centroid, or the root of the area.
double seedDistanceToFace(const Bond& bond, Vec3 point);

/// The bond of a fragment to an anchor that holds all of it, as a painted one does: over its middle plane, at half of
/// its depth, with the normal along z: symmetric about the middle plane, as all bonds of a prism are. Of a mesh, over
/// its silhouette at its centre of mass.
Bond paintedAnchor(const Fragments& fragments, std::uint32_t fragment);

/// Returns the first fault of bonds between `nodes` nodes in one sentence, or nothing: first, then second ascend,
/// second is a larger node or an anchor, and of a pair of nodes there is one bond; areas and distances are above zero;
/// normals have length 1; moments are symmetric and not negative along any axis.
std::optional<std::string> verifyBonds(std::span<const Bond> bonds, std::uint32_t nodes);

}  // namespace rubble
