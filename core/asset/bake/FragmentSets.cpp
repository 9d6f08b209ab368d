#include "core/asset/bake/FragmentSets.h"

#include "core/asset/bake/NeighboursAcrossParents.h"
#include "core/base/Random.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rubble {
namespace {

std::uint32_t endOf(const BakedFracture& fracture) { return fracture.first + fracture.fragments.count(); }

/// Calls visit(fragment, parent) for all fragments, parents before their children.
template <class Visit>
void forEachFragment(const Bake& bake, Visit visit) {
    for (const BakedFracture& fracture : bake.fractures) {
        for (std::uint32_t k = fracture.first; k < endOf(fracture); ++k) visit(k, fracture.parent);
    }
}

FragmentSet noFragments(const Bake& bake) { return FragmentSet(bake.fragmentCount(), false); }

}  // namespace

FragmentSet allFragments(const Bake& bake) { return FragmentSet(bake.fragmentCount(), true); }

FragmentSet leafFragments(const Bake& bake) {
    FragmentSet leaves = allFragments(bake);
    for (const BakedFracture& fracture : bake.fractures) {
        if (fracture.parent != kNone) leaves[fracture.parent] = false;
    }
    return leaves;
}

FragmentSet fragmentsOfLevel(const Bake& bake, std::uint32_t level) {
    FragmentSet found = noFragments(bake);
    for (const BakedFracture& fracture : bake.fractures) {
        if (fracture.level == level) std::fill(found.begin() + fracture.first, found.begin() + endOf(fracture), true);
    }
    return found;
}

std::uint32_t levelCount(const Bake& bake) {
    std::uint32_t count = 0;
    for (const BakedFracture& fracture : bake.fractures) count = std::max(count, fracture.level + 1);
    return count;
}

FragmentSet withDescendants(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = set;
    forEachFragment(bake, [&](std::uint32_t fragment, std::uint32_t parent) {
        if (parent != kNone && found[parent]) found[fragment] = true;
    });
    return found;
}

FragmentSet completed(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = withDescendants(bake, set);
    // In reverse: children before their parents.
    for (std::size_t k = bake.fractures.size(); k-- > 0;) {
        const BakedFracture& fracture = bake.fractures[k];
        if (fracture.parent == kNone) continue;
        found[fracture.parent] =
            std::all_of(found.begin() + fracture.first, found.begin() + endOf(fracture), std::identity());
    }
    return found;
}

std::vector<std::uint32_t> rootsOf(const Bake& bake, const FragmentSet& set) {
    std::vector<std::uint32_t> roots;
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        std::uint32_t ancestor = bake.fragment(k).parent;
        while (ancestor != kNone && !set[ancestor]) ancestor = bake.fragment(ancestor).parent;
        if (ancestor == kNone) roots.push_back(k);
    }
    return roots;
}

FragmentSet invertedFragments(const Bake& bake, const FragmentSet& set) {
    const FragmentSet covered = withDescendants(bake, set);
    FragmentSet found = leafFragments(bake);
    for (std::size_t k = 0; k < found.size(); ++k) found[k] = found[k] && !covered[k];
    return found;
}

FragmentSet withNeighbours(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = set;
    for (const BakedFracture& fracture : bake.fractures) {
        for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
            if (!set[fracture.first + k]) continue;
            for (const FragmentContact& contact : fracture.fragments[k].contacts())
                found[fracture.first + contact.fragment] = true;
        }
    }
    for (std::uint32_t level = 1; level < levelCount(bake); ++level) {
        const FragmentSet ofLevel = fragmentsOfLevel(bake, level);
        for (const auto& [one, other] : neighboursAcrossParents(bake, level)) {
            if (set[one] && ofLevel[one]) found[other] = true;
            if (set[other] && ofLevel[other]) found[one] = true;
        }
    }
    return found;
}

FragmentSet siblingsOf(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = noFragments(bake);
    for (const BakedFracture& fracture : bake.fractures) {
        const auto begin = set.begin() + fracture.first, end = set.begin() + endOf(fracture);
        const bool hasAny = std::any_of(begin, end, std::identity());
        std::fill(found.begin() + fracture.first, found.begin() + endOf(fracture), hasAny);
    }
    return found;
}

FragmentSet parentsOf(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = noFragments(bake);
    forEachFragment(bake, [&](std::uint32_t fragment, std::uint32_t parent) {
        if (parent != kNone && set[fragment]) found[parent] = true;
    });
    return found;
}

FragmentSet childrenOf(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = noFragments(bake);
    forEachFragment(bake, [&](std::uint32_t fragment, std::uint32_t parent) {
        if (parent != kNone && set[parent]) found[fragment] = true;
    });
    return found;
}

FragmentSet fragmentsOfVolume(const Bake& bake, double least, double most) {
    FragmentSet found = leafFragments(bake);
    for (const BakedFracture& fracture : bake.fractures) {
        for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
            const double volume = fracture.fragments[k].volume();
            if (!(volume >= least && volume <= most)) found[fracture.first + k] = false;
        }
    }
    return found;
}

FragmentSet randomFragments(const Bake& bake, double fraction, std::uint64_t randomSeed) {
    const FragmentSet leaves = leafFragments(bake);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;  // one per leaf
    Random random(randomSeed);
    for (std::uint32_t k = 0; k < leaves.size(); ++k) {
        if (leaves[k]) keys.emplace_back(random.next(), k);
    }
    std::ranges::sort(keys);
    keys.resize(
        static_cast<std::size_t>(std::llround(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(keys.size()))));
    FragmentSet found = noFragments(bake);
    for (const auto& [key, fragment] : keys) found[fragment] = true;
    return found;
}

}  // namespace rubble
