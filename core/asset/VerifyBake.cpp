#include "core/asset/Bake.h"
#include "core/asset/Breaking.h"
#include "core/fracture/Verify.h"

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

/// The children of one parent: [first, first + count).
struct Siblings {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

std::uint32_t levelBelow(const Bake& bake, std::uint32_t parent) {
    return parent == kNone ? 0 : bake.fragments[parent].level + 1;
}

Siblings childrenOf(const Bake& bake, std::uint32_t parent) {
    if (parent != kNone) return {bake.fragments[parent].firstChild, bake.fragments[parent].childCount};
    Siblings siblings;
    while (siblings.count < bake.fragments.size() && bake.fragments[siblings.count].parent == kNone) ++siblings.count;
    return siblings;
}

/// Breaks a fragment (kNone: the whole) once more, as bake() did.
Result<Breaking> brokenAgain(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    if (parent == kNone) return brokenBy(asset.pattern, asset.prism, {});
    const BakedFragment& fragment = bake.fragments[parent];
    const Pattern& pattern = asset.levels[fragment.level].pattern;
    return brokenBy(patternFor(fragment.id, pattern), {fragment.solid.outline, fragment.solid.depth}, {});
}

Sentence stageFault(const Breaking& breaking) {
    if (Sentence fault = verifyDelaunay(breaking.delaunay, breaking.seeds.positions)) return fault;
    if (Sentence fault = verifyPartition(breaking.partition, breaking.prism.outline)) return fault;
    return verifyNearestSeed(breaking.partition, breaking.seeds.positions);
}

/// The stored siblings with their names and links, as fragments of their parent alone.
Result<Fragments> storedSiblings(const Bake& bake, std::uint32_t parent, const std::vector<std::string>& ids) {
    const Siblings siblings = childrenOf(bake, parent);
    if (siblings.count != ids.size() || siblings.first + std::size_t{siblings.count} > bake.fragments.size()) {
        return Error{ErrorCode::BadInput, "There are " + std::to_string(siblings.count) + " fragments, but " +
                                              std::to_string(ids.size()) + " when it is broken again."};
    }
    Fragments fragments;
    for (std::uint32_t k = 0; k < siblings.count; ++k) {
        const BakedFragment& stored = bake.fragments[siblings.first + k];
        if (stored.id != ids[k] || stored.parent != parent || stored.level != levelBelow(bake, parent)) {
            return Error{ErrorCode::BadInput, "Fragment " + stored.id + " is not the " + ids[k] + " it should be."};
        }
        fragments.fragments.push_back(stored.solid);
        if (parent != kNone) fragments.fragments.back().offset -= bake.fragments[parent].solid.offset;
    }
    return fragments;
}

Sentence breakingFault(const Bake& bake, const Asset& asset, std::uint32_t parent) {
    const Result<Breaking> breaking = brokenAgain(bake, asset, parent);
    if (!breaking) return breaking.error().message;
    if (Sentence fault = stageFault(*breaking)) return fault;
    const std::string parentId = parent == kNone ? std::to_string(bake.asset) : bake.fragments[parent].id;
    const Result<Fragments> stored = storedSiblings(bake, parent, fragmentIds(parentId, *breaking));
    if (!stored) return stored.error().message;
    return verifyFragments(*stored, breaking->prism, breaking->partition.gap);
}

}  // namespace

std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset) {
    const std::string owner = "Asset \"" + asset.name + "\": ";
    if (bake.asset != asset.id || bake.input != bakeInputHash(asset)) {
        return owner + "the bake was made from something else.";
    }
    for (const Polytope& hull : bake.wholeHulls) {
        if (Sentence fault = verifyPolytope(hull)) return owner + "a hull of the whole: " + *fault;
    }
    if (Sentence fault = breakingFault(bake, asset, kNone)) return owner + *fault;
    for (std::uint32_t parent = 0; parent < bake.fragments.size(); ++parent) {
        if (bake.fragments[parent].childCount == 0) continue;
        if (bake.fragments[parent].level >= asset.levels.size()) {
            return owner + "fragment " + bake.fragments[parent].id + " has pieces below the last level.";
        }
        if (Sentence fault = breakingFault(bake, asset, parent)) {
            return owner + "fragment " + bake.fragments[parent].id + ": " + *fault;
        }
    }
    return std::nullopt;
}

}  // namespace rubble
