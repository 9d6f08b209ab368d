#pragma once

#include "core/base/Index.h"
#include "core/geometry/Vec.h"

#include <cstdint>
#include <string>

namespace rubble {

/// What fracture did that its user should know, though it could go on.
enum class ReportCode {
    DuplicateSeed,    // equal to an earlier seed, which stays
    SeedWithoutCell,  // its cell lies outside the outline, or is thinner than coordinates can tell
    SplitCell,        // the outline cuts the cell into several pieces
    ThinPiece,        // too thin for a hull; its mass went to a neighbour
    LostOverride,     // an override names a seed that is not there
    NoRoom,           // a scatter found fewer places than it was asked for
    Gap,              // area that no piece covers
    MergedPiece,      // too small; it went into a neighbour
    DroppedSeed,      // its cell was too small
    LostPiece,        // a piece that is to be merged, split or broken again is not there
    VanishedPiece,    // narrower than the gap between pieces, in whole or in part
    LooseCut,         // a cut ends within a piece, or does not part it in two
};

/// The code's name as it stands in JSON and in messages: "DuplicateSeed".
const char* nameOf(ReportCode code);

/// One such notice. Indices are those of the input.
struct Report {
    ReportCode code;
    std::uint32_t seed = kNone;  // whom it is about; LostOverride, DroppedSeed: its number in its layer
    std::uint32_t of = kNone;    // the other seed, where there is one; LostOverride, DroppedSeed: the layer's id
    double amount = 0.0;         // m^2 of Gap, ThinPiece, MergedPiece, DroppedSeed, VanishedPiece; m of LooseCut
    std::string message;         // one sentence
};

}  // namespace rubble
