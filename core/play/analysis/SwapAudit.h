#pragma once

#include "core/play/scene/PlayAsset.h"

#include <string>
#include <vector>

namespace rubble {

// The limits of a clean swap.
inline constexpr double kCleanSpeed = 1e-3;       // m/s: of the fastest fragment after kAuditSteps without forces
inline constexpr double kCleanLyingSpeed = 1e-2;  // m/s: on average, for a prism lying flat under gravity
inline constexpr double kCleanOverlap = 1e-6;     // m
inline constexpr double kCleanDrift = 1e-5;       // relative, of mass, momenta and energy in a step of single precision
inline constexpr double kEngineGap = 2e-5;        // m: engines push hulls apart that are closer, see docs/engines.md
inline constexpr int kAuditSteps = 30;            // of 1/60 s

/// A fragment and its speed.
struct FragmentSpeed {
    std::string fragment;  // its id
    DiagnosticPlace place;
    double speed = 0.0;  // m/s: at least that of its fastest corner, an upper bound
};

/// A fragment and how far its exported hulls are from those of its nearest neighbour.
struct FragmentGap {
    std::string fragment;  // its id; empty: nothing touches
    DiagnosticPlace place;
    double gap = 0.0;  // m
};

/// The changes of mass and motion that swapping an asset for its fragments causes by itself.
struct SwapAudit {
    std::uint32_t fragments = 0;  // of all levels
    int contacts = 0;             // pairs of touching fragments right after the swap of the whole
    int contactPoints = 0;
    double deepestOverlap = 0.0;  // m: of two exact fragments then
    FragmentSpeed resting;        // the fastest fragment, kAuditSteps after the swap of any level, without forces
    double restingEnergy = 0.0;   // J: kinetic energy of all then, of the level with the most; the whole had none
    FragmentSpeed lying;          // the fastest on average from its swap to kAuditSteps, lying flat on the ground; no
                                  // fragment: of a closed mesh, whose fragments fall then
    double massDrift = 0.0;       // this and the following: relative, for an asset that flies and rotates
    double momentumDrift = 0.0;
    double angularDrift = 0.0;
    double energyGain = 0.0;   // negative: a loss
    double gapFraction = 0.0;  // of the volume, removed by the gap between fragments: so much may be lost
    FragmentGap exported;      // the least: the gap and both insets, kDefaultInset or, of thin hulls, what they allow
    /// Notes: SimplifiedShape, GapVolume and CloseHulls. Then warnings, the violated limits with what to change:
    /// OverlappingPieces, PushedPiece and SwapDrift.
    std::vector<Diagnostic> diagnostics;

    /// Whether no limit is violated.
    bool isClean() const;
};

/// Measures swaps in sessions with one instance of an asset: without forces, floating at rest, and flying and rotating;
/// and, if it is a prism, lying flat on the ground. The project's damage preset, debris and gravity are not used;
/// gravity on the ground is 9.81 m/s². A bonded asset is measured as if all of its bonds broke at once.
///
/// Errors, with the asset's name: NotFound if it has no fragments; Degenerate if it leaves the world before it breaks;
/// those of Session::start() and Session::add(); Cancelled.
Result<SwapAudit> swapAudit(const Project& project, const std::shared_ptr<const PlayAsset>& asset,
                            const TaskContext& task = {});
/// The same, of an asset of the project with its bake.
///
/// Errors: as above; those of playAsset().
Result<SwapAudit> swapAudit(const Project& project, const std::shared_ptr<const Bake>& bake, const TaskContext& task);

}  // namespace rubble
