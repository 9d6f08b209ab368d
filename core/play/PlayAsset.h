#pragma once

#include "core/asset/Bake.h"
#include "core/physics/ContactSeeds.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A solid that can be a body: the whole of an asset, or one of its fragments.
struct PlayPiece {
    std::shared_ptr<const Shape> shape;  // in its own frame: the prism's for the whole, else a fragment's
    Vec3 offset{0.0, 0.0, 0.0};          // where that frame stands in the prism's, m; the axes are the same
    double toughness = 1.0;              // its threshold is so many times the whole's
    std::uint32_t breaking = kNone;      // what it breaks into, as an index in PlayAsset::breakings; kNone: it does not
};

/// Two fragments that touch, and how, where that was found beforehand.
struct PlayNeighbours {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::vector<ContactSeed> seeds;
};

/// The pieces that one solid breaks into: consecutive fragments of the bake.
struct PlayBreaking {
    std::uint32_t first = 0;
    std::uint32_t count = 0;                 // at least 2
    std::vector<PlayNeighbours> neighbours;  // each pair once
};

/// An asset made ready to be played: the shapes of all that it can become, shared by every body of it.
struct PlayAsset {
    std::shared_ptr<const Bake> bake;  // what the pieces look like
    PlayPiece whole;
    std::vector<PlayPiece> pieces;  // one a fragment of the bake
    std::vector<PlayBreaking> breakings;
    std::vector<std::string> notices;  // sentences about pieces that move as simpler solids than they are

    /// A fragment, or with kNone the whole.
    const PlayPiece& piece(std::uint32_t fragment) const { return fragment == kNone ? whole : pieces[fragment]; }
    /// What it breaks into; null where it does not break.
    const PlayBreaking* breakingOf(std::uint32_t fragment) const;
};

/// How tough a fragment is that has this share of the whole's volume: what breaks is an area.
double toughnessOf(double share);

/// The hulls of the whole where they stand in the prism's frame.
std::vector<Polytope> wholeHullsInPrism(const Bake& bake);

/// When it is found out how the pieces of an asset touch: it takes about as long as their first collision.
enum class FindContacts : std::uint8_t { Beforehand, WhenItBreaks };

/// The whole of a baked asset alone, as if it never broke: what its intents ask of it needs no more. The same as below.
Result<PlayAsset> playWhole(const Asset& asset, std::shared_ptr<const Bake> bake);

/// Makes a baked asset ready. A solid with more corners than simulation takes moves as the hull of its farthest ones, one too
/// thin as a box around it, each with the mass of the exact piece; a notice tells of either. A fragment is as tough as its
/// share of the whole's volume to the power of 2/3, see toughnessOf().
///
/// Errors: BadInput where the whole cannot be a body at all, with the asset's name; Cancelled.
Result<std::shared_ptr<const PlayAsset>> playAsset(const Asset& asset, std::shared_ptr<const Bake> bake,
                                                   const TaskContext& task = {},
                                                   FindContacts when = FindContacts::Beforehand);

}  // namespace rubble
