#pragma once

#include "core/physics/Body.h"
#include "core/play/PlayAsset.h"

namespace rubble {

enum class PlayRole : std::uint8_t {
    Ground,
    Instance,  // placed by the author, whole
    Missile,   // thrown, whole
    Piece,     // broken off an instance or a missile
};

/// A body of a session. Its number is the order in which bodies came to be; it names it for good, and is its tag in the world.
struct PlayBody {
    std::uint32_t number = 0;
    BodyId body;
    PlayRole role = PlayRole::Instance;
    std::uint32_t origin = 0;                // the instance or shot that it is of: an index in Session::origins()
    std::shared_ptr<const PlayAsset> asset;  // null where it has none: ground, plain missiles
    std::uint32_t fragment = kNone;          // of the asset's bake; kNone: the whole
    std::shared_ptr<const Polytope> hull;    // where it has no asset: what it is, in its own frame
    std::uint64_t born = 0;                  // the step before which it came

    bool isDebris() const { return role == PlayRole::Piece || role == PlayRole::Missile; }
    /// What it breaks into; null where it does not break.
    const PlayBreaking* breaking() const { return asset ? asset->breakingOf(fragment) : nullptr; }
};

/// What was there before anything broke: an instance, or something thrown.
struct PlayOrigin {
    std::string name;
    Id instance = 0;            // 0: the ground, or thrown
    Id asset = 0;               // 0: the ground, or a plain missile
    std::uint32_t variant = 0;  // of the asset
};

/// "front 1.1", or with the id of the piece behind its asset's: "front 1.1/5.17".
std::string nameOf(const PlayBody& body, const PlayOrigin& origin);

/// The exact convex hulls of a body, in its own frame.
std::vector<Polytope> hullsOf(const PlayBody& body);

}  // namespace rubble
