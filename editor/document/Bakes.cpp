#include "editor/document/Bakes.h"

#include <algorithm>

namespace rubble {

std::shared_ptr<const BakedAsset> Bakes::find(Id asset) const {
    const auto result = m_results.find(asset);
    return result == m_results.end() ? nullptr : result->second;
}

std::shared_ptr<const BakedPattern> Bakes::findPattern(Id asset) const {
    const auto pattern = m_patterns.find(asset);
    return pattern == m_patterns.end() ? nullptr : pattern->second;
}

void Bakes::set(Id asset, std::shared_ptr<const BakedAsset> result) {
    m_results[asset] = std::move(result);
    emit changed(asset);
}

void Bakes::setPattern(Id asset, std::shared_ptr<const BakedPattern> pattern) {
    m_patterns[asset] = std::move(pattern);
    emit patternChanged(asset);
}

void Bakes::remove(Id asset) {
    if (m_patterns.erase(asset) > 0) emit patternChanged(asset);
    if (m_results.erase(asset) > 0) emit changed(asset);
}

void Bakes::clear() {
    while (!m_patterns.empty()) remove(m_patterns.begin()->first);
    while (!m_results.empty()) remove(m_results.begin()->first);
}

AssetBakes bakesOf(const Bakes& bakes) {
    AssetBakes all;
    for (const auto& [asset, baked] : bakes.all()) {
        if (baked->bake) all.emplace(asset, baked->bake);
    }
    return all;
}

bool areCurrent(const Bakes& bakes, const Project& project) {
    return std::ranges::all_of(project.assets, [&](const Asset& asset) {
        const std::shared_ptr<const BakedAsset> baked = bakes.find(asset.id);
        return baked && *baked->asset == asset;
    });
}

}  // namespace rubble
