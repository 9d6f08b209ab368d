#pragma once

#include "core/base/Index.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

enum class Severity { Note, Warning, Error };

/// The kind of a diagnostic. Lists are sorted in this order.
enum class DiagnosticCode {
    FaultyOutline,      // the outline crosses or touches itself, or is too narrow to be fractured
    DuplicateSeed,      // equal to an earlier seed, which is kept
    SeedWithoutCell,    // its cell lies outside the outline or is thinner than rounding
    LostOverride,       // a manual change to a seed that does not exist
    LostPiece,          // a merge, split or setting of a piece that does not exist
    LooseCut,           // a cut that ends within a piece or does not separate it
    NoRoom,             // a scatter placed fewer seeds than requested
    NeedsPlane,         // a layer of a pattern that has no effect on a mesh
    Gap,                // area that no piece covers
    ThinPiece,          // too thin for a hull; its mass is transferred to a neighbour
    VanishedPiece,      // narrower than the gap between pieces, in whole or in part
    Sliver,             // an elongated fragment
    TinyPiece,          // much smaller than its siblings
    ManyHulls,          // concave, so that it needs many convex hulls for collision
    UnknownStrength,    // a threshold cannot be derived from the material's strength
    SplitCell,          // the outline cuts a cell into several pieces
    MergedPiece,        // too small; merged into a neighbour
    DroppedSeed,        // its cell was too small
    SimplifiedShape,    // collides with a simpler shape than it has
    OverlappingPieces,  // right after they replace the whole
    PushedPiece,        // moves after it has replaced the whole, although nothing hit it
    SwapDrift,          // replacing the whole changes mass, momentum or energy
    GapVolume,          // mass that the gap between pieces removes
    CloseHulls,         // exported hulls are so close that other engines push them apart
    UnappliedInput,     // an input of a session, or the impulse of a hit, had no effect, or not all of it
    PatternFallback,    // a body broke into the fragments of its pattern instead of at the impact
    LeftWorld,          // a body was removed, or a fragment not added: it cannot be simulated where or as fast as it is
    ReplayMismatch,     // a step differs from the recording
    RepeatedPoint,      // of an outline in a file: equal to the one before, which is kept
    IdleMortar,         // joins nothing that is anchored
    BeyondSpan,         // bonded fragments that are farther from an anchor than the span before anything is hit
    WeakBonds,          // bonds or mortar that take less than the weight that hangs on them before anything is hit
    ImporterName,       // of a material of an export: an importer acts upon its ending
    LongName,           // of an export: another program cuts it
    LongPath,           // of a file of an export: another system cannot open it
    ManyHullCorners,    // of a hull of an export: an engine does not take it, or simulates it slowly
};
inline constexpr int kDiagnosticCodes = 36;

/// The code's name in JSON, messages and lists: "DuplicateSeed".
const char* nameOf(DiagnosticCode code);
/// FaultyOutline is an error; what an artist requested, or only needs to know, is a note; everything else is a warning.
Severity defaultSeverity(DiagnosticCode code);

/// The subject of a diagnostic. Members that do not apply keep their defaults.
struct DiagnosticPlace {
    /// A point in the asset's plane, m.
    struct Point {
        double x = 0.0;
        double y = 0.0;
        bool operator==(const Point&) const = default;
    };

    std::uint32_t asset = 0;                    // id
    std::uint32_t level = 0;                    // of the pattern; 0: the asset's own
    std::uint32_t fragment = kNone;             // its number in the bake
    std::string path;                           // of the fragment: unlike the number it outlasts the bake
    std::vector<std::uint32_t> fragments = {};  // all of the bake, where it is one of several
    std::uint32_t layer = 0;                    // id
    std::uint32_t index = kNone;                // of a seed or cut in that layer
    std::uint32_t seed = kNone;                 // index among the seeds of one fracture
    std::uint32_t otherSeed = kNone;            // the seed that is kept, or whose piece receives another one
    std::optional<Point> point;
    bool operator==(const DiagnosticPlace&) const = default;
};

/// One finding about an asset, in any stage from its outline to its play.
struct Diagnostic {
    DiagnosticCode code = DiagnosticCode::FaultyOutline;
    Severity severity = Severity::Warning;
    DiagnosticPlace place;
    std::string message;  // one sentence that names the place
    /// The measured value: m² for Gap, ThinPiece, MergedPiece, DroppedSeed and VanishedPiece; m for LooseCut,
    /// OverlappingPieces, CloseHulls and BeyondSpan; seeds for NoRoom; aspect ratio for Sliver; m³ for TinyPiece and
    /// for Gap and VanishedPiece of a mesh; hulls for ManyHulls; N·s for UnknownStrength; N for WeakBonds; m/s for
    /// PushedPiece; points for RepeatedPoint; bytes for LongName and LongPath; corners for ManyHullCorners; relative
    /// to that of the whole for SwapDrift and GapVolume.
    double value = 0.0;
    double limit = 0.0;  // of the value; 0: none
    bool operator==(const Diagnostic&) const = default;
};

/// A diagnostic of default severity.
Diagnostic diagnostic(DiagnosticCode code, DiagnosticPlace place, std::string message, double value = 0.0,
                      double limit = 0.0);

}  // namespace rubble
