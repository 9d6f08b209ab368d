#include "editor/document/Bakes.h"

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

}  // namespace rubble
