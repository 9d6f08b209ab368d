#pragma once

#include "core/asset/bake/Bake.h"
#include "core/physics/narrowphase/ManifoldCache.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A solid that can be a body: the whole of an asset, or one of its fragments.
struct PlaySolid {
    std::shared_ptr<const Shape> shape;  // in its own frame: the prism's for the whole, else the fragment's
    Vec3 offset{0.0, 0.0, 0.0};          // m, of that frame in the prism's; the axes are the same
    double thresholdScale = 1.0;         // its threshold relative to the whole's, unless it has one
    std::optional<double> threshold;     // N·s, that is set for it
    std::uint32_t fracture = kNone;      // index in PlayAsset::fractures; kNone: it does not break
    bool neverBreaks = false;            // though it has a fracture
};

/// Two neighbouring fragments and, if precomputed, their contact manifolds.
struct PlayContact {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::vector<CachedManifold> manifolds;
};

/// The fragments that replace one solid: consecutive in the bake.
struct PlayFracture {
    std::uint32_t first = 0;
    std::uint32_t count = 0;              // at least 2
    double area = 0.0;                    // m²: of the faces that their cracks open, of both sides
    std::vector<PlayContact> neighbours;  // each pair once
    // Of a bonded asset: all fragments together, with the mass of what they replace, and the first hull of each of them
    // in it, with one beyond the last.
    std::shared_ptr<const Shape> bonded;
    std::vector<std::uint32_t> firstHull;

    std::uint32_t hullCount(std::uint32_t node) const { return firstHull[node + 1] - firstHull[node]; }
};

/// An asset prepared for play: the shapes of everything it can become, shared by all of its bodies.
struct PlayAsset {
    std::shared_ptr<const Bake> bake;
    PlaySolid whole;
    std::vector<PlaySolid> fragments;  // one per fragment of the bake
    std::vector<PlayFracture> fractures;
    bool isBonded = false;                // its solids break along bonds instead of as a whole
    std::vector<Diagnostic> diagnostics;  // SimplifiedShape; LostPiece of thresholds

    /// A fragment; kNone: the whole.
    const PlaySolid& solid(std::uint32_t fragment) const { return fragment == kNone ? whole : fragments[fragment]; }
    /// The fragments that replace it; null if it does not break.
    const PlayFracture* fractureOf(std::uint32_t fragment) const;
};

/// The centre of mass of a solid in its asset's frame, m.
Vec3 centreInAsset(const PlaySolid& solid);

/// The threshold of a solid where that of the whole is `whole`, N·s.
double thresholdOf(const PlaySolid& solid, double whole);

/// The hulls of the whole in the prism's frame.
std::vector<Polytope> wholeHullsInPrism(const Bake& bake);

/// The time when the contacts between fragments are computed, which takes about as long as their first collision.
enum class FindContacts : std::uint8_t { InAdvance, OnBreak };

/// Prepares the whole of a baked asset without its fragments, which is enough for strength requirements.
///
/// Errors: as below.
Result<PlayAsset> wholePlayAsset(const Asset& asset, std::shared_ptr<const Bake> bake);

/// Prepares a baked asset. A solid with too many corners gets the hull of its extreme ones as its shape, one that is
/// too thin its bounding box, each with the mass of the exact solid and a diagnostic. `wholeShape`: the shape of the
/// whole if it is known, else it is made.
///
/// Errors: BadInput if the whole cannot be a body, with the asset's name; Cancelled.
Result<std::shared_ptr<const PlayAsset>> playAsset(const Asset& asset, std::shared_ptr<const Bake> bake,
                                                   const TaskContext& task = {},
                                                   FindContacts when = FindContacts::InAdvance,
                                                   std::shared_ptr<const Shape> wholeShape = nullptr);

}  // namespace rubble
