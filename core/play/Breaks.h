#pragma once

#include "core/play/MovingMass.h"
#include "core/play/PlayBody.h"

#include <span>

namespace rubble {

/// A body that breaks in this step, and by what.
struct PlayBreak {
    std::uint64_t step = 0;  // the first is 1
    PlayBody body;           // as it was
    double impact = 0.0;     // N s: the damage that was done to it
    double threshold = 0.0;  // N s
    Vec3 point{0.0, 0.0, 0.0};
    Vec3 normal{0.0, 0.0, 0.0};    // from what hit it into the body
    BodyId striker;                // 0 where nothing of the world hit it: hammers, blasts
    std::uint32_t firstPiece = 0;  // the number of its first piece; the others follow
    std::uint32_t pieces = 0;
    Pose pose;                               // of the whole's frame, as it broke
    std::shared_ptr<const PlayAsset> asset;  // that its pieces are of: its own, or one cut where it was hit
    double milliseconds =
        0.0;  // of wall-clock time that the swap took; the only thing here that differs from run to run
};

/// A body about to be swapped: its break, and its mass as it moves on.
struct PendingBreak {
    PlayBreak told;
    double restitution = 0.0;  // of the pair
    Pose pose;                 // of the whole's frame
    MovingMass mass;           // as if nothing held it
};

/// Lets strikers pay for what they break, in order: each gives the whole an impulse of its threshold, or as much as still stops
/// their approach where that is less, and loses it. Of two that break each other, each is the other's striker.
void payForBreaks(World& world, std::span<PendingBreak> breaks);

}  // namespace rubble
