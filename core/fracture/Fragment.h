#pragma once

#include "core/base/RawVector.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Partition.h"
#include "core/fracture/PieceParts.h"
#include "core/fracture/Prism.h"
#include "core/fracture/ThinPieces.h"
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

struct Fragments;
struct PieceRecord;

/// One solid piece of a prism. Its own frame has the prism's axes and its centre of mass as origin.
///
/// A view: outline, neighbours and hulls are read from the partition whenever they are asked for, in O(corners · log
/// corners) of the piece, and handed over as values. The fragments must stay where they are meanwhile.
class Fragment {
public:
    Fragment(const Fragments& all, std::uint32_t index) : m_all(&all), m_index(index) {}

    std::uint32_t seed() const;        // input index; kNone where there are no seeds
    std::uint32_t partOfCell() const;  // of its seed's cell, see partOfCell(Partition); kNone: all of it
    double depth() const;              // m
    Vec3 offset() const;               // centre of mass, m: see Fragments::origin
    double volume() const;             // m^3: that of `mass()`
    MassProperties mass() const;       // at density 1, of the exact piece and of what was given to it; centre (0, 0, 0)
    bool isConvex() const;             // up to rounding
    Polygon outline() const;           // the exact piece, m, in the fragment's own frame
    std::vector<std::uint32_t> across() const;  // behind each edge, ring after ring: a fragment; kNone: outside
    std::vector<Bond> bonds() const;            // ascending fragment

    /// The convex hulls that fill it, in its own frame: one where its outline is convex, else one a convex part. Corners
    /// on straight sides, and those that turn right by no more than rounding, are left out.
    std::vector<Polytope> hulls() const;

    /// What it is a view of, and its piece there.
    const Fragments& all() const { return *m_all; }
    std::uint32_t piece() const;

private:
    const PieceRecord& record() const;

    const Fragments* m_all;
    std::uint32_t m_index;
};

/// What is kept of a fragment's piece beside its corners.
struct PieceRecord {
    AreaMoments moments;  // of the exact piece, in the partition's coordinates; `centre` of all that it weighs
    bool isConvex = true;
    bool hasGifts = false;  // it took the mass of thin pieces
};

/// The mass of a fragment that took that of thin pieces; centre (0, 0, 0).
struct GiftedMass {
    std::uint32_t fragment = 0;
    MassProperties mass;
};

/// The pieces of a partition of a prism's outline, extruded. All flat arrays; read them through operator[].
struct Fragments {
    Partition partition;
    Partition shrunk;            // with a gap between pieces: what it leaves of them, see shrunkPartition()
    double gapArea = 0.0;        // m^2 of the partition's pieces that the gap took
    double depth = 0.0;          // m
    HullTolerance tolerance;     // that of their hulls
    double leastEdge = 0.0;      // m: pieces that share less are not bonded
    Vec3 origin{0.0, 0.0, 0.0};  // of the prism's frame in that of `Fragment::offset()`, m

    RawVector<PieceRecord> records;            // of each piece; of thin ones without meaning
    RawVector<std::uint32_t> pieceOfFragment;  // by seed, then piece
    RawVector<std::uint32_t>
        fragmentOfPiece;                   // where a piece is too thin, the receiver's; kNone: none took it, or a gap
    std::vector<ThinPieceGift> gifts;      // one a thin piece, by seed, then piece
    std::vector<GiftedMass> giftedMasses;  // ascending fragment
    std::vector<Report> reports;           // the partition's, then ThinPiece or VanishedPiece and Gap

    /// The pieces as they are extruded.
    const Partition& shapes() const { return shrunk.ringsOfPiece.empty() ? partition : shrunk; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(pieceOfFragment.size()); }
    Fragment operator[](std::uint32_t index) const { return {*this, index}; }
};

/// Extrudes a partition: one fragment a piece, with convex hulls, mass properties and bonds (shared length x depth, where
/// the length is more than kLeastSharedEdge of the outline's diameter). A piece too thin for a hull (its width below 1e-9
/// of the outline's, see widthOf) is reported and its mass given to the neighbour with the longest shared edge (see
/// thinPieceGifts); whom it touched that one touches, and `across` names that one in its place.
/// O(corners · log corners of a piece) on task.threads.
///
/// With a `gap` (m, > 0) pieces are shrunk by half of it along their cut edges. Who touches whom, and along how much, stays as it
/// is without the gap. Pieces too thin then are reported (VanishedPiece) and left out, and so is their mass.
///
/// Errors: Cancelled.
Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, const TaskContext& task = {});
Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, double gap, const TaskContext& task = {});

}  // namespace rubble
