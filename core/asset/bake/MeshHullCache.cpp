#include "core/asset/bake/MeshHullCache.h"

#include "core/fracture/solid/SolidHulls.h"

#include <algorithm>

namespace rubble {

Result<MeshHullCache::Hulls> MeshHullCache::hullsOf(const ClosedMesh& mesh, const TaskContext& task) {
    constexpr int kCells = 32;
    if (Hulls kept = find(mesh.hash)) return kept;
    Result<std::vector<Polytope>> made = coarseHulls(mesh.mesh, kCells, task);
    if (!made) return made.error();
    const auto hulls = std::make_shared<const std::vector<Polytope>>(std::move(*made));
    keep(mesh.hash, hulls);
    return Hulls(hulls);
}

MeshHullCache::Hulls MeshHullCache::find(const ContentHash& hash) {
    const std::lock_guard lock(m_mutex);
    const auto found = std::ranges::find(m_kept, hash, &std::pair<ContentHash, Hulls>::first);
    if (found == m_kept.end()) return nullptr;
    std::rotate(found, found + 1, m_kept.end());
    return m_kept.back().second;
}

void MeshHullCache::keep(const ContentHash& hash, const Hulls& hulls) {
    const std::lock_guard lock(m_mutex);
    if (m_kept.size() == kMaxMeshes) m_kept.erase(m_kept.begin());
    m_kept.emplace_back(hash, hulls);
}

}  // namespace rubble
