#pragma once

#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/Polytope.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// What the fragments of a closed mesh are: those of its partition, with what follows from it.
struct SolidFragments {
    SolidPartition partition;
    std::vector<MassProperties> masses;        // of each fragment, at density 1, relative to the partition's origin
    std::vector<std::vector<Polytope>> hulls;  // of each fragment, relative to its centre of mass
    std::vector<SolidContact> contacts;        // see contactsOf()
    std::vector<std::uint32_t> firstContact;   // fragments + 1: where those of each start in the next
    std::vector<std::uint32_t> contactsOfFragment;  // indices of contacts, by the other fragment
};

}  // namespace rubble
