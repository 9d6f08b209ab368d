#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace rubble {

/// When a closed mesh has been split enough.
struct SplitLimits {
    double maxRatio = 1.05;  // of the volume of the hulls of the parts to that of the mesh
    int maxParts = 8;
    int candidates = 4;  // planes of which the best splits a part, >= 1: each costs a cut
};

/// How a closed mesh is split into parts whose hulls exceed it by little: one part, then more with each split. After
/// any number of splits the parts fill the mesh, and lie on different sides of planes.
class ConcaveSplits {
public:
    /// A mesh that is not split yet.
    ///
    /// Errors: those of convexHull().
    static Result<ConcaveSplits> of(TriangleMesh mesh, const SplitLimits& limits);

    /// The limits ask for no more splits, or there is no edge to split it at.
    bool isFinished() const { return m_isFinished; }
    /// Makes one more split, or finds that there is none: of the part with the greatest excess, by a plane through one
    /// of the edges that are deepest below its hull: of several such planes by that with which the hulls exceed the
    /// parts least, for each part more. Not to be called when finished.
    ///
    /// Errors: those of cutSolid() and convexHull(), after which it is finished; Cancelled.
    Status splitOnce(const TaskContext& task);

    double volume() const { return m_volume; }  // m³, of the mesh
    /// The number of splits made, each of which adds one part or more.
    std::size_t splitCount() const { return m_excesses.size() - 1; }
    /// By how much the hulls of the parts after some splits exceed the mesh, m³.
    double excessAfter(std::size_t splits) const { return m_excesses[splits]; }
    /// The number of parts after some splits.
    std::size_t partsAfter(std::size_t splits) const { return m_partCounts[splits]; }
    /// The convex hulls of the parts after some splits.
    ///
    /// Errors: those of convexHull().
    Result<std::vector<Polytope>> hullsAfter(std::size_t splits) const;

private:
    struct Part {
        TriangleMesh mesh;
        double excess = 0.0;     // m³: of the hull over the part
        std::size_t madeBy = 0;  // the split
        std::size_t splitBy = std::numeric_limits<std::size_t>::max();
        bool isFinal = false;  // it is not split
    };

    static Result<Part> partOf(TriangleMesh mesh, std::size_t madeBy);
    Status splitWorst(const TaskContext& task);
    Result<std::vector<Part>> bestSplit(const Part& part, const TaskContext& task) const;
    bool asksForMore() const;

    SplitLimits m_limits;
    bool m_isFinished = false;
    double m_volume = 0.0;
    std::vector<Part> m_parts;
    std::vector<double> m_excesses;         // after each number of splits, m³
    std::vector<std::size_t> m_partCounts;  // after each number of splits
};

}  // namespace rubble
