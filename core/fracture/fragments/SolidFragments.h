#pragma once

#include "core/fracture/planes/SolidGap.h"
#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// What the fragments of a closed mesh are: those of its partition that a gap leaves, with what follows from it.
struct SolidFragments {
    SolidPartition partition;
    std::shared_ptr<const ShrunkSolid> shrunk;  // less the gap, with those that vanish; null: none
    double gapVolume = 0.0;                     // m³, that the gap removed from all together
    std::vector<std::uint32_t> remaining;       // of each fragment, its number in the partition; empty: the same
    std::vector<MassProperties> masses;         // of each fragment, at density 1, relative to the partition's origin
    std::vector<std::vector<Polytope>> hulls;   // of each fragment, relative to its centre of mass
    std::vector<double> hullsCutBack;           // m, of each fragment: see separateHulls()
    std::vector<SolidContact> contacts;         // between fragments before the gap: see contactsOf()
    std::vector<std::uint32_t> firstContact;    // fragments + 1: where those of each start in the next
    std::vector<std::uint32_t> contactsOfFragment;  // indices of contacts, by the other fragment

    std::uint32_t count() const { return static_cast<std::uint32_t>(masses.size()); }
    std::uint32_t numberInPartition(std::uint32_t fragment) const {
        return remaining.empty() ? fragment : remaining[fragment];
    }
    /// The triangles of a fragment before the gap.
    std::size_t triangleCount(std::uint32_t fragment) const;
    /// A fragment less the gap as a mesh of its own, relative to the partition's origin.
    TriangleMesh meshOf(std::uint32_t fragment) const;
};

}  // namespace rubble
