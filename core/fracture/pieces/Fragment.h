#pragma once

#include "core/base/UninitializedVector.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/pieces/HullParts.h"
#include "core/fracture/pieces/MassTransfer.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/Polytope.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// A neighbouring fragment and the contact area.
struct FragmentContact {
    std::uint32_t fragment = 0;  // index in the same list
    double area = 0.0;           // m²
};

struct Fragments;
struct PieceRecord;

/// One solid piece of a prism. Its own frame has the prism's axes and its centre of mass as origin.
///
/// A view, valid while the Fragments object exists and is not moved: outline, contacts and hulls are computed from the
/// partition on each call, in O(n log n) in the piece's corners.
class Fragment {
public:
    Fragment(const Fragments& all, std::uint32_t index) : m_all(&all), m_index(index) {}

    std::uint32_t seed() const;                         // input index; kNone: no seeds
    std::uint32_t partOfCell() const;                   // see partOfCell(Partition)
    double depth() const;                               // m
    Vec3 offset() const;                                // centre of mass, m: see Fragments::origin
    double volume() const;                              // m³, that of mass()
    MassProperties mass() const;                        // at density 1, transferred mass included; centre (0, 0, 0)
    bool isConvex() const;                              // up to rounding
    Polygon outline() const;                            // the exact piece, m, in the fragment's frame
    std::vector<std::uint32_t> edgeNeighbours() const;  // of each edge, ring after ring: a fragment; kNone: outside
    Polygon cell() const;                               // the piece before a gap was taken off, in the same frame
    std::vector<std::uint32_t> cellNeighbours() const;  // as edgeNeighbours(), of the cell
    std::vector<FragmentContact> contacts() const;      // ascending fragment

    /// The convex hulls that fill the fragment, in its frame: one if its outline is convex, otherwise one per convex
    /// part. Corners on straight sides, or reflex by no more than rounding, are omitted.
    std::vector<Polytope> hulls() const;

    /// The fragments that this is a view of, and its piece there.
    const Fragments& all() const { return *m_all; }
    std::uint32_t piece() const;

private:
    const PieceRecord& record() const;
    std::vector<std::uint32_t> neighboursIn(const Partition& partition) const;

    const Fragments* m_all;
    std::uint32_t m_index;
};

/// Stored properties of a fragment's piece.
struct PieceRecord {
    AreaMoments moments;  // of the exact piece, in the partition's coordinates; `centre` includes transferred mass
    bool isConvex = true;
    bool receivesMass = false;  // of thin pieces
};

/// The mass of a fragment including that of thin pieces; centre (0, 0, 0).
struct AdjustedMass {
    std::uint32_t fragment = 0;
    MassProperties mass;
};

/// The extruded pieces of a partition of a prism's outline. All arrays are flat; use operator[] to read them.
struct Fragments {
    Partition partition;
    std::shared_ptr<const Partition> shrunk;  // the pieces less the gap, some empty: see shrunkPartition(); null: none
    double gap = 0.0;                         // m between pieces; 0: none
    double gapArea = 0.0;                     // m², of all pieces, that the gap removed
    double depth = 0.0;                       // m
    HullTolerance tolerance;                  // of the hulls
    double minSharedEdge = 0.0;               // m: pieces that share less have no contact
    Vec3 origin{0.0, 0.0, 0.0};               // of the prism's frame in that of `Fragment::offset()`, m

    UninitializedVector<PieceRecord> records;            // of each piece; undefined for thin ones
    UninitializedVector<std::uint32_t> pieceOfFragment;  // by seed, then piece
    UninitializedVector<std::uint32_t> fragmentOfPiece;  // of a thin piece, the receiver's; kNone: none
    std::vector<MassTransfer> massTransfers;             // one per thin piece, by seed, then piece
    std::vector<AdjustedMass> adjustedMasses;            // ascending fragment
    // the partition's, then ThinPiece or VanishedPiece and Gap
    std::vector<Diagnostic> diagnostics;

    /// The pieces as extruded.
    const Partition& shapes() const { return shrunk ? *shrunk : partition; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(pieceOfFragment.size()); }
    Fragment operator[](std::uint32_t index) const { return {*this, index}; }
};

}  // namespace rubble
