#pragma once

#include "core/base/UninitializedVector.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/pieces/HullParts.h"
#include "core/fracture/pieces/MassTransfer.h"
#include "core/geometry/hull/MassProperties.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

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

/// What a prism's fragments are: the extruded pieces of a partition of its outline.
struct ExtrudedPieces {
    Partition partition;
    std::shared_ptr<const Partition> shrunk;  // the pieces less the gap, some empty: see shrunkPartition(); null: none
    double gapArea = 0.0;                     // m², of all pieces, that the gap removed
    double depth = 0.0;                       // m
    HullTolerance tolerance;                  // of the hulls
    double minSharedEdge = 0.0;               // m: pieces that share less have no contact

    UninitializedVector<PieceRecord> records;            // of each piece; undefined for thin ones
    UninitializedVector<std::uint32_t> pieceOfFragment;  // by seed, then piece
    UninitializedVector<std::uint32_t> fragmentOfPiece;  // of a thin piece, the receiver's; kNone: none
    std::vector<MassTransfer> massTransfers;             // one per thin piece, by seed, then piece
    std::vector<AdjustedMass> adjustedMasses;            // ascending fragment

    /// The pieces as extruded.
    const Partition& shapes() const { return shrunk ? *shrunk : partition; }
};

}  // namespace rubble
