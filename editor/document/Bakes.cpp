#include "editor/document/Bakes.h"

#include <algorithm>

namespace rubble {

std::shared_ptr<const BakedAsset> Bakes::find(Id asset) const {
    const auto result = m_results.find(asset);
    return result == m_results.end() ? nullptr : result->second;
}

AssetBakes Bakes::assetBakes() const {
    AssetBakes all;
    for (const auto& [asset, baked] : m_results) {
        if (baked->bake) all[{asset}] = baked->bake;
        for (const auto& [variant, bake] : baked->variants) all[{asset, variant}] = bake;
    }
    return all;
}

bool Bakes::areCurrent(const Project& project) const {
    return std::ranges::all_of(usedVariants(project), [&](const AssetVariant& used) {
        const std::shared_ptr<const BakedAsset> baked = find(used.asset);
        if (!baked || !(*baked->asset == *findAsset(project, used.asset))) return false;
        return used.variant == 0 || baked->fault || baked->variants.contains(used.variant);
    });
}

std::shared_ptr<const BakedPattern> Bakes::findPattern(Id asset, const FragmentPath& parent) const {
    if (!parent.empty()) {
        return m_fragmentPattern && m_fragmentPattern->asset->id == asset && m_fragmentPattern->parent == parent
                   ? m_fragmentPattern
                   : nullptr;
    }
    const auto pattern = m_patterns.find(asset);
    return pattern == m_patterns.end() ? nullptr : pattern->second;
}

void Bakes::set(Id asset, std::shared_ptr<const BakedAsset> result) {
    m_results[asset] = std::move(result);
    emit changed(asset);
}

void Bakes::setPattern(Id asset, std::shared_ptr<const BakedPattern> pattern) {
    (pattern->parent.empty() ? m_patterns[asset] : m_fragmentPattern) = std::move(pattern);
    emit patternChanged(asset);
}

void Bakes::remove(Id asset) {
    if (m_fragmentPattern && m_fragmentPattern->asset->id == asset) m_fragmentPattern.reset();
    if (m_patterns.erase(asset) > 0) emit patternChanged(asset);
    if (m_results.erase(asset) > 0) emit changed(asset);
}

void Bakes::clear() {
    while (!m_patterns.empty()) remove(m_patterns.begin()->first);
    while (!m_results.empty()) remove(m_results.begin()->first);
}

}  // namespace rubble

#include "moc_Bakes.cpp"
