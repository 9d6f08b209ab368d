#include "core/base/Diagnostic.h"

#include <array>
#include <utility>

namespace rubble {

const char* nameOf(DiagnosticCode code) {
    static constexpr std::array kNames = {"FaultyOutline",   "DuplicateSeed",     "SeedWithoutCell",
                                          "LostOverride",    "LostPiece",         "LooseCut",
                                          "NoRoom",          "NeedsPlane",        "Gap",
                                          "ThinPiece",       "VanishedPiece",     "Sliver",
                                          "TinyPiece",       "ManyHulls",         "UnknownStrength",
                                          "SplitCell",       "MergedPiece",       "DroppedSeed",
                                          "SimplifiedShape", "OverlappingPieces", "PushedPiece",
                                          "SwapDrift",       "GapVolume",         "CloseHulls",
                                          "UnappliedInput",  "PatternFallback",   "LeftWorld",
                                          "ReplayMismatch",  "RepeatedPoint",     "IdleMortar",
                                          "BeyondSpan",      "WeakBonds",         "ImporterName",
                                          "LongName",        "LongPath",          "ManyHullCorners"};
    static_assert(kNames.size() == kDiagnosticCodes);
    return kNames[static_cast<std::size_t>(code)];
}

Severity defaultSeverity(DiagnosticCode code) {
    switch (code) {
        case DiagnosticCode::FaultyOutline: return Severity::Error;
        case DiagnosticCode::Gap:
        case DiagnosticCode::SplitCell:
        case DiagnosticCode::MergedPiece:
        case DiagnosticCode::DroppedSeed:
        case DiagnosticCode::SimplifiedShape:
        case DiagnosticCode::GapVolume:
        case DiagnosticCode::CloseHulls:
        case DiagnosticCode::RepeatedPoint: return Severity::Note;
        default: return Severity::Warning;
    }
}

Diagnostic diagnostic(DiagnosticCode code, DiagnosticPlace place, std::string message, double value, double limit) {
    return {code, defaultSeverity(code), std::move(place), std::move(message), value, limit};
}

}  // namespace rubble
