#pragma once

#include "core/play/PlayAsset.h"

#include <string>
#include <vector>

namespace rubble {

// What a clean swap keeps within.
inline constexpr double kCleanSpeed = 1e-3;       // m/s: the fastest piece after kAuditSteps, nothing pushing
inline constexpr double kCleanLyingSpeed = 1e-2;  // m/s: the same of an asset that lies flat under gravity
inline constexpr double kCleanOverlap = 1e-6;     // m
inline constexpr double kCleanDrift = 1e-5;       // of mass, momenta and energy in a step of single precision
inline constexpr int kAuditSteps = 30;            // of 1/60 s

/// A piece and how fast it is.
struct PieceSpeed {
    std::string piece;   // its id
    double speed = 0.0;  // m/s, of its fastest corner
};

/// How far a swap of an asset for its pieces is from changing anything by itself.
struct SwapAudit {
    std::uint32_t pieces = 0;  // those that the whole breaks into, and the levels below
    int contacts = 0;          // pairs of pieces that touch right after the swap of the whole
    int contactPoints = 0;
    double deepestOverlap = 0.0;  // m: of two exact pieces then
    PieceSpeed resting;           // the fastest piece after kAuditSteps without any force, after those of each level
    double restingEnergy = 0.0;   // J, kinetic, of all pieces at that moment; the whole had none
    PieceSpeed lying;        // the fastest after kAuditSteps of an asset that lies flat on the ground under gravity
    double massDrift = 0.0;  // relative, in the swap of an asset that flies and turns; this and the following
    double momentumDrift = 0.0;
    double angularDrift = 0.0;
    double energyGain = 0.0;           // negative where some was lost
    double gapShare = 0.0;             // of the volume, that the gap between pieces takes: so much of all that may go
    std::vector<std::string> notices;  // pieces that move as simpler solids than they are
    std::vector<std::string> faults;   // what is not within the limits and what to change, as sentences

    bool isClean() const { return faults.empty(); }
};

/// Measures swaps by no force, in sessions of one instance of an asset: floating at rest, lying flat on the ground, and
/// flying as it turns. It measures what it is that breaks, so the project's preset of damage, its debris and its gravity
/// have no part in it; gravity is 9.81 m/s^2 for what lies.
///
/// Errors: NotFound where the asset breaks into nothing; those of playScene().
Result<SwapAudit> swapAudit(const Project& project, const std::shared_ptr<const PlayAsset>& asset);

}  // namespace rubble
