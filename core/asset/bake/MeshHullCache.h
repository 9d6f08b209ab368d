#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/ClosedMesh.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rubble {

/// The coarseHulls() of the meshes that were asked for last, found by the hashes of the meshes. Usable from several
/// threads.
class MeshHullCache {
public:
    static constexpr std::size_t kMaxMeshes = 8;

    using Hulls = std::shared_ptr<const std::vector<Polytope>>;

    /// In the frame of the mesh. Failures are not kept.
    ///
    /// Errors: those of coarseHulls().
    Result<Hulls> hullsOf(const ClosedMesh& mesh, const TaskContext& task = {});

private:
    Hulls find(const ContentHash& hash);
    void keep(const ContentHash& hash, const Hulls& hulls);

    std::mutex m_mutex;                                 // guards m_kept
    std::vector<std::pair<ContentHash, Hulls>> m_kept;  // the one asked for last at the end
};

}  // namespace rubble
