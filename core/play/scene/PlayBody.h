#pragma once

#include "core/physics/world/World.h"
#include "core/play/scene/PlayAsset.h"
#include "core/structure/clusters/ClusterLevels.h"

#include <optional>

namespace rubble {

enum class PlayRole : std::uint8_t {
    Ground,
    Instance,    // whole, placed in the project
    Projectile,  // whole, thrown
    Debris,      // a fragment of an instance or a projectile
};

/// A body of a session. Numbers are given in order of creation and never reused; the number is the body's tag in the
/// world.
struct PlayBody {
    std::uint32_t number = 0;
    BodyId body;
    PlayRole role = PlayRole::Instance;
    std::uint32_t origin = 0;                // its instance or shot: an index in Session::origins()
    std::shared_ptr<const PlayAsset> asset;  // null for the ground and plain projectiles
    std::uint32_t fragment = kNone;          // of the asset's bake; kNone: the whole
    std::shared_ptr<const Polytope> hull;    // without an asset: its hull, in its own frame
    std::uint64_t born = 0;                  // steps done before it was created
    bool isUnbreakable = false;              // its instance never breaks
    std::optional<Vec3> restCentre;          // m: where it was placed, or came to rest last
    std::uint32_t structure = kNone;         // bonded: index in SessionState::structures; kNone: no bond is damaged yet
    std::vector<std::uint32_t> nodes;        // of the structure, ascending: what it consists of; empty: one solid
    bool isHeld = false;                     // bonded: by anchors
    std::uint64_t collapseStep = kNever;     // bonded: in which it loses what has no support
    ClusterLevel heldLevel = kEveryLevel;    // bonded: its bonds of deeper levels hold until heldUntil
    double heldUntil = 0.0;                  // s since the start of the session

    /// Whether it is removed by the rules of Debris: fragments are, also those of a thrown asset; what is whole or held
    /// is not.
    bool isDebris() const { return role == PlayRole::Debris && !isHeld; }
    /// The fragments that replace it; null if it does not break, or breaks along bonds.
    const PlayFracture* fracture() const {
        return canBreak() && !asset->isBonded ? asset->fractureOf(fragment) : nullptr;
    }
    /// The fragments between which its bonds are; null if it has none.
    const PlayFracture* bondedFracture() const {
        return canBreak() && asset->isBonded ? asset->fractureOf(fragment) : nullptr;
    }

    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

private:
    bool canBreak() const { return asset != nullptr && !isUnbreakable && !asset->solid(fragment).neverBreaks; }
};

/// The unbroken solid that bodies come from: an instance or a projectile.
struct PlayOrigin {
    std::string name;
    Id instance = 0;              // 0: the ground, or thrown
    Id asset = 0;                 // 0: the ground, or a plain projectile
    std::uint32_t variant = 0;    // of the asset
    std::optional<Throw> thrown;  // of a plain projectile
};

/// The name of a body: "front 1.1", or with the fragment's path: "front 1.1/5.17", also of a bonded fragment alone that
/// an anchor holds; of several bonded fragments with their number: "front 1.1 (12 fragments)".
std::string nameOf(const PlayBody& body, const PlayOrigin& origin);

/// The name of a fragment that is bonded in a body: "front 1.1/5.17".
std::string fragmentName(const PlayBody& body, const PlayOrigin& origin, std::uint32_t fragment);

/// A body, or some of the fragments that are bonded in it.
struct BodyPart {
    std::uint32_t body = 0;                // its number
    std::vector<std::uint32_t> fragments;  // of its asset's bake, ascending; none: all of the body
    bool operator==(const BodyPart&) const = default;
};

/// Whether a body is some of the fragments of its solid, and not all.
bool isPartial(const PlayBody& body);
/// The fragments of a bonded body, ascending; none if it is one solid.
std::vector<std::uint32_t> fragmentsOf(const PlayBody& body);
/// The fragments between which a body has bonds, ascending, whether or not any bond was damaged yet; none if it is one
/// solid.
std::vector<std::uint32_t> bondedFragments(const PlayBody& body);
/// Where the frame of a body's shape is in its asset's, m; the axes are the same. That of some of the fragments of a
/// solid is the asset's.
Vec3 frameOf(const PlayBody& body);

/// Calls visit(fragment, offset) for each solid that a body looks like: itself, or, where it is some of the fragments
/// of a solid or `isApart`, the fragments that are bonded in it. kNone: the whole. `offset`, m, is that of the solid's
/// frame in the body's.
template <class Visit>
void forEachSolid(const PlayBody& body, bool isApart, const Visit& visit) {
    const bool isWhole = !isApart && !isPartial(body);
    const std::vector<std::uint32_t> fragments = isWhole ? std::vector<std::uint32_t>() : bondedFragments(body);
    if (fragments.empty()) return visit(body.fragment, Vec3(0.0));
    const Vec3 frame = frameOf(body);
    for (const std::uint32_t fragment : fragments) visit(fragment, body.asset->fragments[fragment].offset - frame);
}

/// The asset and fragment that a body is; neither for the ground and plain projectiles.
DiagnosticPlace placeOf(const PlayBody& body);

/// The exact convex hulls of a body, in its own frame.
std::vector<Polytope> hullsOf(const PlayBody& body);

/// The height of a body's highest point in the world, m.
double topHeight(const PlayBody& body, const World& world);

}  // namespace rubble
