#include "editor/document/Bakes.h"

namespace rubble {

std::shared_ptr<const BakedAsset> Bakes::find(Id asset) const {
    const auto result = m_results.find(asset);
    return result == m_results.end() ? nullptr : result->second;
}

void Bakes::set(Id asset, std::shared_ptr<const BakedAsset> result) {
    m_results[asset] = std::move(result);
    emit changed(asset);
}

void Bakes::remove(Id asset) {
    if (m_results.erase(asset) > 0) emit changed(asset);
}

}  // namespace rubble
