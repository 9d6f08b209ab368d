#include "core/asset/project/FragmentLevels.h"

#include <algorithm>

namespace rubble {

const Level* levelFor(const Asset& asset, const FragmentPath& fragment, std::uint32_t level) {
    const auto leaf = std::ranges::lower_bound(asset.fragmentLevels, fragment, {}, &FragmentLevel::fragment);
    if (leaf != asset.fragmentLevels.end() && leaf->fragment == fragment) return leaf->level ? &*leaf->level : nullptr;
    return level < asset.levels.size() ? &asset.levels[level] : nullptr;
}

}  // namespace rubble
