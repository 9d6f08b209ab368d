#pragma once

#include "core/asset/AssetBakes.h"
#include "core/base/TaskContext.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// What an artist should look at. The first one keeps an asset from being broken; the others are told of one that was.
enum class ProblemKind {
    FaultyOutline,    // the outline crosses or touches itself, or is too narrow to be cut
    DuplicateSeed,    // equal to an earlier seed, which stays
    SeedWithoutCell,  // its cell lies outside the outline
    LostOverride,     // a change by hand to a seed that is not there any more
    LostPiece,        // a piece that is merged, split or broken by hand and is not there any more
    LooseCut,         // a stretch of a cut that parts nothing
    NoRoom,           // a scatter found fewer places than it was asked for
    Gap,              // area that no piece covers
    ThinPiece,        // too thin for a hull; its mass went to a neighbour
    VanishedPiece,    // narrower than the gap between pieces, in whole or in part
    Sliver,           // many times as long as wide
    TinyPiece,        // much smaller than the pieces it was made with
    ManyHulls,        // so bent that it takes many convex hulls to collide
    UnknownStrength,  // the threshold is to follow from a strength that the material does not tell
};
inline constexpr int kProblemKinds = 14;

/// "Sliver", as it stands in messages and lists.
const char* nameOf(ProblemKind kind);

/// From where on something is a problem.
struct ProblemLimits {
    double aspect = 6.0;      // slivers are more than so many times as long as wide; scattered pieces seldom are
    double meanShare = 0.02;  // tiny pieces have less than this share of the mean volume of those made with them
    std::uint32_t hulls = 8;  // each costs a collision as much as another body
    bool operator==(const ProblemLimits&) const = default;
};

/// One thing to look at: what, where and how bad.
struct Problem {
    ProblemKind kind = ProblemKind::Sliver;
    Id asset = 0;
    std::optional<SeedId> seed;      // of the asset's own pattern: that it is about, or that its fragment comes from
    Id layer = 0;                    // that found no room; 0: it is about none
    std::uint32_t level = 0;         // of the pattern that it comes from; 0: the asset's own
    std::uint32_t fragment = kNone;  // in the bake, where it is about one
    FragmentPath path;               // that one's name, which outlasts the bake
    std::optional<Vec2> where;       // m, in the asset's plane
    double value = 0.0;              // how bad: the figure
    double limit = 0.0;              // and its limit; 0 where it has none
    std::string message;             // one sentence with name, figure and limit

    /// How many times beyond its limit it is, at least 1; infinite where nothing can be made of the asset.
    double badness() const;
};

/// What keeps an outline from being cut, fault by fault.
std::vector<Problem> outlineProblems(const Asset& asset);

/// What is to be looked at in an asset as it was baked, in the order of ProblemKind, then of seeds and fragments. Cells that
/// the outline cuts apart are none: windows do that. O(corners · log corners of a piece) on task.threads.
std::vector<Problem> problemsOf(const Asset& asset, const Bake& bake, const ProblemLimits& limits = {},
                                const TaskContext& task = {});

/// What is to be looked at in an asset whatever it is broken into: a threshold that cannot be derived.
std::vector<Problem> strengthProblems(const Asset& asset, const Material& material);

/// Of all assets, in the project's order: of their bakes where they have one, else of their outlines, and of their strength.
std::vector<Problem> problemsOf(const Project& project, const AssetBakes& bakes, const ProblemLimits& limits = {},
                                const TaskContext& task = {});

/// One mark a fragment of a bake: at least one of the problems is about it.
std::vector<bool> fragmentsWithProblems(const Bake& bake, std::span<const Problem> problems);

}  // namespace rubble
