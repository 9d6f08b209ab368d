#include "core/asset/FragmentSets.h"

#include "core/asset/LevelContacts.h"
#include "core/base/Random.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rubble {
namespace {

std::uint32_t endOf(const BakedBreaking& breaking) { return breaking.first + breaking.fragments.count(); }

/// Calls visit(fragment, parent) for all fragments, parents before their pieces.
template <class Visit>
void forEachFragment(const Bake& bake, Visit visit) {
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = breaking.first; k < endOf(breaking); ++k) visit(k, breaking.parent);
    }
}

FragmentSet noFragments(const Bake& bake) { return FragmentSet(bake.fragmentCount(), false); }

}  // namespace

FragmentSet allFragments(const Bake& bake) { return FragmentSet(bake.fragmentCount(), true); }

FragmentSet smallestFragments(const Bake& bake) {
    FragmentSet smallest = allFragments(bake);
    for (const BakedBreaking& breaking : bake.breakings) {
        if (breaking.parent != kNone) smallest[breaking.parent] = false;
    }
    return smallest;
}

FragmentSet fragmentsOfLevel(const Bake& bake, std::uint32_t level) {
    FragmentSet found = noFragments(bake);
    for (const BakedBreaking& breaking : bake.breakings) {
        if (breaking.level == level) std::fill(found.begin() + breaking.first, found.begin() + endOf(breaking), true);
    }
    return found;
}

std::uint32_t levelCount(const Bake& bake) {
    std::uint32_t count = 0;
    for (const BakedBreaking& breaking : bake.breakings) count = std::max(count, breaking.level + 1);
    return count;
}

FragmentSet withPieces(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = set;
    forEachFragment(bake, [&](std::uint32_t fragment, std::uint32_t parent) {
        if (parent != kNone && found[parent]) found[fragment] = true;
    });
    return found;
}

FragmentSet completed(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = withPieces(bake, set);
    // Backwards: pieces are complete before what they are pieces of.
    for (std::size_t k = bake.breakings.size(); k-- > 0;) {
        const BakedBreaking& breaking = bake.breakings[k];
        if (breaking.parent == kNone) continue;
        found[breaking.parent] =
            std::all_of(found.begin() + breaking.first, found.begin() + endOf(breaking), std::identity());
    }
    return found;
}

FragmentSet invertedFragments(const Bake& bake, const FragmentSet& set) {
    const FragmentSet covered = withPieces(bake, set);
    FragmentSet found = smallestFragments(bake);
    for (std::size_t k = 0; k < found.size(); ++k) found[k] = found[k] && !covered[k];
    return found;
}

FragmentSet withNeighbours(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = set;
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
            if (!set[breaking.first + k]) continue;
            for (const Bond& bond : breaking.fragments[k].bonds()) found[breaking.first + bond.fragment] = true;
        }
    }
    for (std::uint32_t level = 1; level < levelCount(bake); ++level) {
        const FragmentSet ofLevel = fragmentsOfLevel(bake, level);
        for (const auto& [one, other] : contactsAcrossParents(bake, level)) {
            if (set[one] && ofLevel[one]) found[other] = true;
            if (set[other] && ofLevel[other]) found[one] = true;
        }
    }
    return found;
}

FragmentSet siblingsOf(const Bake& bake, const FragmentSet& set) {
    FragmentSet found = noFragments(bake);
    for (const BakedBreaking& breaking : bake.breakings) {
        const auto begin = set.begin() + breaking.first, end = set.begin() + endOf(breaking);
        const bool hasAny = std::any_of(begin, end, std::identity());
        std::fill(found.begin() + breaking.first, found.begin() + endOf(breaking), hasAny);
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
    FragmentSet found = smallestFragments(bake);
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
            const double volume = breaking.fragments[k].volume();
            if (!(volume >= least && volume <= most)) found[breaking.first + k] = false;
        }
    }
    return found;
}

FragmentSet randomFragments(const Bake& bake, double share, std::uint64_t randomSeed) {
    const FragmentSet smallest = smallestFragments(bake);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> lots;  // each fragment draws one
    Random random(randomSeed);
    for (std::uint32_t k = 0; k < smallest.size(); ++k) {
        if (smallest[k]) lots.emplace_back(random.next(), k);
    }
    std::ranges::sort(lots);
    lots.resize(static_cast<std::size_t>(std::llround(std::clamp(share, 0.0, 1.0) * static_cast<double>(lots.size()))));
    FragmentSet found = noFragments(bake);
    for (const auto& [lot, fragment] : lots) found[fragment] = true;
    return found;
}

}  // namespace rubble
